"""``s7check`` with the fake engine as a process of its own: ``run_with_fake_engine.py [ARGUMENT...]``."""

import sys
from unittest import mock

from s7check.cli import main
from s7check.engine.client import Engine
from tests.conftest import FAKE_ENGINE

if __name__ == "__main__":
    command = [sys.executable, str(FAKE_ENGINE)]
    with mock.patch("s7check.engine.pool.Engine", side_effect=lambda: Engine(lambda: command)):
        sys.exit(main())
