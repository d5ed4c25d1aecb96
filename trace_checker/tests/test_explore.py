"""`s7check explore`: the page as a file, with a log inside."""

import base64
import gzip
import io
import json
import re
import webbrowser
from pathlib import Path

import pytest

from s7check import explore_command
from s7check.cli import main

PAGE = '<p>a page</p><script type="application/json" id="first">null</script>'
LOG = b'{"format": "s7-interrupt-log/1"}\n{"event": "</script>"}\n'


@pytest.fixture(autouse=True)
def page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A page that is built, and no browser."""
    file = tmp_path / "built.html"
    file.write_text(PAGE, encoding="utf-8")
    monkeypatch.setattr(explore_command, "PAGE", file)
    monkeypatch.setattr(webbrowser, "open", lambda address: pytest.fail(address))
    return file


def first(page: str) -> dict[str, object]:
    """The log that the page begins with."""
    found = re.search('id="first">(.*?)</script>', page)
    assert found is not None
    given: dict[str, object] = json.loads(found[1])
    return given | {"log": gzip.decompress(base64.b64decode(str(given["log"])))}


def test_without_a_log_it_is_the_page_itself(
    page: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """It is opened, and its name printed."""
    opened: list[str] = []
    monkeypatch.setattr(webbrowser, "open", opened.append)
    assert main(["explore"]) == 0
    assert opened == [page.as_uri()]
    assert capsys.readouterr().out == f"{page}\n"


def test_a_log_is_inside(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Byte for byte, with its name and the line; what could end the element is no danger."""
    log = tmp_path / "a log.ndjson"
    log.write_bytes(LOG)
    assert main(["explore", "--no-browser", f"{log}:2"]) == 0
    made = Path(capsys.readouterr().out.strip())
    text = made.read_text(encoding="utf-8")
    assert first(text) == {"name": "a log.ndjson", "log": LOG, "line": 2}
    assert text.startswith("<p>a page</p>")
    made.unlink()
    made.parent.rmdir()


def test_of_a_pipe_into_a_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`s7check simulate PROGRAM | s7check explore -` shows what a program does."""
    with (tmp_path / "piped").open("w+b") as piped:
        piped.write(LOG)
        piped.seek(0)
        monkeypatch.setattr("sys.stdin", io.TextIOWrapper(piped))
        assert main(["explore", "--no-browser", "--output", str(tmp_path / "out.html"), "-"]) == 0
    made = first((tmp_path / "out.html").read_text(encoding="utf-8"))
    assert made == {"name": "log.ndjson", "log": LOG, "line": None}


@pytest.mark.parametrize(
    ("argument", "code", "said"),
    [
        ("log:3", 2, "log:3: unusable: expected a line 1 to 2; found 3"),
        ("log:0", 2, "log:0: unusable: expected a line 1 to 2; found 0"),
        ("none", 2, "none: unusable: expected a log that can be opened; found no such file"),
    ],
)
def test_a_log_that_cannot_be_opened(
    tmp_path: Path,
    argument: str,
    code: int,
    said: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """One message with the name and what was expected."""
    (tmp_path / "log").write_bytes(LOG)
    monkeypatch.chdir(tmp_path)
    assert main(["explore", argument]) == code
    assert said in capsys.readouterr().err


def test_no_page(page: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The message has the remedy."""
    page.unlink()
    assert main(["explore"]) == 3
    assert "expected the page of the explorer: run `make page`" in capsys.readouterr().err


def test_a_file_that_cannot_be_written(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It is named."""
    assert main(["explore", "--no-browser", "--output", str(tmp_path / "none" / "out.html")]) == 2
    assert "out.html" in capsys.readouterr().err
