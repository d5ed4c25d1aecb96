"""``s7check import``: from the records of a CPU or a program to a log of ``s7-interrupt-log/1``.

The engine reads the diagnostic buffer and CSV. The ring is read here into ``Recording``, events with the place they
come from; facts that a source does not tell stay unrecorded.

- ``errors``: the one exception
- ``recording``: the events of any source
- ``sources``: the readers of the sources
- ``elapsed``: elapsed time from counters
- ``asking``: what the engine makes of a source
- ``options``, ``command``: the command line
"""
