"""Waiting for several file descriptors at a time."""

import sys

if sys.platform == "win32":
    import _winapi
    import msvcrt
    import time

    _PAUSE = 0.01

    def readable(*fds: int) -> list[int]:
        """The ``fds`` that can be read without waiting; blocks while there are none.

        Windows has no ``select`` for pipes: they are asked again and again.
        """
        while not (ready := [fd for fd in fds if _has_input(fd)]):
            time.sleep(_PAUSE)
        return ready

    def _has_input(fd: int) -> bool:
        try:
            return bool(_winapi.PeekNamedPipe(msvcrt.get_osfhandle(fd), 0)[0])
        except OSError:
            # A file, or a pipe at its end.
            return True

else:
    import select

    def readable(*fds: int) -> list[int]:
        """The ``fds`` that can be read without waiting; blocks while there are none."""
        return select.select(fds, [], [])[0]
