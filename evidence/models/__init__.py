"""``s7check models``: runs TLC on the models of the manifest and fails on any drift.

- ``distributed``: TLC's distributed mode
- ``canaries``: the known defects of the TLC at hand
- ``update``: rewriting pinned counts
- ``report``: the output
- ``command``: the command
"""
