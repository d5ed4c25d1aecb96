"""The logs that the arguments of a call mean."""

from pathlib import Path

import pytest

from s7check.names import logs_of


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with logs and other files."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a" / "b").mkdir(parents=True)
    for name in ("a/x.ndjson", "a/y.ndjson.gz", "a/b/z.ndjson", "a/v.jsonl", "a/notes.txt", "[1].ndjson"):
        (tmp_path / name).touch()
    return tmp_path


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(
    ("arguments", "names"),
    [
        (["a"], ["a/b/z.ndjson", "a/v.jsonl", "a/x.ndjson", "a/y.ndjson.gz"]),
        (["a/*.ndjson"], ["a/x.ndjson"]),
        (["**/*.ndjson"], ["[1].ndjson", "a/b/z.ndjson", "a/x.ndjson"]),
        (["a/notes.txt", "-", "a/x.ndjson", "a/x.ndjson"], ["a/notes.txt", "-", "a/x.ndjson", "a/x.ndjson"]),
        (["missing", "missing/*"], ["missing", "missing/*"]),
        (["[1].ndjson"], ["[1].ndjson"]),
        (["a\0b"], ["a\0b"]),
    ],
)
def test_names(arguments: list[str], names: list[str]) -> None:
    """Folders and patterns stand for their files; what means none stays."""
    assert logs_of(arguments) == names


def test_folder_without_logs(folder: Path) -> None:
    """Such a folder stays, for the reader to say what it is."""
    (folder / "empty").mkdir()
    assert logs_of(["empty"]) == ["empty"]
