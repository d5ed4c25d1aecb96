"""``s7check reached``: which rules of the specification does the kit reach?

`measuring` runs the kit on the soft PLC in all its ways, `findings` says what of it was to be reached, `command` is the
command.
"""
