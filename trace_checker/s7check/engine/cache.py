"""Where a user's programs keep files that they can make again."""

import os
import sys
from pathlib import Path


def cache_folder() -> Path:
    """The folder, which need not exist."""
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local") / "s7check"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "s7check"
