"""What the check cannot read."""


class UnreadableError(Exception):
    """A source is missing, is not what it should be, or holds nothing; the text names it."""
