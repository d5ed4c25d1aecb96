"""Logs by the thousand: do the verdicts of the trace checker hold?

- ``random_logs``, ``setups``, ``damage``, ``drop``: logs drawn from a seed, as they are, damaged, kinds left out
- ``agree``, ``tlc_batch``: engine and TLC on the same logs
- ``graph``, ``explored``: the explorer's steps beside the edges of graphs that TLC exports
- ``left_out_command``: accepted logs without kinds of event
- ``growth_logs``, ``growth_costs``: logs that leave much open, and what they cost
- ``since``, ``revision``, ``since_judging``, ``pins``: this checkout beside an earlier revision
"""
