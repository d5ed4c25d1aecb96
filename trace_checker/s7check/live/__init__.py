"""``s7check watch``: the log of a running CPU, judged as it comes.

- ``connection``: what is read of the CPU; nothing is ever written
- ``tail``: what is new in the ring and the diagnostic buffer, in one order, and where something is missing
- ``log``: a log that grows: its file, its verdict, what must come
- ``watch``: logs one after the other
- ``view``, ``command``: the terminal, the command line

Beside it ``lane`` and ``driver``: adapters that run the programs of the kit on a CPU, which they stop and write to.
"""
