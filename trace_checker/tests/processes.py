"""Processes that tests start."""

import signal
from pathlib import Path


def heed_ctrl_c() -> None:
    """For ``preexec_fn``: a shell that runs the tests in the background has its children ignore SIGINT."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def children(pid: int) -> list[int]:
    """The processes that the threads of a process have started."""
    return [int(child) for task in Path(f"/proc/{pid}/task").glob("*/children") for child in task.read_text().split()]
