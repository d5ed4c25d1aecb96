"""``s7check faults``: does the kit find the deliberate faults of the soft PLC?"""
