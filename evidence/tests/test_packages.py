"""Who may import whom."""

import ast
from collections.abc import Iterator
from graphlib import TopologicalSorter
from importlib import import_module
from pathlib import Path

import pytest

import evidence
import s7check

ORDER = {
    "common": set[str](),
    "tla": {"common"},
    "models": {"common", "tla"},
    "mutants": {"common", "tla", "models"},
    "logs": {"common", "tla", "models"},
    "kit": {"common", "tla", "models"},
    "views": {"common", "tla", "models", "kit"},
    "verify": {"common"},
    "cli": {"common"},
    "__main__": {"cli"},
}
"""The packages of evidence/, and what each may import beside itself."""

FLOORS = (
    *("readable", "resources", "completion", "output", "program"),
    *("log", "names", "engine", "letters", "report", "importing", "judging", "ending", "api"),
    *("asking", "explaining", "deciding", "reducing", "kit", "simulating", "migrating"),
    *("coverage", "explore_command", "trace_command"),
    *("assisting", "live", "cli", "pytest_plugin", "__main__"),
)
"""The packages and modules of s7check from the ground up: each imports those before it."""


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


def test_s7check_imports_downwards() -> None:
    """No package imports one that stands above it; `s7check` itself hands the names of the API on."""
    found = list(imported("s7check", Path(s7check.__path__[0])))
    assert {module.split(".")[1] for module, _ in found} - {"__init__"} == set(FLOORS)
    height = {name: floor for floor, name in enumerate(FLOORS)}
    wrong = [
        (module, name)
        for module, name in found
        if name.startswith("s7check.") and module != "s7check.__init__" and name.split(".")[1] in height
        if height[name.split(".")[1]] > height[module.split(".")[1]]
    ]
    assert wrong == []


@pytest.mark.parametrize("package", ["s7check", "evidence"])
def test_no_circle_of_modules(package: str) -> None:
    """Not even one that an import within a function hides."""
    found = list(imported(package, Path(import_module(package).__path__[0])))
    modules = {module for module, _ in found}
    uses: dict[str, set[str]] = {module: set() for module in modules if not module.endswith(".__init__")}
    for module, name in found:
        if module in uses:
            uses[module] |= {one for one in (name, name.rpartition(".")[0]) if one in uses}
    assert sum(map(len, uses.values())) > 100
    list(TopologicalSorter(uses).static_order())  # raises CycleError, which names the circle


def test_packages_import_in_one_order() -> None:
    """A package imports itself and those that the table names."""
    root = Path(evidence.__path__[0])
    rooms = {folder.name for folder in root.iterdir() if (folder / "__init__.py").is_file()} - {"tests"}
    assert rooms | {"verify", "cli", "__main__"} == ORDER.keys()
    wrong = [
        (module, name)
        for module, name in imported("evidence", root)
        if name.startswith("evidence.")
        if name.split(".")[1] not in {module.split(".")[1], *ORDER[module.split(".")[1]]}
    ]
    assert wrong == []
