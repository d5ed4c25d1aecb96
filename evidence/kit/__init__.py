"""The conformance kit: making its programs, what they reach, and the faults that they find.

- ``calls``, ``calendar``, ``meetings``, ``nesting``, ``paths``, ``shipped``, ``waiting``: programs by kind
- ``building``, ``covering``: what these kinds share
- ``files``: the files of programs
- ``reached``, ``reached_findings``: which rules the kit reaches
"""
