"""``python -m s7check``: the same as the command ``s7check``."""

import sys

from s7check.cli import main

if __name__ == "__main__":
    sys.exit(main())
