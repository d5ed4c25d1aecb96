"""Questions to the specification: which events may come after a log, and why others may not.

:class:`s7check.asking.session.Session` is the interface for programs. It knows no rule: every answer is evaluated in
spec/ by the engine.
"""
