"""TLA+ text: the one reader of modules, and what the tools ask of a tree."""
