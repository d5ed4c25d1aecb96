"""``python -m evidence.models``: the same as ``s7check models``."""

from evidence.models.command import models_command

if __name__ == "__main__":
    models_command(prog_name="python -m evidence.models")
