"""The cases of ``traces/``: logs in short, each with the verdict that the requirements give; traces/README.md says how.

A case expands to the bytes of a log. Only the notation is known here: whether a log is of the format, its reader says.
"""

from __future__ import annotations

import gzip
import json
import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from datetime import datetime, timedelta
from functools import partial
from itertools import takewhile
from pathlib import Path
from typing import TYPE_CHECKING, Any

from evidence.common.checkout import ROOT

if TYPE_CHECKING:
    from s7check.report.report import Report

TRACES = ROOT / "traces"

_SCHEMA = json.loads((TRACES / "schema" / "s7-interrupt-log-1.schema.json").read_bytes())["$defs"]
_FIELDS = {name.removeprefix("event_"): one["properties"] for name, one in _SCHEMA.items() if "event_" in name}
"""Event -> its fields, in their order."""

_NAMED = ("event", "at", "up", "info")

VERDICTS = {"A": ("accepted", "accept"), "R": ("rejected", "reject"), "U": ("unusable", "unusable")}
"""First letter of a verdict -> the verdict, the folder of its logs where they are written out."""

EVENTS: dict[str, tuple[str, tuple[str, ...]]] = {
    "set": ("SET_TINT", ("ob", "sdt", "period", "ret")),
    "act": ("ACT_TINT", ("ob", "ret")),
    "can": ("CAN_TINT", ("ob", "ret")),
    "qry": ("QRY_TINT", ("ob", "ret", "status")),
    "srt": ("SRT_DINT", ("ob", "dtime", "sign", "ret")),
    "cand": ("CAN_DINT", ("ob", "ret")),
    "qryd": ("QRY_DINT", ("ob", "ret", "status")),
    "dis": ("DIS_IRT", ("mode", "ob", "ret")),
    "en": ("EN_IRT", ("mode", "ob", "ret")),
    "dair": ("DIS_AIRT", ("ret",)),
    "eair": ("EN_AIRT", ("ret",)),
    "setl": ("SET_TINTL", ("ob", "sdt", "local", "period", "activate", "ret")),
    **{
        "int" if name == "interrupt" else name: (name, tuple(field for field in fields if field not in _NAMED))
        for name, fields in _FIELDS.items()
        if "ret" not in fields
    },
}
"""Short name -> event and its operands; the last ones may be left out."""

BYTES = ("mode", "flt_id", "strt_info")
WORDS = ("ret", "status", "period", "sign", "cause", "id", "ev", "error_info")
INTEGERS = ("ob", "dtime", "left", "zone", "up", "priority", "ev_ob", "event_count", "csg_ob", "csg_priority")
MOMENTS = ("at", "to", "time")
FLAGS = ("active", "deselected", "local")
QUEUE = ("events", "threshold", "overflow")
_JSON = {"true": True, "false": False, "null": None}

_BYTES_OF_FILE: dict[str, Callable[[bytes], bytes]] = {
    "crlf": lambda text: text.replace(b"\n", b"\r\n"),
    "cut": lambda text: text.removesuffix(b"\n").removesuffix(b"\r"),
    "latin-1": lambda text: text.decode().encode("latin-1"),
    "gzip": lambda text: gzip.compress(text, mtime=0),
}
"""What ``as=`` does to the whole file, in the order in which it stands there."""

_REQUIREMENT = re.compile(r"[A-Z]+\d*-\d+")
_TIME = re.compile(r"(\d+:)?\d+:\d+(\.\d+)?")
_VERDICT = re.compile(r"A|[RU]\d*")
_NOTE = re.compile(r"(\w+): (.+)")


class CasesError(ValueError):
    """A line of a case file is not of the notation; the text has file, line and what is expected."""


