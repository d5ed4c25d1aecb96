"""docs/checking/commands.md and docs/project/commands.md describe every option of every command, and no other."""

import re
from pathlib import Path

import click
import pytest

import evidence
import s7check
from evidence import cli as s7spec
from s7check import cli

DOCS = Path(cli.__file__).parents[2] / "docs"
CHECKING, PROJECT = ((DOCS / name / "commands.md").read_text(encoding="utf-8") for name in ("checking", "project"))
EVERY_COMMAND = {"-h", "--help"}
PAGES = {"s7check": CHECKING, "s7spec": PROJECT}


def commands(name: str, group: click.Group) -> dict[str, click.Command]:
    """Each command of a program by its words, those of its groups too; a group with options of its own is a command."""
    context = click.Context(group)
    found: dict[str, click.Command] = {}
    for word in group.list_commands(context):
        command = group.get_command(context, word)
        assert command is not None
        if name == "s7spec" and isinstance(command, click.Group):
            found |= commands(f"{name} {word}", command)
        else:
            found[f"{name} {word}"] = command
    return found


COMMANDS = commands("s7check", cli.cli) | commands("s7spec", s7spec.cli)


def section(name: str) -> str:
    """What the page says of a command."""
    return PAGES[name.partition(" ")[0]].partition(f"\n## `{name}")[2].partition("\n## ")[0]


def options(name: str) -> dict[str, str]:
    """The spellings of a command's options, each with its help."""
    command = COMMANDS[name]
    found = [one for one in command.params if isinstance(one, click.Option)]
    return {spelling: one.help or "" for one in found for spelling in (*one.opts, *one.secondary_opts)}


@pytest.mark.parametrize("name", COMMANDS)
def test_every_option_is_described(name: str) -> None:
    """Those in the command's section are those that it has."""
    described = set(re.findall(r"`(--?[a-z][a-z0-9-]*)", section(name)))
    assert described == options(name).keys()
    assert all(options(name).values()), "an option without a help text"


@pytest.mark.parametrize("name", COMMANDS)
def test_defaults_are_named(name: str) -> None:
    """Of a choice the page says what it is by default."""
    items = re.findall(r"^- `-.*(?:\n  .*)*", section(name), re.MULTILINE)
    for option in COMMANDS[name].params:
        if isinstance(option.type, click.Choice) and isinstance(option.default, str):
            (item,) = (text for text in items if f"`{option.opts[0]} " in text.partition(":")[0])
            assert "default" in item


@pytest.mark.parametrize("name", [name for name in COMMANDS if name.startswith("s7check ")])
def test_every_command_has_its_exit_codes(name: str) -> None:
    """Its section names them; some commands never end with 1."""
    (codes,) = re.findall(r"^Exit codes: (.*(?:\n.+)*)", section(name), re.MULTILINE)
    said = set(re.findall(r"(\d)\s\([^)]+\)", codes))
    assert {"0", "2", "3"} <= said <= {"0", "1", "2", "3"}
    assert set(re.findall(r"`(--?[a-z]+)`", CHECKING.partition("\n## ")[0])) >= EVERY_COMMAND


def test_the_exit_codes_of_every_command_of_s7spec() -> None:
    """One table has them."""
    assert re.findall(r"^\| (\d+) \|", PROJECT, re.MULTILINE) == ["0", "1", "2", "3", "130"]


def test_the_commands_of_both_programs() -> None:
    """Those of users are the same in a checkout and from the wheel: s7check knows no others."""
    assert [name for name in COMMANDS if name.startswith("s7check ")] == [f"s7check {name}" for name in cli.COMMANDS]
    assert set(re.findall(r"^## `(s7\w+ [a-z -]*[a-z])", CHECKING + PROJECT, re.MULTILINE)) == COMMANDS.keys()


def test_environment_variables() -> None:
    """Those that the code reads are described, but for the width of a terminal and the like."""
    packages = [Path(folder) for package in (s7check, evidence) for folder in package.__path__]
    sources = [file for package in packages for file in package.rglob("*.py") if "tests" not in file.parts]
    text = "".join(file.read_text(encoding="utf-8") for file in sources)
    used = set(re.findall(r"environ(?:\.get\(|\[)?\s*\"([A-Z0-9_]+)\"|\"([A-Z0-9_]+)\" (?:not )?in os\.environ", text))
    names = {name for pair in used for name in pair if name}
    assert names
    assert all(f"`{name}`" in CHECKING + PROJECT for name in names)


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_completion_is_described(shell: str) -> None:
    """The line for each shell."""
    assert f"_S7CHECK_COMPLETE={shell}_source s7check" in CHECKING
