"""Limits of this process (``ulimit``) that are too small for the engine's JVM."""

import sys

_HANDLES = 16
_GIGABYTE = 1024**3
_SPACE = 4 * _GIGABYTE
"""Bytes of address space: the JVM reserves 3 GB, most of which it never uses."""

if sys.platform == "win32":

    def advice() -> str:
        """Empty: Windows has no such limits."""
        return ""

else:
    import resource

    def advice() -> str:
        """Which limits to raise; empty if none of them is too small."""
        handles, space = (resource.getrlimit(what)[0] for what in (resource.RLIMIT_NOFILE, resource.RLIMIT_AS))
        parts = []
        if 0 <= handles < _HANDLES:
            parts.append(f"allow {_HANDLES} open files or more, ulimit -n; found {handles}")
        if 0 <= space < _SPACE:
            found = f"{space / _GIGABYTE:.1f} GB"
            parts.append(f"allow {_SPACE // _GIGABYTE} GB of address space or more, ulimit -v; found {found}")
        return "; ".join(parts)