@dataclass(frozen=True)
class Case:
    """A log and what is to be said of it; ``line`` is None where it is accepted.

    ``requirements`` begins with the one that decides. ``packed`` says that ``log`` is a gzip file. ``place`` is the
    case's line in the file of its area. ``notes`` are lines ``NAME: TEXT``, in files that have them.
    """

    area: str
    name: str
    verdict: str
    line: int | None
    requirements: list[str]
    reason: str
    log: bytes
    packed: bool = False
    place: int = 0
    notes: dict[str, str] = field(default_factory=dict)

    @property
    def id(self) -> str:
        """Its name among all cases."""
        return f"{self.area}/{self.name}"

    @property
    def file(self) -> str:
        """Where it is written to, counted from the folder of all logs."""
        folder = next(folder for verdict, folder in VERDICTS.values() if verdict == self.verdict)
        return f"{self.area}/{folder}/{self.name}.ndjson" + ".gz" * self.packed

    @property
    def lines(self) -> list[bytes]:
        """The lines of its log, unpacked, without their ends."""
        return (gzip.decompress(self.log) if self.packed else self.log).splitlines()

    @property
    def header(self) -> dict[str, Any]:
        """Its first line. Raises ValueError where that is no JSON."""
        header: dict[str, Any] = json.loads(next(line for line in self.lines if line.strip()))
        return header

    def put(self, folder: Path) -> Path:
        """Write its log below a folder of all logs, and give the path. Raises OSError."""
        path = folder / self.file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(self.log)
        return path


def all_cases(folder: Path = TRACES) -> list[Case]:
    """The cases of all files of a folder. Raises FileNotFoundError if there are none, and `CasesError`."""
    files = sorted(folder.glob("*.txt"))
    if not files:
        raise FileNotFoundError(f"{folder}: no case file, *.txt")
    return [case for file in files for case in read_cases(file)]


def every_case(folder: Path = TRACES) -> list[Case]:
    """The cases of all files of a folder, and the logs judged by hand in it. Raises as `all_cases` does."""
    by_hand = folder / "by_hand"
    return all_cases(folder) + (all_cases(by_hand) if by_hand.is_dir() else [])


def difference(case: Case, report: Report) -> str | None:
    """The difference between the verdict of a case and the one that its log got."""
    line = report.line if report.verdict != "accepted" else None
    if (report.verdict, line) == (case.verdict, case.line):
        return None
    wanted = f"{case.verdict}, line {case.line}" if case.line else case.verdict
    got = f"{report.verdict}, line {line}" if line else report.verdict
    return f"{case.id}: expected {wanted}; got {got}: {report.message}"


def read_cases(file: Path, *, notes: bool = False) -> Iterator[Case]:
    """The cases of one file, whose name is their area; it may have `notes`. Raises `CasesError`, OSError."""
    defaults: dict[str, Any] = {"format": "s7-interrupt-log/1"}
    drafts: list[_Draft] = []
    add: Callable[[str], None] = partial(_merge, defaults)
    place = 0
    try:
        for place, line in _whole_lines(file.read_text(encoding="utf-8")):
            if line.startswith("== "):
                drafts.append(_Draft.begin(place, line, defaults))
                add = drafts[-1].add
            elif notes and drafts and (note := _NOTE.fullmatch(line)):
                drafts[-1].notes[note[1]] = " ".join(note[2].split())
            elif line.strip() and not line.startswith("//"):
                add(line)
        names = set[str]()
        for draft in drafts:
            place = draft.place
            for case in draft.cases(file.stem):
                if case.name in names:
                    raise ValueError(f"another name than {case.name}, which an earlier case has")
                names.add(case.name)
                yield case
    except ValueError as error:
        raise CasesError(f"{file}:{place}: expected {error}") from error


def _whole_lines(text: str) -> Iterator[tuple[int, str]]:
    """The lines with their numbers; one that begins with a space goes on with the one before."""
    first, whole = 0, ""
    for number, line in enumerate(text.split("\n"), 1):
        if line.startswith(" "):
            whole += line
        else:
            yield first, whole
            first, whole = number, line
    yield first, whole


