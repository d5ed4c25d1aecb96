"""The one module that Apalache reads for a query: spec/ as it stands, but for the form that Apalache needs.

- The modules are flattened, and definitions that the query does not need are left out (`flatten`).
- A property of steps ``[][F]_vars`` becomes the action formula ``F``, which Apalache checks after a step. That is
  stronger: a step that changes nothing has to be as F says, too.
- ``Reading("AMB-..")`` becomes the letter that holds by default, read from module Editions.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from pathlib import Path

from evidence.proofs.flatten import STANDARD, FlattenError, definitions, flatten, keep_only

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


def put_in_place(text: str, name: str, by: str) -> str:
    """The text with the definition of an operator replaced by that of another. Raises `FlattenError`."""
    places = definitions(text)
    if lacking := {name, by} - places.keys():
        raise FlattenError(f"no definition of {', '.join(sorted(lacking))} to put in place")
    other = re.sub(rf"\b{by}\b", name, text[slice(*places[by])])
    for begin, end, new in sorted([(*places[name], other), (*places[by], "")], reverse=True):
        text = text[:begin] + new + text[end:]
    return text


def module_text(module: str, folders: list[Path], roots: Iterable[str], instead: Mapping[str, str]) -> str:
    """The module with all that it extends and the roots need; `instead` puts operators in the place of others.

    Raises OSError, `FlattenError`.
    """
    text = flatten(module, folders)
    letters = default_letters(text)
    text = read_by_default(as_action(text), letters)
    for name, by in instead.items():
        text = put_in_place(text, name, by)
    return f"---- MODULE {module} ----\nEXTENDS {', '.join(sorted(STANDARD))}\n{keep_only(text, roots)}====\n"


def defined(text: str, name: str) -> bool:
    """Whether a module's text defines the operator."""
    return name in definitions(text)
