"""TLC as a process: its configuration files, its messages, marks that it tells, logs as modules for it."""
