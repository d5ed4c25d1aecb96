"""The verdict about a log: reading it, asking the engine line by line, other readings, steps for a timeline."""
