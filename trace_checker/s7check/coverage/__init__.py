"""Which rules of the specification logs exercise.

- ``measure``: the coverage of a log, and of several together
- ``report``: text, JSON and HTML
- ``command``: ``s7check coverage``
"""

from s7check.coverage.measure import Coverage, Guard, measure

__all__ = ["Coverage", "Guard", "measure"]
