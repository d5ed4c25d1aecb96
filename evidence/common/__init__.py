"""Shared by several tools and independent of TLA+ and TLC: the terminal, processes, reasons, logs, options."""
