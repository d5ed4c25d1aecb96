"""The wheel, installed where there is no make, no Maven and no checkout."""

import os
import re
import shutil
import subprocess
import sys
import sysconfig
import venv
from importlib import metadata
from pathlib import Path

import pytest
from packaging.requirements import Requirement

from s7check import __version__, resources
from s7check.cli import COMMANDS
from s7check.engine.command import engine_kind
from tests.shipped import log_of
from tests.test_shipped_logs import PROJECT

PIP = [sys.executable, "-m", "pip", "-q", "--disable-pip-version-check", "--no-cache-dir"]
OFFLINE = ["--no-index", "--no-deps"]


def needed(distribution: str) -> set[str]:
    """The distributions that one needs on this system, directly or not; itself among them."""
    found, left = set[str](), [distribution]
    while left:
        name = left.pop()
        if name not in found:
            found.add(name)
            stated = [Requirement(text) for text in metadata.requires(name) or []]
            left += [one.name for one in stated if one.marker is None or one.marker.evaluate({"extra": ""})]
    return found


def install_again(distribution: str, folder: Path) -> None:
    """Copies the files of a distribution of this environment into ``folder``."""
    for file in metadata.files(distribution) or []:
        if ".." not in file.parts:
            (folder / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(str(file.locate()), folder / file)


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The wheel of the checkout."""
    folder = tmp_path_factory.mktemp("wheel")
    settings = folder / "settings.cfg"
    settings.write_text(f"[build]\nbuild_base = {folder / 'build'}\n", encoding="utf-8")
    subprocess.run(
        [*PIP, "wheel", *OFFLINE, "--no-build-isolation", "--wheel-dir", str(folder), str(PROJECT)],
        env=os.environ | {"DIST_EXTRA_CONFIG": str(settings)},
        check=True,
    )
    return next(folder.glob("*.whl"))


@pytest.fixture(scope="module")
def unpacked(wheel: Path) -> Path:
    """The files of the wheel."""
    folder = wheel.parent / "unpacked"
    shutil.unpack_archive(wheel, folder, "zip")
    return folder


@pytest.fixture(scope="module")
def s7check(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The command in a new environment, which has only what the wheel needs, copied from that of the tests."""
    folder = tmp_path_factory.mktemp("venv with a space")
    venv.create(folder, with_pip=False, symlinks=os.name != "nt")
    where = {"base": str(folder), "platbase": str(folder)}
    packages = Path(sysconfig.get_path("purelib", scheme="venv", vars=where))
    for name in needed("s7check") - {"s7check"}:
        install_again(name, packages)
    python = Path(sysconfig.get_path("scripts", scheme="venv", vars=where)) / "python"
    subprocess.run([*PIP, "--python", str(python), "install", *OFFLINE, str(wheel)], check=True)
    return python.with_name("s7check")


@pytest.fixture
def bare(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty folder to work in, and a PATH on which there is nothing but Java."""
    java = shutil.which("java")
    assert java is not None
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "java").symlink_to(java)
    monkeypatch.setenv("PATH", str(tmp_path / "bin"))
    for name in ("PYTHONPATH", "TLA2TOOLS_JAR", "JAVA_HOME"):
        monkeypatch.delenv(name, raising=False)
    work = tmp_path / "work"
    work.mkdir()
    monkeypatch.chdir(work)
    return work


@pytest.mark.usefixtures("bare")
def test_logs_are_judged(s7check: Path) -> None:
    """An accepted and a rejected log, by the specification and the engine of the wheel."""
    accepted = log_of("TINT-33-once-0000")
    rejected = log_of("AIRT-07-nothing-delayed-answers-0000")
    run = subprocess.run([s7check, "trace", accepted, rejected], capture_output=True, text=True, check=False)
    assert (run.returncode, run.stderr) == (1, "")
    first, second, *_ = run.stdout.splitlines()
    assert first.startswith(f"{accepted}: accepted: ")
    assert second.startswith(f"{rejected}:3: rejected: ")


@pytest.mark.skipif(engine_kind() == "jvm", reason="make native has not built the executable")
def test_without_java(s7check: Path, wheel: Path, bare: Path) -> None:
    """With the executable no Java is needed, and the wheel is for machines of this kind."""
    (bare.parent / "bin" / "java").unlink()
    run = subprocess.run([s7check, "--version"], capture_output=True, text=True, check=True)
    assert run.stdout.endswith(", engine native\n")
    rejected = log_of("AIRT-07-nothing-delayed-answers-0000")
    run = subprocess.run([s7check, "trace", rejected], capture_output=True, text=True, check=False)
    assert (run.returncode, run.stderr) == (1, "")
    assert run.stdout.startswith(f"{rejected}:3: rejected: ")
    run = subprocess.run([s7check, "--engine", "jvm", "trace", rejected], capture_output=True, text=True, check=False)
    assert run.returncode == 3
    assert "no java on the PATH" in run.stderr + run.stdout
    assert "-none-any" not in wheel.name


def test_the_specification_comes_parsed(s7check: Path, bare: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is parsed at the first use; a module that was changed is."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(bare))
    log = log_of("TINT-33-once-0000")
    subprocess.run([s7check, "trace", log], capture_output=True, check=True)
    assert not list(bare.rglob("*.tree"))
    module = next(s7check.parents[1].rglob("spec/log/Trace.tla"))
    text = module.read_bytes()
    module.write_bytes(text + b"\n")
    try:
        subprocess.run([s7check, "trace", log], capture_output=True, check=True)
    finally:
        module.write_bytes(text)
    assert len(list(bare.rglob("*.tree"))) == 1


def test_import(s7check: Path, bare: Path) -> None:
    """What a CPU recorded becomes a log."""
    (bare / "rows.csv").write_text("when,what\n2026-11-21T06:00:00,run\n", encoding="utf-8")
    (bare / "map.json").write_text('{"columns": {"at": "when", "event": "what"}}', encoding="utf-8")
    command = [str(s7check), "import", "--from", "csv", "rows.csv", "--map", "map.json", "-o", "log.ndjson"]
    subprocess.run([*command, "--cpu", "S7-400", "--obs", "1,10", "--mode", "STARTUP"], check=True, capture_output=True)
    assert (bare / "log.ndjson").read_text(encoding="utf-8").count("\n") == 2


@pytest.mark.usefixtures("bare")
def test_only_commands_for_logs(s7check: Path) -> None:
    """Help and version work, and no command is offered that needs a checkout."""
    run = subprocess.run([s7check, "--help"], capture_output=True, text=True, check=True)
    assert re.findall(r"^  ([a-z]+) ", run.stdout.partition("Commands:")[2], re.MULTILINE) == [*COMMANDS]
    run = subprocess.run([s7check, "--version"], capture_output=True, text=True, check=True)
    assert re.fullmatch(rf"s7check, version {re.escape(__version__)}, engine (native|jvm)\n", run.stdout)
    run = subprocess.run([s7check, "models"], capture_output=True, text=True, check=False)
    assert (run.returncode, run.stdout) == (2, "")
    assert "No such command 'models'" in run.stderr


@pytest.mark.usefixtures("bare")
def test_coverage(s7check: Path) -> None:
    """The gaps of a log come with programs of the wheel's kit."""
    log = log_of("AIRT-09-ob-80-is-delayed")
    run = subprocess.run([s7check, "coverage", log], capture_output=True, text=True, check=True)
    assert run.stdout.startswith("1 logs: 1 accepted\nrequirements: ")
    assert re.search(r"^  [A-Z]+-[0-9]+[A-Za-z0-9._-]*: [A-Z]+ [0-9]+", run.stdout, re.MULTILINE)


@pytest.mark.usefixtures("bare")
def test_api(s7check: Path) -> None:
    """Python code checks a log with the wheel and runs a program of its kit, and pytest would find the plugin."""
    script = f"""
import s7check
from importlib.metadata import entry_points
print(s7check.check({str(log_of("AIRT-07-nothing-delayed-answers-0000"))!r}).line)
print(*(point.value for point in entry_points(group="pytest11")))
from s7check.kit.suite import Kit
adapters = __import__("pathlib").Path(s7check.__file__).with_name("adapters")
kit = Kit([__import__("sys").executable, str(adapters / "template.py")], offer=adapters / "toy_offer.json")
print(kit.run("AIRT-07-nothing-delayed-answers-0000").status)
"""
    run = subprocess.run([s7check.with_name("python"), "-c", script], capture_output=True, text=True, check=True)
    line, *plugins = run.stdout.split()
    assert line == "3"
    assert "s7check.pytest_plugin" in plugins
    assert plugins[-1] == "passed"


@pytest.mark.usefixtures("bare")
def test_explore(s7check: Path, unpacked: Path) -> None:
    """The page is in the wheel if it was built; else one sentence says how to get it."""
    run = subprocess.run([s7check, "explore", "--no-browser"], capture_output=True, text=True, check=False)
    if (unpacked / "s7check" / "page" / "s7check.html").is_file():
        assert (run.returncode, run.stderr) == (0, "")
        assert Path(run.stdout.strip()).read_bytes() == resources.PAGE.read_bytes()
    else:
        assert run.returncode == 3
        assert "install a wheel that `make wheel` has built" in run.stderr


def test_one_package(unpacked: Path) -> None:
    """The wheel has the package s7check and its description, neither tests nor tools of the checkout."""
    assert sorted(path.name for path in unpacked.iterdir()) == ["s7check", f"s7check-{__version__}.dist-info"]
    assert not list(unpacked.rglob("test*"))


def test_no_second_specification(unpacked: Path) -> None:
    """The wheel has the very files of spec/; the checkout has no copy of them."""
    packed = unpacked / "s7check" / "spec"

    def contents(folder: Path) -> dict[Path, bytes]:
        return {file.relative_to(folder): file.read_bytes() for file in folder.rglob("*") if file.is_file()}

    assert contents(packed) == contents(resources.SPECIFICATION)
    assert resources.SPECIFICATION == PROJECT / "spec"
    assert not (PROJECT / "trace_checker" / "s7check" / "spec").exists()


def test_programs_gallery_and_rules(unpacked: Path) -> None:
    """The wheel has the kit's programs as the checkout makes them, and the files that are read there."""
    package = unpacked / "s7check"
    for folder, packed in ((resources.KIT, "programs"), (resources.GALLERY, "gallery")):
        assert {file.name: file.read_bytes() for file in (package / packed).iterdir()} == {
            file.name: file.read_bytes() for file in folder.iterdir()
        }
    for page in (package / "rules").iterdir():
        assert page.read_bytes() == (resources.RULES / page.name).read_bytes()
    assert {page.name for page in (package / "rules").iterdir()} == {
        "differences-s7-1500.txt",
        "readings.md",
        "requirements-s7-1500.md",
        "requirements.md",
    }
    template = package / "adapters" / "template.py"
    assert template.read_bytes() == (PROJECT / "examples" / "adapters" / "template.py").read_bytes()
    assert {file.suffix for file in template.parent.iterdir()} == {".py", ".json", ".md"}
    for name in ("differences.ndjson", "experiments.ndjson"):
        assert (package / name).read_bytes() == (resources.FOUND / name).read_bytes()


def test_nothing_to_build_the_engine_with(tmp_path: Path) -> None:
    """Without the engine and without Maven there is one sentence, not a wheel that does not work."""
    for name in ("setup.py", "pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(PROJECT / name, tmp_path)
    shutil.copytree(PROJECT / "spec", tmp_path / "spec")
    shutil.copytree(PROJECT / "trace_checker", tmp_path / "trace_checker", ignore=shutil.ignore_patterns("target"))
    build = [sys.executable, "-c", "from setuptools import build_meta; build_meta.build_wheel('out')"]
    run = subprocess.run(build, cwd=tmp_path, env={"PATH": str(tmp_path)}, capture_output=True, text=True, check=False)
    assert run.returncode != 0
    assert "there is no Maven (mvn) on the PATH: install Maven" in run.stderr
    assert not list(tmp_path.glob("out/*"))
