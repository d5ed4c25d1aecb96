"""Which logs the arguments of a call mean."""

from collections.abc import Iterable
from pathlib import Path

from s7check.log.source import ENDINGS


def logs_of(arguments: Iterable[str]) -> list[str]:
    """The files that the arguments mean, in their order.

    A folder stands for the logs in it and in the folders below, a pattern with ``*``, ``?`` or ``**``
    for the files that it fits. What means no file stays as it is: to open it will fail, and say why.
    """
    return [name for argument in arguments for name in _meant(argument) or [argument]]


def _meant(argument: str) -> list[str]:
    try:
        path = Path(argument)
        if path.is_dir():
            return sorted(str(file) for file in path.rglob("*") if file.name.endswith(ENDINGS) and file.is_file())
        if set("*?[") & set(argument) and not path.exists():
            import glob

            found = glob.iglob(argument, recursive=True)  # noqa: PTH207 - the pattern may be absolute
            return sorted(name for name in found if Path(name).is_file())
    except (OSError, ValueError):
        pass  # such as a name with a NUL
    return []
