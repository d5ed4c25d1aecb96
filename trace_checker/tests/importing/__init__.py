"""Tests of ``s7check import``."""
