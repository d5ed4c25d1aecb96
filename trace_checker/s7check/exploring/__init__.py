"""The explorer: a page on the loopback address on which a behaviour is built event by event.

:mod:`s7check.exploring.desk` answers the page's questions by a :class:`s7check.asking.session.Session`. Nothing here or
in the page knows a rule.
"""
