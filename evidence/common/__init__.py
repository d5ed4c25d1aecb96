"""What several tools share that has nothing to do with TLA+ or TLC: the terminal, processes, reasons, logs, options."""
