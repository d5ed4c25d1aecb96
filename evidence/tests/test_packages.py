"""Who may import whom."""

import ast
from collections.abc import Iterator
from pathlib import Path

import evidence
import s7check

ORDER = {
    "common": set[str](),
    "tla": {"common"},
    "models": {"common", "tla"},
    "mutants": {"common", "tla", "models"},
    "logs": {"common", "tla", "models"},
    "kit": {"common", "tla", "models"},
    "views": {"common", "tla", "models"},
    "verify": {"common"},
    "cli": {"common"},
    "__main__": {"cli"},
}
"""The packages of evidence/, and what each may import beside itself."""


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
