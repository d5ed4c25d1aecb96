"""A log told in sentences."""
