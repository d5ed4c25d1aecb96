"""The plugin for pytest: the fixture ``s7_log``, and files ``*.s7.ndjson`` as tests."""

from __future__ import annotations

import re
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from s7check import Line, Report

ENDINGS = (".s7.ndjson", ".s7.ndjson.gz")
"""How the names of logs end that are tests."""

_LOG = pytest.StashKey["S7Log"]()


class S7Log:
    """The events of a test: feed the header first; the log is checked at the end of the test."""

    def __init__(self, path: Path) -> None:
        self._lines: list[Line] = []
        self.path = path
        """Where the log is written to before it is checked."""

    def feed(self, line: Line) -> None:
        r"""Takes the next line: its fields or its text, which may have several lines with ``\n`` between them."""
        self._lines.append(line)

    def _check(self) -> Report | str:
        """The report, or why there is none."""
        from s7check.api import check, encoded

        if not self._lines:
            return "s7_log: expected a header and events; the test has fed none"
        self.path.write_bytes(b"".join(encoded(line).removesuffix(b"\n") + b"\n" for line in self._lines))
        return check(self.path)


@pytest.fixture
def s7_log(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> S7Log:
    """Records the events of the test, ``s7_log.feed({...})``; the test fails if no S7 CPU may behave like that."""
    name = re.sub(r"\W+", "_", request.node.name)[:60]
    log = S7Log(tmp_path_factory.mktemp("s7_log") / f"{name}{ENDINGS[0]}")
    request.node.stash[_LOG] = log
    return log


@pytest.hookimpl(wrapper=True)
def pytest_runtest_call(item: pytest.Item) -> Generator[None, Any, Any]:
    """Checks the log of a test that has passed; where it has failed the report stands beside the failure."""
    try:
        result = yield
    except Exception:
        if text := _complaint(item):
            item.add_report_section("call", "s7_log", text)
        raise
    if text := _complaint(item):
        pytest.fail(text, pytrace=False)
    return result


def _complaint(item: pytest.Item) -> str:
    log = item.stash.get(_LOG, None)
    if log is None:
        return ""
    found = log._check()
    if isinstance(found, str):
        return found
    return "" if found.verdict == "accepted" else str(found)


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """A file ``*.s7.ndjson`` is a test."""
    return _LogFile.from_parent(parent, path=file_path) if file_path.name.endswith(ENDINGS) else None


class _LogFile(pytest.File):
    def collect(self) -> Iterator[pytest.Item]:
        yield _LogItem.from_parent(self, name="s7check")


class _LogItem(pytest.Item):
    def runtest(self) -> None:
        from s7check import NotAcceptedError, check

        report = check(self.path)
        if report.verdict != "accepted":
            raise NotAcceptedError(report)

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], *_: object) -> Any:
        from s7check import NotAcceptedError

        return str(excinfo.value) if isinstance(excinfo.value, NotAcceptedError) else super().repr_failure(excinfo)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        return self.path, None, self.path.name
