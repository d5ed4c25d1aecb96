"""Waiting for several file descriptors at a time."""

import sys

if sys.platform == "win32":
    import _winapi
    import msvcrt
    import time

    _PAUSE = 0.01

    def readable(*fds: int, seconds: float | None = None) -> list[int]:
        """The ``fds`` that can be read without waiting; blocks while there are none, for ``seconds`` at most.

        Windows has no ``select`` for pipes: they are asked again and again.
        """
        until = None if seconds is None else time.monotonic() + seconds
        while not (ready := [fd for fd in fds if _has_input(fd)]):
            if until is not None and time.monotonic() > until:
                break
            time.sleep(_PAUSE)
        return ready

    AT_ONCE = 512

    def writable(_fd: int, seconds: float) -> bool:
        """Whether there is time left to write: Windows does not tell whether a pipe has room."""
        return seconds > 0

    def _has_input(fd: int) -> bool:
        try:
            return bool(_winapi.PeekNamedPipe(msvcrt.get_osfhandle(fd), 0)[0])
        except OSError:
            # A file, or a pipe at its end.
            return True

else:
    import select

    AT_ONCE = select.PIPE_BUF
    """Bytes that a pipe takes without blocking if it is writable."""

    def readable(*fds: int, seconds: float | None = None) -> list[int]:
        """The ``fds`` that can be read without waiting; blocks while there are none, for ``seconds`` at most."""
        return select.select(fds, [], [], None if seconds is None else max(0, seconds))[0]

    def writable(fd: int, seconds: float) -> bool:
        """Whether ``fd`` takes bytes within ``seconds``."""
        return bool(select.select([], [fd], [], max(0, seconds))[1])
