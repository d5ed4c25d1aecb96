"""The differences between CPUs, editions and readings: found by search, kept with their programs, shown as pages."""
