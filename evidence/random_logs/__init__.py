"""Logs drawn from a seed: random programs on the soft PLC, as they are or damaged."""
