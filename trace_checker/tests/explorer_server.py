"""The explorer's server in a thread, for tests."""

import socket
import threading
from collections.abc import Iterator
from contextlib import contextmanager

import uvicorn

from s7check.engine.client import Engine
from s7check.exploring.library import Library
from s7check.exploring.server import application

TOKEN = "secret"  # noqa: S105 (of a server that lives as long as a test)


@contextmanager
def served(library: Library) -> Iterator[str]:
    """The address of a running explorer, up to its token."""
    with Engine() as engine, socket.create_server(("127.0.0.1", 0)) as listening:
        server = uvicorn.Server(
            uvicorn.Config(application(engine, library, TOKEN), log_level="error", timeout_graceful_shutdown=1)
        )
        thread = threading.Thread(target=server.run, kwargs={"sockets": [listening]})
        thread.start()
        try:
            yield f"http://127.0.0.1:{listening.getsockname()[1]}"
        finally:
            server.should_exit = True
            thread.join()
