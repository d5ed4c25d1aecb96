"""``s7check import``: from the records of a CPU or a program to a log of ``s7-interrupt-log/1``.

Each source is read by a module of its own into ``Recording``, events with the place they come
from; facts that a source does not tell stay unrecorded.

- ``errors``: the one exception
- ``recording``: what every source gives
- ``bcd``: DATE_AND_TIME
- ``hex_text``: bytes written as digits
- ``start_info``: the start information of an OB by its bytes
- ``entry``: an entry of the diagnostic buffer
- ``diagnostics``, ``modes``: entries to events
- ``step7_text``, ``szl``: the diagnostic buffer as text and as bytes
- ``csv_rows``: CSV with a column map
- ``ring_layout``, ``elapsed``, ``ring``: the ring that the SCL instrumentation writes
- ``live``: the CPU itself, through python-snap7
- ``header``, ``log_text``: header, the whole log checked
- ``options``, ``command``: the command line
"""
