"""Errors of sources that the check cannot read."""


class UnreadableError(Exception):
    """A source is missing, is of another form, or holds nothing; the text names it."""