@dataclass
class _Draft:
    """A case as far as it has been read, or the beginning of several, each with an end of its own."""

    place: int
    name: str
    verdict: str
    requirements: list[str]
    header: dict[str, Any]
    reason: str = ""
    lines: list[str] = field(default_factory=list)
    headless: bool = False
    at: str = ""
    up: _Elapsed | None = None
    ends: list[_Draft] = field(default_factory=list)
    notes: dict[str, str] = field(default_factory=dict)

    @classmethod
    def begin(cls, place: int, line: str, defaults: dict[str, Any]) -> _Draft:
        _, name, *words = line.split()
        verdict = words.pop(0) if words and _VERDICT.fullmatch(words[0]) else ""
        requirements = list(takewhile(_REQUIREMENT.fullmatch, words))
        draft = cls(place, name, verdict, requirements, dict(defaults))
        _merge(draft.header, " ".join(words[len(requirements) :]))
        return draft

    def add(self, line: str) -> None:
        if line.startswith("->"):
            self._end(line[2:])
        elif line.startswith("#"):
            self.reason = " ".join(f"{self.reason} {line[1:]}".split())
        elif line.startswith("|"):
            self.headless |= not self.lines
            self.lines.append(line[1:].removeprefix(" "))
        elif line[0].isalpha():
            _merge(self.header, line)
        else:
            self._events(line)

    def _end(self, line: str) -> None:
        events, _, reason = line.partition("#")
        verdict, *words = events.split()
        own = list(takewhile(_REQUIREMENT.fullmatch, words))
        end = replace(
            self,
            name=f"{self.name}-{len(self.ends) + 1}",
            verdict=verdict,
            requirements=own or self.requirements,
            reason=" ".join(reason.split()),
            lines=list(self.lines),
            ends=[],
        )
        if words[len(own) :]:
            end._events(" ".join(words[len(own) :]))
        self.ends.append(end)

    def _events(self, text: str) -> None:
        """The events of a line; one without a time of its own has that of the event before it."""
        for part in text.split(";"):
            words = part.split()
            if words and words[0][0].isdigit():
                self.at = _moment(words.pop(0), self.header)
            event = {"at": self.at, **_event(words, self.header)}
            if "up" in self.header:
                self.up = (self.up or _Elapsed(self.header["up"], _clock(self.header))).after(event)
                event["up"] = self.up.milliseconds
            self.lines.append(json.dumps(event))

    def cases(self, area: str) -> Iterator[Case]:
        if self.ends:
            for end in self.ends:
                yield from end.cases(area)
            return
        header = {name: value for name, value in self.header.items() if name not in ("as", "up")}
        changes = self.header.get("as", [])
        lines = self.lines if self.headless else [json.dumps(header), *self.lines]
        log = "".join(line + "\n" for line in lines).encode()
        for change in changes:
            log = _BYTES_OF_FILE[change](log)
        if not _VERDICT.fullmatch(self.verdict):
            raise ValueError(f"a verdict of {self.name}, A, or R or U and the line; found {self.verdict or 'none'}")
        verdict, _ = VERDICTS[self.verdict[0]]
        at = None if verdict == "accepted" else int(self.verdict[1:] or len(lines))
        said = self.requirements, self.reason, log, "gzip" in changes, self.place, self.notes
        yield Case(area, self.name, verdict, at, *said)


