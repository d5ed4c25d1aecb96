"""Tests of the model-checking harness."""
