"""Tests of the tools that give evidence."""
