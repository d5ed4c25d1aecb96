"""The sources of ``s7check import``, each read by a module of its own.

- ``step7_text``, ``szl``: the diagnostic buffer as text and as bytes
- ``entry``, ``diagnostics``, ``modes``: an entry of it; entries to events
- ``csv_rows``: CSV with a column map
- ``ring_layout``, ``ring``: the ring that the SCL instrumentation writes
- ``live``: the CPU itself, through python-snap7
- ``bcd``, ``hex_text``, ``start_info``: DATE_AND_TIME, bytes written as digits, the start information of an OB
"""
