"""``s7check cases``: the cases of traces/ written out as logs."""
