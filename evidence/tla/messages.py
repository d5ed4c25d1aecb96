"""TLC's messages and their meaning, by the codes of its ``-tool`` output.

TLC frames each message as::

    @!@!@STARTMSG <code>:<class> @!@!@
    text
    @!@!@ENDMSG <code> @!@!@

The codes are those of ``tlc2.output.EC`` and are the same in TLC 2.18 and in the versions after it; the English text
is not, so only names and numbers are taken from it. Messages can be nested: the text of an evaluation error may hold
the frame of the error that caused it.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Literal

VERSION = 2262
SUCCESS = 2193
FINISHED = 2186
STATS = 2199
DEPTH = 2194
PROGRESS = 2200
LIVENESS_CHECKED = 2192

ERROR_CLASSES = frozenset({1, 2})
"""Message classes ERROR and TLCBUG; 0 is plain, 3 a warning, 4 a state of a trace."""

STATE_CODES = frozenset({2216, 2217, 2218, 2122})
"""A state of an error trace, stuttering, and the state at which a lasso closes."""

COMPANIONS = frozenset({2121, 2264})
"""Headings of error class that stand between a violation and its trace and say nothing by themselves."""

Kind = Literal["passed", "invariant", "action", "temporal", "initial", "deadlock", "assumption", "broken", "timeout"]
"""The result of a run.

