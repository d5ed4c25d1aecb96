"""The models of ``models/models.txt``: the result that each must have, and running them.

- ``manifest``: the manifest's format, its checks, and the models it resolves to
- ``runner``: which models run when, each on a copy, and the second run that names a violated property
- ``judge``: the result of a run against its pins, and new pins
- ``models_report``: the output
- ``distributed``: TLC's distributed mode
- ``canaries``: the known defects of the TLC at hand
- ``models_command``: the command
- ``proofs``: the proofs by Apalache
"""
