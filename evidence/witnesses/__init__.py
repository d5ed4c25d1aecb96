"""``s7check witnesses``: no rule and no property is checked in vain.

`conditions` finds in the specification what has to be witnessed, `logs` makes a model of the shipped logs, `collect`
runs the models on a copy of the specification that tells what it meets, `report` shows it, `command` is the command.
"""
