"""The release, which wheels, reports and results name."""

__version__ = "0.1.0"
