"""Situations of the requirements, each in several CPUs, with logs that are right and logs that are wrong."""