@dataclass(frozen=True)
class _Elapsed:
    """The elapsed time when the clock shows ``now``."""

    milliseconds: int
    now: str

    def after(self, event: dict[str, Any]) -> _Elapsed:
        passed = datetime.fromisoformat(event["at"]) - datetime.fromisoformat(self.now)
        return _Elapsed(self.milliseconds + passed // timedelta(milliseconds=1), event.get("to", event["at"]))


def _merge(header: dict[str, Any], line: str) -> None:
    """Set the fields of a line ``FIELD=VALUE...`` in a header."""
    for word in line.split():
        name, equals, value = word.partition("=")
        if not equals:
            raise ValueError(f"FIELD=VALUE; found {word}")
        group, _, ob = name.partition(".")
        if _REQUIREMENT.fullmatch(name):
            header["readings"] = {**header.get("readings", {}), name: value}
        elif group == "priority":
            header[group] = {**header.get(group, {}), ob: _number(name, value, 10)}
        elif group == "classes":
            header[group] = {**header.get(group, {}), ob: value}
        elif group == "queue":
            header[group] = {**header.get(group, {}), ob: _queue(name, value)}
        elif group == "step7":
            kind, given = "dint" if ob.startswith("2") else "tod", header.get(group, {})
            header[group] = {**given, kind: {**given.get(kind, {}), ob: _parameters(value)}}
        elif name == "obs":
            header[name] = [_number(name, number, 10) for number in value.split(",")]
        elif name == "records":
            header[name] = value.split(",")
        elif name == "as":
            header[name] = [_one_of(_BYTES_OF_FILE, change) for change in value.split(",")]
        elif name in ("latency_ms", "zone", "up"):
            header[name] = _number(name, value, 10)
        elif name == "cpu":
            header[name] = value.replace("_", " ")
        else:
            header[name] = _JSON.get(value, value)


def _parameters(value: str) -> dict[str, object]:
    """STEP 7's parameters of one interrupt: ``EXECUTION,START``, ``active``, ``deselected``, ``local``."""
    made: dict[str, object] = {}
    for word in value.split(","):
        made |= {word: True} if word in FLAGS else {"start" if "T" in word else "execution": word}
    return made


def _queue(name: str, value: str) -> dict[str, object]:
    """The parameters of a queue: ``EVENTS,THRESHOLD,OVERFLOW``, as far as they are given; ``-`` is one that is not."""
    given = zip(QUEUE, value.split(","), strict=False)
    return {field: _JSON[text] if text in _JSON else _number(name, text, 10) for field, text in given if text != "-"}


def _event(words: list[str], header: dict[str, Any]) -> dict[str, Any]:
    short, *operands = words or [""]
    event, names = EVENTS[_one_of(EVENTS, short)]
    plain = [word for word in operands if "=" not in word]
    if len(plain) > len(names):
        raise ValueError(f"{short} {' '.join(names).upper()}; found {' '.join(operands)}")
    made = {name: _value(name, text, header) for name, text in zip(names, plain, strict=False) if text != "-"}
    named = dict(word.split("=", 1) for word in operands if "=" in word)
    fields = {name: _value(name, text, header) for name, text in named.items()}
    up = {"up": fields.pop("up")} if "up" in fields else {}
    info = {"info": fields} if fields and event in ("start", "diag") else fields
    return {"event": event, **up, **made, **info}


def _value(name: str, text: str, header: dict[str, Any]) -> object:
    if text in _JSON:
        return _JSON[text]
    if name in INTEGERS:
        return _number(name, text, 10)
    if name in BYTES:
        return f"B#16#{_number(name, text, 16):02X}"
    if name in WORDS:
        return f"W#16#{_number(name, text, 16):04X}"
    if name in MOMENTS:
        return _moment(text, header)
    if name == "sdt" and "T" not in text:
        return f"{_clock(header)[:10]}T{text}"
    return text


def _number(name: str, text: str, base: int) -> int:
    try:
        return int(text, base)
    except ValueError:
        kind = "whole" if base == 10 else "hexadecimal"
        raise ValueError(f"a {kind} number for {name}; found {text}") from None


def _one_of(known: Iterable[str], text: str) -> str:
    if text not in known:
        raise ValueError(f"one of {', '.join(known)}; found {text or 'nothing'}")
    return text


def _clock(header: dict[str, Any]) -> str:
    if "clock" not in header:
        raise ValueError("clock=, the header's clock, before a time that begins like it")
    return str(header["clock"])


def _moment(text: str, header: dict[str, Any]) -> str:
    """A date and time: in full, or as hours, minutes and seconds of the day of the header's clock.

    Minutes and seconds alone are those of its hour. It is written as finely as the header's clock.
    """
    if "T" in text:
        return text
    if not _TIME.fullmatch(text):
        raise ValueError(f"a time, [H:]M:S or in full; found {text}")
    clock = _clock(header)
    hours, minutes, seconds = (text if text.count(":") == 2 else f"{clock[11:13]}:{text}").split(":")
    since = timedelta(hours=int(hours), minutes=int(minutes), seconds=float(seconds))
    fine = "milliseconds" if "." in seconds or "." in clock else "seconds"
    return (datetime.fromisoformat(clock[:10]) + since).isoformat(timespec=fine)
