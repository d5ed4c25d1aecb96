"""``python -m evidence``: the same as the command ``s7spec``."""

import sys

from evidence.cli import main

if __name__ == "__main__":
    sys.exit(main())
