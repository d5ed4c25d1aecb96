"""The views: they are made, their links lead somewhere, and no copy of them is kept."""

import re
import subprocess
from pathlib import Path

import pytest
from click.testing import CliRunner

from evidence.common import gallery
from evidence.common.checkout import ROOT
from evidence.kit import kept_paths, measured
from evidence.tests.test_docs import CODE, LINK, anchors_of
from evidence.views import vectors, views_command
from evidence.views.made import views
from evidence.views.traceability.project import read_project
from s7check.engine.client import Engine
from s7check.simulating.kept import DIFFERENCES, EXPERIMENTS, read_kept


@pytest.fixture(scope="module")
def made(engine: Engine) -> dict[Path, str]:
    """All views."""
    return views(read_project(ROOT), engine)


def page_of(name: str) -> Path:
    """Where a page about the rules stands."""
    return Path("docs/rules") / f"{name}.md"


def test_every_link_has_an_end(made: dict[Path, str]) -> None:
    """In the checkout or among the views, as if they stood in the checkout."""
    texts = {ROOT / place: text for place, text in made.items()}
    dangling = []
    for page, text in texts.items():
        for link in LINK.findall(CODE.sub("", text)) if page.suffix == ".md" else ():
            target, _, place = link.partition("#")
            file = (page.parent / target).resolve() if target else page
            there = texts.get(file) or (file.read_text(encoding="utf-8") if file.is_file() else None)
            if "://" not in link and (there is None or (place and place not in anchors_of(there))):
                dangling.append(f"{page.relative_to(ROOT)}: {link}")
    assert dangling == []


@pytest.mark.parametrize(("name", "kept"), [("differences", DIFFERENCES), ("experiments", EXPERIMENTS)])
def test_the_page_names_every_program(name: str, kept: Path, made: dict[Path, str]) -> None:
    """That was found."""
    assert not [one.program["name"] for one in read_kept(kept) if one.program["name"] not in made[page_of(name)]]


def test_sources_for_step_7(made: dict[Path, str]) -> None:
    """The page of experiments leads to those that there are."""
    names = {file.stem for file in made if file.suffix == ".scl"}
    assert len(names) > 100
    assert set(re.findall(r"\(experiments/(.*)\.scl\)", made[page_of("experiments")])) == names


def test_none_is_tracked(made: dict[Path, str]) -> None:
    """A copy in the repository would grow old."""
    files = subprocess.run(["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\n")
    assert not made.keys() & {Path(file) for file in files}


def test_they_are_written(tmp_path: Path, made: dict[Path, str], monkeypatch: pytest.MonkeyPatch) -> None:
    """With the programs of the kit, and nothing else stays; data that are too old are named, and fail the command."""
    output = tmp_path / "views"
    output.mkdir()
    (output / "old.md").write_text("")
    monkeypatch.setattr(views_command, "views", lambda *_: made)
    monkeypatch.setattr(vectors, "write", lambda folder: 7)
    monkeypatch.setattr(kept_paths, "problems", list)
    monkeypatch.setattr(measured, "problems", lambda: ["kit/reached.ndjson: older"])
    result = CliRunner().invoke(views_command.make_command, ["--output", str(output)], standalone_mode=False)
    assert result.return_value == views_command.STALE
    assert re.search(
        r": [0-9]+ pages and sources, [0-9]+ programs of the kit, 7 vectors\nkit/reached.ndjson: older\n", result.output
    )
    areas = ("AIRT", "AMB", "CLK", "DINT", "IRT", "OBS", "T15", "TINT")
    assert {file.relative_to(output) for file in output.rglob("*") if file.is_file()} == {
        *made,
        *(Path("kit/programs") / f"{area}.ndjson" for area in areas),
        *(Path("gallery") / f"{case.name}.ndjson" for case in gallery.cases()),
        Path("gallery/cases.json"),
    }
    monkeypatch.setattr(measured, "problems", list)
    result = CliRunner().invoke(views_command.make_command, ["--output", str(output)], standalone_mode=False)
    assert result.return_value == 0
