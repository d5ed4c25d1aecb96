"""Changes of the specification that its checks have to notice, and conditions that its checks have to meet.

Mutants:

- ``operators``: the kinds of change
- ``listing``: all mutants of a specification
- ``checks``: the checks that can kill a mutant: a model, the shipped logs
- ``against_logs``: the shipped logs judged by a mutated specification, as a process of its own
- ``against_kit``: the logs of the kit judged by mutated specifications
- ``findings``: the result of a check on a mutant, and the kept results
- ``order``: which check is likely to kill at least cost
- ``bench``: a mutant before its checks
- ``survivors``: ``models/survivors.json``, why a mutant survives

Witnesses:

- ``conditions``: the expressions of the specification that need a witness
- ``logs_model``: a model of the shipped logs
- ``witnesses``: models run on a copy of the specification that reports these expressions
"""
