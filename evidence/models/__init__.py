"""The models of ``models/manifest.json``: the result that each must have, and running them.

- ``manifest``: the manifest's format, its checks, and the models it resolves to
- ``copies``: the temporary copy of ``spec/`` and ``models/`` that a run works on
- ``runner``: which models run when, and the second run that names a violated property
- ``judge``: the result of a run against its pins
- ``progress``, ``models_report``: the output
- ``distributed``: TLC's distributed mode
- ``canaries``: the known defects of the TLC at hand
- ``update``: rewriting pinned counts
- ``models_command``: the command
- ``proofs``: the proofs by Apalache
"""
