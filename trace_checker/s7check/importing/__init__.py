"""``s7check import``: from the records of a CPU or a program to a log of ``s7-interrupt-log/1``.

The engine reads the sources, whose bytes come from here.

- ``errors``: the one exception
- ``asking``: what the engine makes of a source
- ``sources``: the text of CSV, the CPU itself
- ``options``, ``command``: the command line
"""
