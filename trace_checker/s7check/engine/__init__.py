"""The engine, a Java process that evaluates the specification: finding it, asking it, its answers."""
