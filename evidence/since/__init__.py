"""``s7check since``: does this checkout give the results of an earlier revision?

- ``revision``: the earlier revision, built in a work tree of its own
- ``judging``: the verdicts of a checkout about logs, by its own command
- ``pins``: what a checkout pins of its models, and its reasons
- ``compare``: two checkouts side by side
- ``report``: what the user sees
- ``command``: the command
"""
