"""The conformance kit: making its programs, what they reach, and the faults that they find.

- ``calls``, ``calendar``, ``meetings``, ``nesting``, ``paths``, ``shipped``, ``waiting``: programs by kind
- ``building``, ``covering``: what these kinds share
- ``programs``: all of them; ``kept_paths`` and ``measured``: the data in ``kit/`` that TLC and the soft PLC found
- ``files``: how these files are read and written
- ``reached``, ``reached_findings``: which rules the kit reaches
"""
