"""The one module that Apalache reads for a query: spec/ as it stands, but for the form that Apalache needs.

- The modules are flattened, and definitions that the query does not need are left out (`flatten`).
- A property of steps ``[][F]_vars`` becomes the action formula ``F``, which Apalache checks after a step. That is
  stronger: a step that changes nothing has to be as F says, too.
- ``Reading("AMB-..")`` becomes the letter that holds by default, read from module Editions.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from evidence.tla.flatten import definition_span, flatten, keep_only
from evidence.tla.syntax import Module, SyntaxTreeError

_BOX = re.compile(r"\[\]\[(.*?)\]_\w+", re.DOTALL)
_READING = re.compile(r'\bReading\("(AMB-\d+)"\)')
_LETTERS = re.compile(r"^ReadBy([A-Z]) ==\s*\{([^}]*)\}", re.MULTILINE)


def default_letters(editions: str) -> dict[str, str]:
    """The ambiguities that are not read by (a), with their letters, from the text of module Editions."""
    return {
        name: letter.lower() for letter, names in _LETTERS.findall(editions) for name in re.findall(r"AMB-\d+", names)
    }


def as_action(text: str) -> str:
    """Properties of steps as formulas about one step. The columns stay, since conjunction lists depend on them."""
    return _BOX.sub(lambda box: f"(  {box[1]})", text)


def read_by_default(text: str, letters: Mapping[str, str]) -> str:
    """The text with each ambiguity read by its default."""
    return _READING.sub(lambda reading: f'"{letters.get(reading[1], "a")}"', text)


def put_in_place(text: str, name: str, others: Sequence[str]) -> str:
    """The text of a module with an operator's definition replaced by that of the last of the others.

    All others move up to its place, with their types. Raises `SyntaxTreeError`.
    """
    module = Module("flat", text.encode())
    if lacking := {name, *others} - module.definitions.keys():
        raise SyntaxTreeError(f"no definition of {', '.join(sorted(lacking))} to put in place")
    places = {key: definition_span(module, key) for key in (name, *others)}
    moved = b"".join(module.text[slice(*places[other])] for other in others)
    new = re.sub(rf"\b{others[-1]}\b".encode(), name.encode(), moved)
    out = module.text
    for key, (start, stop) in sorted(places.items(), key=lambda place: place[1], reverse=True):
        out = out[:start] + (new if key == name else b"") + out[stop:]
    return out.decode()


def module_text(module: str, folders: list[Path], roots: Iterable[str], instead: Mapping[str, Sequence[str]]) -> str:
    """The module with all that it extends and the roots need; `instead` puts operators in the place of others.

    Raises OSError, `SyntaxTreeError`.
    """
    flat = flatten(module, folders)
    text = read_by_default(as_action(flat.text), default_letters(flat.text))
    for name, others in instead.items():
        text = put_in_place(text, name, others)
    return keep_only(replace(flat, text=text), roots)


def definitions(text: str) -> frozenset[str]:
    """The operators that a module's text defines. Raises `SyntaxTreeError`."""
    return frozenset(Module("flat", text.encode()).definitions)
