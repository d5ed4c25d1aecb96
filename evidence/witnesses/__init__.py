"""``s7check witnesses``: no rule and no property is checked in vain.

`conditions` finds the expressions of the specification that need a witness, `logs` makes a model of the shipped logs,
`collect` runs the models on a copy of the specification that reports them, `report` shows the result, `command` is the
command.
"""
