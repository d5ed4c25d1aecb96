"""Mutation of the specification: does what checks ``spec/`` notice a small change of it?

The modules, each with one concern:

- ``syntax``: modules as syntax trees, and changing a piece of text so that everything else keeps its column
- ``operators``: the kinds of change
- ``listing``: all mutants of a specification, with ids that unrelated edits do not alter
- ``reach``: the modules that a check is built on
- ``marks``: which expressions a model evaluates
- ``findings``: what a check came to on a mutant, and the findings that are kept
- ``checks``: what can kill a mutant: a model, the shipped logs
- ``logs``: the shipped logs judged by a mutated specification, as a process of its own
- ``order``: which check is likely to kill at least cost
- ``bench``: a mutant before its checks
- ``reasons``: ``models/survivors.json``, why a mutant survives
- ``report``: what the user sees
- ``command``: ``s7check mutants``
"""
