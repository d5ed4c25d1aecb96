"""How the commands end that run Java for long."""

import os
import signal
import subprocess
import sys

import pytest

from evidence.common.processes import Processes
from evidence.common.session import INTERRUPTED, NO_TOOLS, USAGE, session


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_signals(number: signal.Signals, capsys: pytest.CaptureFixture[str]) -> None:
    """A signal ends the command as Ctrl-C does, and afterwards it has its old meaning."""
    before = signal.getsignal(number)
    processes = Processes()
    with pytest.raises(SystemExit) as ended, session(processes, (), (), "interrupted, sorry"):
        os.kill(os.getpid(), number)
    assert ended.value.code == INTERRUPTED
    assert capsys.readouterr().err == "interrupted, sorry\n"
    assert processes.closed
    assert signal.getsignal(number) is before


def test_errors(capsys: pytest.CaptureFixture[str]) -> None:
    """An error that is named becomes a sentence and an exit code; another one goes on."""
    for error, code in ((ValueError("this file"), USAGE), (OSError("no Java"), NO_TOOLS)):
        with pytest.raises(SystemExit) as ended, session(Processes(), (ValueError,), (OSError,)):
            raise error
        assert ended.value.code == code
        assert str(error) in capsys.readouterr().err
    with pytest.raises(KeyError), session(Processes(), (ValueError,), (OSError,)):
        raise KeyError


def test_without_sighup() -> None:
    """Windows has no SIGHUP."""
    program = (
        "import signal; del signal.SIGHUP\n"
        "from evidence.common.processes import Processes\n"
        "from evidence.common.session import session\n"
        "with session(Processes(), (), ()): print('here')"
    )
    run = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert run.stdout == "here\n"
