"""Behaviours of System that TLC has found, as logs."""
