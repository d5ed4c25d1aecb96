"""``s7check migrate``: what a CPU of a newer family would not show of a log, and what to do in the program.

- ``table``: the differences MD-nn, a text of docs/rules
- ``walk``: the log, line by line, on both CPUs
- ``command``, ``as_html``: the command and its page
"""
