"""``python -m trace_checker.models``: the same as ``s7check models``."""

from trace_checker.models.command import models_command

if __name__ == "__main__":
    models_command(prog_name="python -m trace_checker.models")
