"""``python -m trace_checker``: the same as the command ``s7check``."""

import sys

from trace_checker.cli import main

if __name__ == "__main__":
    sys.exit(main())
