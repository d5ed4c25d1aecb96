"""The models of ``models/models.txt``: the result that each must have, and running them.

- ``entries``: the notation of the files
- ``manifest``: their checks, and the models that they resolve to
- ``runner``: which models run when, each on a copy, and the second run that names a violated property
- ``judge``: the result of a run against its pins, and new pins
- ``unchanged``: what a result depends on, and which models came as pinned
- ``models_report``: the output
- ``distributed``: TLC's distributed mode
- ``canaries``: the known defects of the TLC at hand
- ``models_command``: the command
- ``proofs``: the proofs by Apalache
"""
