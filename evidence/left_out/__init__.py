"""Kinds of event left out of accepted logs: does any log get worse?"""
