"""Which formula, property, model and logs each requirement has: ``s7spec views requirements``."""
