"""build/page/s7check.html: engine, parsed specification, rules and edge cases in one page that needs no network."""

import base64
import gzip
import re
import subprocess
from pathlib import Path
from typing import Any

import msgspec

from evidence.views.site.chapters import homes_of, read_chapters
from s7check.engine.client import Engine
from s7check.engine.command import jvm_command
from s7check.judging.decisions import decisions_of
from s7check.report.clauses import all_clauses, requirements, texts
from s7check.resources import CHECKOUT, ENGINE, GALLERY, PAGE

SOURCES = CHECKOUT / "trace_checker" / "s7check"
WASM = ENGINE / "wasm"
_SCRIPTS: tuple[str, ...] = ("elements", "engine", "model", "timeline", "desk", "shown", "report", "offers", "sides")
_SCRIPTS += ("others", "importing", "main")
"""In this order; what a later one has is used when all are there."""
_OF_MODULES = re.compile(r"^import .*\n|^export \{.*\n|^export ", re.MULTILINE)
_EXPORTS = re.compile(r"export\s*\{([^}]*)\};?\s*$")


def main() -> None:
    """Write the page."""
    page = _source("page/page.html")
    style = _source("report/report.css") + _source("page/page.css")
    script = "".join(_OF_MODULES.sub("", _source(f"page/{name}.js")) for name in _SCRIPTS)
    for place, text in (("STYLE", style), ("CONTENTS", _contents()), ("SCRIPT", script)):
        page = page.replace(f"/*{place}*/", text)
    PAGE.parent.mkdir(parents=True, exist_ok=True)
    PAGE.write_text(page, encoding="utf-8")


def _source(name: str) -> str:
    return (SOURCES / name).read_text(encoding="utf-8")


def _contents() -> str:
    """What the page unpacks, as JSON that may stand in a page."""
    runtime = (WASM / "org/teavm/backend/wasm/wasm-gc-module-runtime.min.js").read_text(encoding="utf-8")
    worker = _as_classic(runtime) + _source("page/worker.js")
    contents: dict[str, Any] = {
        "script": _packed(worker.encode()),
        "wasm": _packed((WASM / "engine.wasm").read_bytes()),
        "tree": _packed(_parsed().read_bytes()),
        "texts": _packed(msgspec.json.encode(texts() | {"clauses": _clauses()})),
        "decidable": _decidable(),
        "gallery": _gallery(),
    }
    return msgspec.json.encode(contents).decode().replace("<", "\\u003c")


def _clauses() -> list[dict[str, Any]]:
    """The rules and the open questions, each with its place in the site."""
    places = homes_of(read_chapters(requirements())[1])
    return [msgspec.to_builtins(one) | {"home": places[one.id]} for one in all_clauses()]


def _decidable() -> dict[str, list[int]]:
    """The outcomes by which a log shows that a requirement has decided something."""
    with Engine(jvm_command) as engine:
        return {name: sorted(outcomes) for name, outcomes in decisions_of(engine).shown.items()}


def _as_classic(module: str) -> str:
    """A module's text for a Worker that is none, since one from a Blob may not be a module in a page from a file."""
    found = _EXPORTS.search(module)
    if found is None:
        raise ValueError("the runtime of TeaVM exports nothing at its end")
    pairs = [part.split(" as ") for part in found[1].split(",")]
    names = "".join(f"const {new.strip()}={old.strip()};" for old, new in (pair for pair in pairs if len(pair) > 1))
    return f"{module[: found.start()]}\n{names}\n"


def _packed(data: bytes) -> str:
    return base64.b64encode(gzip.compress(data, mtime=0)).decode()


def _parsed() -> Path:
    """The parsed specification, which the engine in Java keeps in a file."""
    command = jvm_command()
    subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=True)
    return Path(command[-1])


def _gallery() -> list[dict[str, Any]]:
    cases: list[dict[str, Any]] = msgspec.json.decode((GALLERY / "cases.json").read_bytes())
    shown = ("name", "title", "told", "requirements")
    return [
        {name: case[name] for name in shown} | {"log": (GALLERY / f"{case['name']}.ndjson").read_text(encoding="utf-8")}
        for case in cases
    ]


if __name__ == "__main__":
    main()
