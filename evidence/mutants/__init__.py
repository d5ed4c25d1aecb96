"""``s7check mutants``: do the checks of ``spec/`` notice a small change of it?

- ``operators``: the kinds of change
- ``listing``: all mutants of a specification
- ``marks``: which mutants change an expression that a model evaluates
- ``findings``: what a check came to on a mutant, and the findings that are kept
- ``checks``: what can kill a mutant: a model, the shipped logs
- ``logs``: the shipped logs judged by a mutated specification, as a process of its own
- ``order``: which check is likely to kill at least cost
- ``bench``: a mutant before its checks
- ``reasons``: ``models/survivors.json``, why a mutant survives
- ``report``: what the user sees
- ``command``: the command
"""
