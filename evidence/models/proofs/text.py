"""The one module that Apalache reads for a query: spec/ as it stands, but for the form that Apalache needs.

- The modules are flattened, and definitions that the query does not need are left out (`flatten`).
- A property of steps ``[][F]_vars`` becomes the action formula ``F``, which Apalache checks after a step. That is
  stronger: a step that changes nothing has to be as F says, too.
- ``Reading("AMB-..")`` becomes the letter that holds by default, read from module Readings; or, in a query about
  every letter, a constant that may be each letter of the ambiguity. ``Defaults[a]`` becomes a CASE, most of whose arms
  Apalache leaves out before it asks the solver.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from tree_sitter import Node

from evidence.models.proofs.making import Query
from evidence.tla.flatten import definition_span, flatten, keep_only
from evidence.tla.modules import reached
from evidence.tla.syntax import SyntaxTreeError, operand, read_text, references, symbol, token, walk

_BOX = re.compile(r"\[\]\[(.*?)\]_\w+", re.DOTALL)
_READING = re.compile(r'\bReading\("(AMB-\d+)"\)')
_COMMENT = re.compile(r"(@type(?s:.*?);)|\(\*(?! *@type)(?s:.*?)\*\)|\\\*(?! *@type).*")
_ROW = re.compile(r'<<"((?:AMB|A15)-\d+)", "(\w)", (\w+)>>')
_LETTER = re.compile(r"\bLetterOf(\d+)\b")

ANY_LETTERS = "AnyLetters"
"""What is said of the constants in a query about every letter."""


def default_letters(readings: str) -> dict[str, str]:
    """The default letter of each ambiguity, from the rows in the text of module Readings."""
    return {name: default for name, default, _ in _ROW.findall(readings)}


def as_action(text: str) -> str:
    """Properties of steps as formulas about one step. The columns stay, since conjunction lists depend on them."""
    return _BOX.sub(lambda box: f"(  {box[1]})", text)


def all_letters(readings: str) -> dict[str, str]:
    """The letters of each ambiguity, from the rows in the text of module Readings: such as "abc"."""
    return {name: letters.lower() for name, _, letters in _ROW.findall(readings)}


def letters_alone(readings: str, alone: str) -> dict[str, str]:
    """One letter of each ambiguity: that in `alone`, such as "AMB-21 b", or else its default."""
    return default_letters(readings) | named_letters(alone)


def read_by_any(text: str, shown: Iterable[str]) -> str:
    """The text with a constant for each ambiguity, but for those whose letter a CPU shows when it is at work."""
    return _READING.sub(lambda found: found[0] if found[1] in shown else f"LetterOf{found[1][4:]}", text)


def unless_read(text: str, formula: str, letters: Iterable[str]) -> str:
    """The text with `but_for` of the formula: it says nothing where ambiguities are read by one of the letters.

    A letter is such as "AMB-49 b"; letters with a comma between them are meant together. The formula itself stays: the
    invariant is also assumed. It is not said with IF, since Apalache divides what stands behind a quantifier into
    conditions. Raises `SyntaxTreeError` if the text does not define the formula.
    """
    if formula not in definitions(text):
        raise SyntaxTreeError(f"no definition of {formula} that letters may be left out of")
    read = " \\/ ".join(_are_read(each) for each in letters)
    said = f"{but_for(formula)} == \\A asked \\in (IF {read} THEN {{}} ELSE {{TRUE}}) : {formula}"
    return text.replace("\n====\n", f"\n{said}\n====\n")


def but_for(formula: str) -> str:
    """The name of the formula that leaves letters out."""
    return f"{formula}ButFor"


def _are_read(letters: str) -> str:
    each = " /\\ ".join(f'LetterOf{name[4:]} = "{letter}"' for name, letter in named_letters(letters).items())
    return f"({each})" if "," in letters else each


def named_letters(letters: str) -> dict[str, str]:
    """The letter of each ambiguity in a text such as "AMB-21 b, AMB-42 c"."""
    return dict(re.findall(r"(AMB-\d+) (\w)", letters))


def with_letters(text: str, letters: Mapping[str, str], constants: str) -> str:
    """The text with its constants for letters declared, and with `ANY_LETTERS`: these and the other `constants`."""
    numbers = sorted(set(_LETTER.findall(text)))
    declared = ",\n".join(f"    \\* @type: Str;\n    LetterOf{n}" for n in numbers)
    quoted = {n: ", ".join(f'"{letter}"' for letter in letters[f"AMB-{n}"]) for n in numbers}
    each = [f"LetterOf{n} \\in {{{quoted[n]}}}" for n in numbers]
    said = f"{ANY_LETTERS} ==\n" + "\n".join(f"    /\\ {one}" for one in [constants, *each])
    head, line, rest = text.partition("\nEXTENDS ")
    extended, end, body = rest.partition("\n")
    declared = f"CONSTANTS\n{declared}\n\n" if numbers else ""
    return f"{head}{line}{extended}{end}{declared}{body}".replace("\n====\n", f"\n{said}\n====\n")


def read_by_default(text: str, letters: Mapping[str, str]) -> str:
    """The text with each ambiguity read by its default."""
    arms = " [] ".join(f'a = "{name}" -> "{letter}"' for name, letter in letters.items() if letter != "a")
    text = text.replace("Defaults[a]", f'(CASE {arms} [] OTHER -> "a")')
    return _READING.sub(lambda reading: f'"{letters[reading[1]]}"', text)


def put_in_place(text: str, name: str, others: Sequence[str]) -> str:
    """The text of a module with an operator's definition replaced by that of the last of the others.

    All others move up to its place, with their types. Raises `SyntaxTreeError`.
    """
    module = read_text(text)
    if lacking := {name, *others} - module.definitions.keys():
        raise SyntaxTreeError(f"no definition of {', '.join(sorted(lacking))} to put in place")
    places = {key: definition_span(module, key) for key in (name, *others)}
    moved = b"".join(module.text[slice(*places[other])] for other in others)
    new = re.sub(rf"\b{others[-1]}\b".encode(), name.encode(), moved)
    out = module.text
    for key, (start, stop) in sorted(places.items(), key=lambda place: place[1], reverse=True):
        out = out[:start] + (new if key == name else b"") + out[stop:]
    return out.decode()


def module_text(query: Query, folders: list[Path], roots: Iterable[str]) -> str:
    """The query's module with all that it extends and the roots need. Raises OSError, `SyntaxTreeError`.

    In a query about every letter `ANY_LETTERS` stands in it, too; with letters in `alone` that allows these, and the
    defaults of all other ambiguities.
    """
    flat = flatten(query.module, folders)
    text = flat.text if query.shown is None else read_by_any(flat.text, query.shown)
    text = read_by_default(as_action(text), default_letters(text))
    for name, others in query.instead:
        text = put_in_place(text, name, others)
    text = keep_only(replace(flat, text=text), roots)
    if query.shown is None:
        return text
    for formula, letters in query.unless:
        if formula in query.formulas:
            text = unless_read(text, formula, letters)
    allowed = letters_alone(flat.text, query.alone) if query.alone else all_letters(flat.text)
    return with_letters(text, allowed, query.constants)


def fixed_constants(text: str, initializer: str) -> frozenset[str]:
    """The constants that may get one value for the whole module: those that the initializer compares by ``=``.

    Apalache puts a value that a constant is compared with, such as 3 in ``C = 3``, in the place of the constant
    everywhere, even where the comparison is only a condition. Then nothing is proved of other values. A record or a
    `Gen` is no such value.
    """
    module = read_text(text)
    declared = {
        token(name)
        for unit in module.units
        if unit.type == "constant_declaration"
        for name in unit.children
        if name.type == "identifier"
    }
    below = reached([initializer], {name: references(unit) for name, unit in module.definitions.items()})
    compared = [node for name in below for node in walk(module.definitions[name]) if symbol(node) == "eq"]
    return frozenset(token(operand(node, "lhs")) for node in compared if not _is_any(operand(node, "rhs"))) & declared


def _is_any(node: Node) -> bool:
    return node.type == "record_literal" or token(node).startswith("Gen(")


def without_comments(text: str) -> str:
    """What says something: no comments but types, no empty lines."""
    return "\n".join(filter(None, (line.rstrip() for line in _COMMENT.sub(r"\1", text).splitlines())))


def definitions(text: str) -> frozenset[str]:
    """The operators that a module's text defines. Raises `SyntaxTreeError`."""
    return frozenset(read_text(text).definitions)
