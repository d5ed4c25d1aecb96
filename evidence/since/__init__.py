"""``s7check since``: does this checkout give the results of an earlier revision?

- ``revision``: the earlier revision, built in a work tree of its own
- ``judging``: the verdicts of a checkout about logs, by its own command
- ``pins``: the pinned results and the reasons of a checkout
- ``compare``: two checkouts side by side
- ``report``: the output
- ``command``: the command
"""
