"""The steps of the explorer beside the edges of the graphs that TLC exports."""
