"""``s7check import``: from the records of a CPU or a program to a log of ``s7-interrupt-log/1``.

Each source is read by a module of its own into ``Recording``, events with the place they come
from; facts that a source does not tell stay unrecorded.

- ``errors``: the one exception
- ``recording``: the events of any source
- ``sources``: the readers of the sources
- ``kinds``: which kind of source a file is
- ``elapsed``: elapsed time from counters
- ``header``, ``log_text``: header, the whole log checked
- ``options``, ``command``: the command line
"""
