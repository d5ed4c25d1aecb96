"""The plugin for pytest, in a pytest of its own."""

import pytest

from tests.logs import RUN, event, log_text

pytest_plugins = "pytester"

ACCEPTED = log_text(event("DIS_AIRT", ret=1), header=RUN)
REJECTED = log_text(event("EN_AIRT", ret=0), header=RUN)


def _test(feeding: str, after: str = "pass") -> str:
    return f"def test_plc(s7_log):\n    {feeding}\n    {after}\n"


def test_a_log_that_is_accepted(pytester: pytest.Pytester) -> None:
    """The test passes; the log is a file."""
    pytester.makepyfile(_test(f"s7_log.feed({RUN!r}); s7_log.feed({event('DIS_AIRT', ret=1)!r})"))
    pytester.runpytest().assert_outcomes(passed=1)


def test_a_log_that_is_rejected(pytester: pytest.Pytester) -> None:
    """The test fails, and shows the report and no traceback; the report names a file that is there."""
    pytester.makepyfile(_test(f"s7_log.feed({RUN!r}); s7_log.feed({event('EN_AIRT', ret=0)!r})"))
    result = pytester.runpytest("--basetemp=kept")
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(
        ["*test_plc.s7.ndjson:2: rejected: *", '*{"event":"EN_AIRT",*', "*expected: EN_AIRT ret=16#8080"]
    )
    result.stdout.no_fnmatch_line("*Traceback*")
    result.stdout.no_fnmatch_line("*pytest_plugin.py*")
    assert (pytester.path / "kept" / "s7_log0" / "test_plc.s7.ndjson").read_bytes().count(b"\n") == 2


def test_a_text_may_have_several_lines(pytester: pytest.Pytester) -> None:
    """A log that another process has written is fed whole."""
    pytester.makepyfile(_test(f"s7_log.feed({ACCEPTED.decode()!r}); s7_log.feed({event('EN_AIRT', ret=7)!r})"))
    pytester.runpytest().stdout.fnmatch_lines(["*ndjson:3: rejected: *"])


def test_nothing_fed(pytester: pytest.Pytester) -> None:
    """A test that asks for the log and feeds nothing checks nothing: it fails."""
    pytester.makepyfile(_test("pass"))
    result = pytester.runpytest()
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*s7_log: expected a header and events; the test has fed none"])


def test_a_test_that_fails_by_itself(pytester: pytest.Pytester) -> None:
    """Its own failure comes first, the report beside it."""
    pytester.makepyfile(_test(f"s7_log.feed({REJECTED.decode()!r})", "assert 1 == 2"))
    result = pytester.runpytest()
    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*assert 1 == 2", "*s7_log*", "*ndjson:2: rejected: *"])


def test_a_test_without_the_fixture(pytester: pytest.Pytester) -> None:
    """The plugin leaves it alone."""
    pytester.makepyfile("def test_plain(): pass\ndef test_wrong(): assert False")
    pytester.runpytest().assert_outcomes(passed=1, failed=1)


def test_files(pytester: pytest.Pytester) -> None:
    """Each ``*.s7.ndjson`` is a test; other files are not."""
    (pytester.path / "good.s7.ndjson").write_bytes(ACCEPTED)
    (pytester.path / "bad.s7.ndjson").write_bytes(REJECTED)
    (pytester.path / "cut.s7.ndjson").write_bytes(REJECTED[:-5])
    (pytester.path / "other.ndjson").write_bytes(REJECTED)
    result = pytester.runpytest()
    result.assert_outcomes(passed=1, failed=2)
    result.stdout.fnmatch_lines_random(
        ["*bad.s7.ndjson:2: rejected: *", "*expected: EN_AIRT ret=16#8080", "*cut.s7.ndjson:2: unusable: *"]
    )
    result.stdout.no_fnmatch_line("*Traceback*")
    result.stdout.no_fnmatch_line("*api.py*")
