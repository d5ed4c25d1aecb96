"""The sources of ``s7check import``, each read by a module of its own.

- ``csv_text``: the text of CSV in UTF-8
- ``ring_layout``, ``ring``: the ring that the SCL instrumentation writes
- ``live``: the CPU itself, through python-snap7
- ``bcd``, ``hex_text``: DATE_AND_TIME, bytes written as digits
"""
