"""Reading of ``s7-interrupt-log/1``: from bytes to normalised events, or to one clear error.

Nothing here knows the rules of an S7; it knows the form of a line.

- ``errors``: the one exception, and how values are quoted in it
- ``source``: files, gzip and standard input as chunks of bytes
- ``encoding``: chunks in UTF-8, whatever the byte order mark
- ``lines``: chunks to numbered physical lines
- ``jsonline``: a line to a JSON object, stricter than JSON
- ``values``: the spellings of words, durations, dates
- ``fields``: objects by tables of fields
- ``tables``: numbers of OBs, priority classes, letters of readings
- ``header``, ``events``: the tables of the format
- ``elapsed``: the two clocks of a log
- ``reader``: all of it together
"""
