"""``s7check`` with the fake engine as a process of its own: ``run_with_fake_engine.py [ARGUMENT...]``."""

import sys
from unittest import mock

from trace_checker.cli import main
from trace_checker.engine_client import Engine
from trace_checker.tests.conftest import FAKE_ENGINE

if __name__ == "__main__":
    engine = Engine(lambda: [sys.executable, str(FAKE_ENGINE)])
    with mock.patch("trace_checker.trace_command.Engine", return_value=engine):
        sys.exit(main())
