"""The models of ``models/manifest.json``: the result that each must have, and running them.

- ``manifest``: the manifest's format, its checks, and the models it resolves to
- ``mutate``: the temporary copy of ``spec/`` and ``models/`` that a run works on
- ``judge``: the result of a run against its pins
- ``runner``: which models run when, and the second run that names a violated property
- ``progress``: the display while models run
"""
