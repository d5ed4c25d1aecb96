"""The gallery: edge cases, each the shortest behaviour that TLC finds for a predicate, as a log."""
