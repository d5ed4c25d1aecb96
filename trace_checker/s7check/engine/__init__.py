"""The engine, a process that evaluates the specification: finding it, asking it, its answers."""
