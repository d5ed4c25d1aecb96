"""Checks recorded runs of an S7-300/400 CPU, and the models of its specification."""

__version__ = "0.1.0"
