"""The model-checking harness: runs TLC on the models of ``models/manifest.json`` and fails on any drift.

The modules, each with one concern:

- ``manifest``: the manifest's format, its checks, and the models it resolves to
- ``cfg``: reading and editing TLC's configuration files
- ``mutate``: the temporary copy of ``spec/`` and ``models/`` that a run works on
- ``messages``: what TLC said, by the message codes of its ``-tool`` output
- ``tlc``: finding and running TLC
- ``judge``: what came against what is pinned
- ``runner``: which models run when, and the second run that names a violated property
- ``distributed``: TLC's distributed mode
- ``canaries``: the known defects of the TLC at hand
- ``update``: rewriting pinned counts
- ``report``: what the user sees
- ``command``: ``s7check models``
"""
