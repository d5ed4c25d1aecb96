"""Checks recorded runs of an S7-300/400 CPU against the specification of its interrupt functions.

``check`` judges a log, ``Checker`` the events of a program while it runs; docs/checking/python.md describes both.
"""

from typing import TYPE_CHECKING

from s7check.version import __version__

__all__ = ["Checker", "Line", "NotAcceptedError", "Reading", "Report", "Verdict", "__version__", "check"]

if TYPE_CHECKING:
    from s7check.api import Checker, Line, NotAcceptedError, check
    from s7check.report.report import Reading, Report, Verdict
else:

    def __getattr__(name: str) -> object:
        # The command line does without the API, and begins sooner.
        if name not in __all__:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        from s7check import api

        return getattr(api, name)
