"""Who may import whom."""

import ast
from collections.abc import Iterator
from importlib.metadata import entry_points
from pathlib import Path

import evidence
import s7check
from s7check.cli import ADDED_COMMANDS

SHARED = {
    "common": set[str](),
    "tla": set[str](),
    "tlc": {"common", "tla"},
    "behaviours": set[str](),
    "harness": {"common", "tlc"},
    "random_logs": set[str](),
}
"""What several tools use, and what each of these packages may use itself."""


def imported(package: str, folder: Path) -> Iterator[tuple[str, str]]:
    """Each module of the package but its tests, with each module or name that it imports, in full."""
    for file in folder.rglob("*.py"):
        if "tests" in file.relative_to(folder).parts:
            continue
        module = ".".join((package, *file.relative_to(folder).with_suffix("").parts))
        for node in ast.walk(ast.parse(file.read_bytes())):
            if isinstance(node, ast.Import):
                yield from ((module, alias.name) for alias in node.names)
            elif isinstance(node, ast.ImportFrom):
                assert node.level == 0, f"{module}: a relative import"
                yield from ((module, f"{node.module}.{alias.name}") for alias in node.names)


def test_s7check_imports_no_tool_of_the_checkout() -> None:
    """The wheel is s7check alone."""
    found = list(imported("s7check", Path(s7check.__path__[0])))
    assert len(found) > 100
    assert [pair for pair in found if pair[1].partition(".")[0] in ("evidence", "tests", "tree_sitter")] == []


def test_no_tool_borrows_from_another() -> None:
    """A command uses its own package and the shared ones; these use no command, and each other in one direction."""
    commands = {point.value.split(".")[1] for point in entry_points(group=ADDED_COMMANDS)}
    assert commands
    assert commands.isdisjoint(SHARED)
    folders = {folder.name for folder in Path(evidence.__path__[0]).iterdir() if (folder / "__init__.py").is_file()}
    assert folders - {"tests"} == commands | SHARED.keys()
    allowed = {name: SHARED.keys() for name in commands} | SHARED
    wrong = [
        (module, name)
        for module, name in imported("evidence", Path(evidence.__path__[0]))
        if name.startswith("evidence.")
        if name.split(".")[1] not in {module.split(".")[1], *allowed[module.split(".")[1]]}
    ]
    assert wrong == []
