"""Logs written by hand from the requirements alone, in a shorthand."""
