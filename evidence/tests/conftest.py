"""What `make setup` builds, for all tests: the engine and TLC. Where they are missing the tests fail."""

from collections.abc import Iterator

import pytest

from evidence.tla.tlc import Toolchain, find_toolchain
from s7check.engine.client import Engine


@pytest.fixture(scope="session")
def engine() -> Iterator[Engine]:
    """An engine for all tests that need no own."""
    with Engine() as one:
        yield one


@pytest.fixture(scope="session")
def tools() -> Toolchain:
    """TLC."""
    return find_toolchain(None)
