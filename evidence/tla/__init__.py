"""TLA+ text and TLC: reading modules, running TLC on them, and its behaviours as logs.

- ``syntax``, ``modules``, ``names``, ``actions``, ``binding``, ``flatten``: modules as syntax trees
- ``tlc``, ``resident``, ``cfg``, ``messages``: a run of TLC
- ``marks``: which expressions TLC evaluates
- ``log_as_tla``, ``behaviour``, ``values``: logs for TLC, and behaviours that TLC found as logs
"""
