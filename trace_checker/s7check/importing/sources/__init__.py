"""The bytes of sources that are more than a file.

- ``csv_text``: the text of CSV in UTF-8
- ``live``: the CPU itself, through python-snap7
"""
