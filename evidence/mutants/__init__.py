"""``s7check mutants``: do the checks of ``spec/`` notice a small change of it?

- ``operators``: the kinds of change
- ``listing``: all mutants of a specification
- ``marks``: which mutants change an expression that a model evaluates
- ``findings``: the result of a check on a mutant, and the kept results
- ``checks``: the checks that can kill a mutant: a model, the shipped logs
- ``logs``: the shipped logs judged by a mutated specification, as a process of its own
- ``order``: which check is likely to kill at least cost
- ``bench``: a mutant before its checks
- ``reasons``: ``models/survivors.json``, why a mutant survives
- ``report``: the output
- ``command``: the command
"""
