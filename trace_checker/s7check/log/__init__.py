"""Logs, ``s7-interrupt-log/1``, on the way to the engine, which reads them.

- ``errors``: the one exception, and how texts are told in it
- ``source``: files, gzip and standard input as chunks of bytes
- ``encoding``: chunks in UTF-8, whatever the byte order mark
- ``profile_file``: the file that a header names as its profile
- ``chosen``: what takes the place of a header's choices
- ``objects``: lines as JSON objects
- ``calls``, ``values``: the calls, times
"""
