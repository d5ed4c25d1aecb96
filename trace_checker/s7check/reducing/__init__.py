"""``s7check reduce``: the smallest log that is rejected for the same reason.

- ``candidate``: a log in pieces, and the question whether it is still rejected alike
- ``reduction``: fewer lines, a shorter header, rounder values
- ``command``: the command
"""
