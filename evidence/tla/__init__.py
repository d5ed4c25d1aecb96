"""TLA+ text: the only reader of modules, and questions that several tools put to a syntax tree."""