``invariant`` a state predicate was false; ``action`` a step broke a ``[][A]_v``; ``temporal`` a liveness property;
``initial`` the initial state broke a PROPERTY; ``broken`` anything that means that TLC could not do its work: parse,
configuration and evaluation errors, crashes. Broken never counts as an expected violation.
"""

VIOLATIONS: dict[int, tuple[Kind, re.Pattern[str]]] = {
    2107: ("invariant", re.compile(r"Invariant (.+?) is violated by the initial state")),
    2110: ("invariant", re.compile(r"Invariant (.+?) is violated")),
    2112: ("action", re.compile(r"Action property (.+?) is violated")),
    2108: ("initial", re.compile(r"Property (.+?) is violated by the initial state")),
    2116: ("temporal", re.compile(r"Temporal propert(?:y|ies) (.+?) (?:was|were) violated")),
    2114: ("deadlock", re.compile(r"(?!)")),
    2104: ("assumption", re.compile(r"Assumption (.+?) is false")),
}

VIOLATION_EXITS = frozenset({10, 11, 12, 13})

_MARK = re.compile(r"@!@!@(STARTMSG|ENDMSG) (-?\d+)(?::(\d+))? @!@!@")
_STATS = re.compile(r"([\d,]+) states generated.*?, ([\d,]+) distinct states found")
_DEPTH = re.compile(r"search is (\d+)")
_LOCATION = re.compile(r"^line \d+, col \d+")
_NOISE = ("Parsing file ", "Semantic processing of module ", "Linting of module ")


@dataclass(frozen=True)
class Message:
    """A message: its code, its class (see `ERROR_CLASSES`) and its text without the frame."""

    code: int
    level: int
    text: str


@dataclass
class Parser:
    """Takes TLC's output line by line.

    `messages` holds the complete messages in the order of their ends, `plain` the lines outside any message (the
    parser's errors are there).
    """

    messages: list[Message] = field(default_factory=list)
    plain: list[str] = field(default_factory=list)
    _open: list[tuple[int, int, list[str]]] = field(default_factory=list)

    def feed(self, line: str) -> list[Message]:
        """Take one line (with or without its end) and return the messages that it completes."""
        done: list[Message] = []
        rest = line.rstrip("\r\n")
        while mark := _MARK.search(rest):
            self._text(rest[: mark.start()], keep_empty=False)
            rest = rest[mark.end() :]
            code = int(mark[2])
            if mark[1] == "STARTMSG":
                self._open.append((code, int(mark[3] or 0), []))
            else:
                done += self._close(code)
            if not rest.strip():
                return done
        self._text(rest, keep_empty=True)
        return done

    def finish(self) -> None:
        """Take open messages as complete: a killed TLC does not close its last message."""
        while self._open:
            self._pop()

    def _text(self, text: str, *, keep_empty: bool) -> None:
        if not keep_empty and not text.strip():
            return
        (self._open[-1][2] if self._open else self.plain).append(text)

    def _close(self, code: int) -> list[Message]:
        if not any(opened == code for opened, _, _ in self._open):
            return []
        done: list[Message] = []
        while self._open:
            done.append(self._pop())
            if done[-1].code == code:
                break
        return done

    def _pop(self) -> Message:
        code, level, lines = self._open.pop()
        message = Message(code, level, "\n".join(lines).strip("\n"))
        self.messages.append(message)
        return message


@dataclass(frozen=True)
class Counts:
    """State counts of a run: generated, distinct, and the depth of the search; None where TLC did not say."""

    states: int | None = None
    distinct: int | None = None
    depth: int | None = None


@dataclass(frozen=True)
class Outcome:
    """The result of a run.

    `names` holds the violated properties that TLC named (an assumption: its location) and is empty where it named
    none or gave only a location; `detail` is one line that says it in TLC's words; `trace` are the texts of the states
    of the error trace; `errors` the texts of everything of error class.
    """

    kind: Kind
    names: tuple[str, ...] = ()
    detail: str = ""
    counts: Counts = Counts()
    trace: tuple[str, ...] = ()
    errors: tuple[str, ...] = ()
    version: str = ""
    liveness_checked: bool = False


def progress(message: Message) -> str | None:
    """Return "N generated, M distinct" from a progress or statistics message, None from any other."""
    if message.code not in (PROGRESS, STATS):
        return None
    found = _STATS.search(message.text)
    return f"{found[1]} generated, {found[2]} distinct" if found else None


def interpret(parser: Parser, exit_code: int) -> Outcome:
    """Return the result of a finished run, from its messages and its exit code (negative: killed by that signal).

    A violation counts only if nothing else of error class was said: an evaluation error next to it means that TLC did
    not get to a verdict.
    """
    messages = parser.messages
    errors = [m for m in messages if m.level in ERROR_CLASSES and m.code not in COMPANIONS]
    # A violation wins over level 0: the code says it, whichever class it was printed with.
    violations = [m for m in messages if m.code in VIOLATIONS]
    others = [m for m in errors if m.code not in VIOLATIONS]
    common = {
        "counts": _counts(messages),
        "trace": _trace(messages),
        "version": _version(messages),
        "liveness_checked": any(m.code == LIVENESS_CHECKED for m in messages),
    }
    texts = tuple(_error_texts(parser, errors))

    def outcome(kind: Kind, detail: str, names: tuple[str, ...] = ()) -> Outcome:
        return Outcome(kind, names=names, detail=detail, errors=texts, **common)  # type: ignore[arg-type]

    if others:
        first = others[0]
        return outcome("broken", f"error {first.code}: {_first_line(first.text)}")
    if violations:
        kind, pattern = VIOLATIONS[violations[0].code]
        if exit_code not in VIOLATION_EXITS:
            return outcome("broken", f"{_first_line(violations[0].text)} but exit {exit_code}")
        return outcome(kind, _first_line(violations[0].text), _names(violations[0], kind, pattern))
    codes = {m.code for m in messages}
    if exit_code == 0 and SUCCESS in codes and FINISHED in codes:
        return outcome("passed", "no error found")
    return outcome("broken", f"exit {exit_code} without a verdict")


def _names(message: Message, kind: Kind, pattern: re.Pattern[str]) -> tuple[str, ...]:
    found = pattern.search(message.text)
    if not found:
        return ()
    if kind == "assumption":
        return (found[1],)
    names = re.split(r",? and |, ", found[1]) if kind == "temporal" else [found[1]]
    return () if _LOCATION.match(found[1]) else tuple(names)


def _counts(messages: list[Message]) -> Counts:
    states = distinct = depth = None
    for message in messages:
        if message.code == STATS and (found := _STATS.search(message.text)):
            states, distinct = (int(found[n].replace(",", "")) for n in (1, 2))
        elif message.code == DEPTH and (at := _DEPTH.search(message.text)):
            depth = int(at[1])
    return Counts(states, distinct, depth)


def _trace(messages: list[Message]) -> tuple[str, ...]:
    states = [m.text.strip() for m in messages if m.code in STATE_CODES]
    if not states:
        # A violation in an initial state carries that state in its own text.
        states = [m.text.partition("\n")[2].strip() for m in messages if m.code in (2107, 2108)]
    return tuple(s for s in states if s)


def _version(messages: list[Message]) -> str:
    for message in messages:
        if message.code == VERSION:
            return _first_line(message.text).removeprefix("TLC2 ").removeprefix("Version ")
    return ""


def _error_texts(parser: Parser, errors: list[Message]) -> list[str]:
    said = [line for line in parser.plain if line.strip() and not line.startswith(_NOISE)]
    return [m.text for m in errors] + (["\n".join(said)] if said else [])


def _first_line(text: str) -> str:
    return text.strip().partition("\n")[0]
