"""A log as a picture: lanes by priority class, with OBs that ran or waited, calls, and lost start events."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from s7check.engine.answer import Pending, Situation
from s7check.log.errors import UnusableLogError, printable, ranges
from s7check.log.objects import decoded
from s7check.report.markup import Node, add, node
from s7check.report.report import Report, source

_MOST = 80
_AFTER = 2
_COLUMN = 116.0
_LABELS = 118.0
_LEFT = 8.0
_HEAD = 66.0
_LANE = 58.0
_STRIP = 20.0
_CALLS = ("TINT", "DINT", "IRT", "AIRT")
_NEGATIVE = 0x8000
_NO_LANE = "no effect"
"""The strip for start events of OBs that neither run nor wait in any situation, so that no class is known."""


@dataclass(frozen=True)
class _Column:
    """A line of the log; ``state`` is the situation after it, before it for the rejected one, None later."""

    number: int
    text: bytes
    event: dict[str, Any]
    state: Situation | None
    x: float


@dataclass(frozen=True)
class Picture:
    """A timeline: ``labels`` stay in view while ``lanes`` are scrolled; it has the lines ``first`` to ``last``."""

    labels: Node
    lanes: Node
    first: int
    last: int


class _Rows:
    """Where the lanes and the strips above them are; ``apart``: an OB of unknown class has a place of its own."""

    def __init__(self, states: list[Situation], named: set[int]) -> None:
        frames = {(one.class_, one.ob) for state in states for one in state.running}
        frames |= {(one.class_, one.ob) for state in states for one in state.pending}
        self.classes = sorted({number for number, _ in frames} | {1}, reverse=True)
        self.obs = {number: {ob for other, ob in frames if other == number} or {1} for number in self.classes}
        self.strips = ["mode"]
        if named - {ob for _, ob in frames}:
            self.strips.append(_NO_LANE)
        if any(state.delay for state in states):
            self.strips.append("delayed")
        if any(state.blocked for state in states):
            self.strips.append("blocked")
        self._lanes = _HEAD + len(self.strips) * _STRIP + 8
        self.height = self._lanes + len(self.classes) * _LANE + 8

    def strip(self, name: str) -> float:
        return _HEAD + self.strips.index(name) * _STRIP

    def lane(self, number: int) -> float:
        return self._lanes + self.classes.index(number) * _LANE

    def lost(self, ob: int) -> float:
        """Where a start event of this OB comes to nothing: below what runs and waits in its class."""
        found = [number for number in self.classes if ob in self.obs[number]]
        return self.lane(found[0]) + 49 if found else self.strip(_NO_LANE) + 8


def timeline(report: Report) -> Picture | None:
    """The picture as SVG, or None where the situations after the lines are not known."""
    columns = _columns(report)
    if not columns:
        return None
    states = [column.state for column in columns if column.state] + report.situations
    lost = {ob for column in columns if (ob := _interrupt(column.event)) is not None}
    rows = _Rows(states, lost)
    width = _LEFT + len(columns) * _COLUMN + 20
    first, last = columns[0].number, columns[-1].number
    labels = _svg(_LABELS, rows.height, *_lanes(rows, _LABELS), *_labels(rows), aria_hidden="true")
    about = f"timeline of lines {first} to {last}"
    svg = _svg(width, rows.height, *_lanes(rows, width), role="img", aria_label=about)
    add(svg, *_bands(columns, rows, report), *_strips(columns, rows), *_bars(columns, rows))
    for before, column in zip([None, *columns[:-1]], columns, strict=True):
        add(svg, *_line(column, before, rows, report))
    add(svg, *_expected(report, columns, rows))
    return Picture(labels, svg, first, last)


def legend() -> Node:
    """The marks of the pictures in words. It has the patterns that all pictures of a page use."""
    items = [
        (node("rect", x=2, y=2, width=20, height=12, rx=3, class_="runs"), "OB runs"),
        (node("rect", x=2, y=2, width=20, height=12, rx=3, class_="interrupted"), "OB is interrupted"),
        (node("rect", x=2, y=2, width=20, height=12, rx=3, class_="waiting"), "start event is pending"),
        (node("rect", x=2, y=2, width=20, height=12, rx=3, class_="ghost"), "OB had to start"),
        (node("circle", cx=12, cy=8, r=5, class_="call fine"), "call, RET_VAL below 16#8000"),
        (node("circle", cx=12, cy=8, r=5, class_="call error"), "call, RET_VAL from 16#8000"),
        (node("circle", cx=12, cy=8, r=5, class_="call wrong"), "call whose answer is rejected"),
        (_cross(12, 8), "start event has no effect"),
        (node("rect", x=2, y=2, width=20, height=12, class_="jump"), "clock is set"),
        (node("rect", x=2, y=2, width=20, height=12, class_="band"), "rejected line"),
    ]
    marks = [node("li", _svg(24, 16, mark, aria_hidden="true"), text) for mark, text in items]
    return node("ul", patterns(), *marks, class_="legend")


def patterns() -> Node:
    """The patterns by which the marks of all pictures are filled, without a mark of their own."""

    def hatch(name: str, colour: str) -> Node:
        return node(
            "pattern",
            node("rect", width=6, height=6, class_=f"{colour} soft"),
            node("path", d="M0 6L6 0", class_=f"{colour} hatch"),
            id=name,
            width=6,
            height=6,
            patternUnits="userSpaceOnUse",
        )

    return _svg(0, 0, node("defs", hatch("interrupted", "runs"), hatch("waiting", "waits")), aria_hidden="true")


def _svg(width: float, height: float, *content: Node, **attributes: str) -> Node:
    box = f"0 0 {width:g} {height:g}"
    return node("svg", *content, viewBox=box, width=width, height=height, **attributes)


def _columns(report: Report) -> list[_Column]:
    after = {step.line: step.situation for step in report.steps}
    last = report.line if report.verdict == "rejected" else None
    if last is not None and report.situations:
        after[last] = report.situations[0]
    shown: list[tuple[int, bytes, dict[str, Any]]] = []
    for number, text in enumerate(report.lines, 1):
        if number in after or (last is not None and last <= number <= last + _AFTER):
            event = _event(text)
            if event is not None:
                shown.append((number, text, event))
    return [
        _Column(number, text, event, after.get(number), _LEFT + i * _COLUMN)
        for i, (number, text, event) in enumerate(shown[-_MOST:])
    ]


def _event(text: bytes) -> dict[str, Any] | None:
    """The event as the log spells it; None for a line without one, which may follow the deciding line."""
    try:
        event = decoded(text)
    except UnusableLogError:
        return None
    return event if isinstance(event.get("event"), str) and isinstance(event.get("ob", 0), int) else None


# ---------------------------------------------------------------------------- the parts of the picture


def _lanes(rows: _Rows, width: float) -> Iterator[Node]:
    for i, number in enumerate(rows.classes):
        colour = f"lane {'even' if i % 2 else 'odd'}"
        yield node("rect", x=0, y=rows.lane(number), width=width, height=_LANE, class_=colour)


def _bands(columns: list[_Column], rows: _Rows, report: Report) -> Iterator[Node]:
    """Behind all else the rejected line, and lines that set the clock."""
    for column in columns:
        offending = report.verdict == "rejected" and column.number == report.line
        if offending or column.event["event"] == "clock":
            colour = "band" if offending else "jump"
            yield node("rect", x=column.x, y=0, width=_COLUMN, height=rows.height, class_=colour)


def _labels(rows: _Rows) -> Iterator[Node]:
    for name in rows.strips:
        yield node("text", name, x=8, y=rows.strip(name) + 14, class_="label")
    for number in rows.classes:
        top, obs = rows.lane(number), f"OB {ranges(rows.obs[number])}"
        yield node("text", f"class {number}", x=8, y=top + 19, class_="label strong")
        yield node("text", node("title", obs), _fitting(obs, _LABELS - 12, bold=False), x=8, y=top + 35, class_="label")


def _strips(columns: list[_Column], rows: _Rows) -> Iterator[Node]:
    def strip(name: str, value: Any, class_: str) -> Iterator[Node]:
        for text, first, end in _runs(columns, value):
            if text:
                y = rows.strip(name)
                title = node("title", f"{name}: {text}")
                yield node("rect", title, x=first, y=y, width=end - first, height=_STRIP - 4, rx=3, class_=class_)
                yield node("text", _fitting(text, end - first - 8, 11), x=first + 5, y=y + 12, class_="on")

    for text, first, end in _runs(columns, lambda state: state.mode):
        y = rows.strip("mode")
        yield node("rect", x=first, y=y, width=end - first, height=_STRIP - 4, rx=3, class_=f"mode {text}")
        yield node("text", text, x=first + 5, y=y + 12, class_="on")
    if "delayed" in rows.strips:
        yield from strip("delayed", lambda state: f"delay count {state.delay}" if state.delay else "", "delay")
    if "blocked" in rows.strips:
        yield from strip("blocked", lambda s: f"OB {ranges(s.blocked)}" if s.blocked else "", "block")


def _runs(columns: list[_Column], value: Any) -> Iterator[tuple[str, float, float]]:
    """Stretches of columns with one value, with their first and last position."""
    begun: tuple[str, float] | None = None
    for column in columns:
        now = value(column.state) if column.state else None
        if begun is not None and begun[0] != now:
            yield begun[0], begun[1], column.x
            begun = None
        if begun is None and now is not None:
            begun = (now, column.x)
    if begun is not None:
        yield begun[0], begun[1], columns[-1].x + _COLUMN


def _bars(columns: list[_Column], rows: _Rows) -> Iterator[Node]:
    obs = {(one.ob, one.class_) for column in columns if column.state for one in column.state.running}
    for ob, number in sorted(obs):

        def how(state: Situation, ob: int = ob) -> str:
            if not any(frame.ob == ob for frame in state.running):
                return ""
            return "runs" if state.running[-1].ob == ob else "interrupted"

        named = False
        for style, first, end in _runs(columns, how):
            if not style:
                named = False
                continue
            y = rows.lane(number) + 6
            bar = node("rect", node("title", f"OB {ob} {style}"), x=first, y=y, width=end - first, height=20, rx=3)
            bar.set("class", "runs" if style == "runs" else "interrupted")
            yield bar
            if not named or style == "runs":
                text_class = "on" if style == "runs" else "in"
                yield node("text", f"OB {ob}", x=first + 6, y=y + 14, class_=text_class)
            named = True
    for number in rows.classes:

        def waits(state: Situation, number: int = number) -> str:
            ordered = sorted((one for one in state.pending if one.class_ == number), key=lambda one: one.rank)
            return ", ".join(dict.fromkeys(_pending(one) for one in ordered))

        for text, first, end in _runs(columns, waits):
            if text:
                y = rows.lane(number) + 29
                yield node(
                    "rect", node("title", text), x=first, y=y, width=end - first, height=11, rx=3, class_="waiting"
                )
                yield node(
                    "text", _fitting(text, end - first - 8, 9.5, bold=False), x=first + 5, y=y + 9, class_="small"
                )


def _pending(one: Pending) -> str:
    fault = f" fault 16#{one.fault:02X}" if one.fault > 0 else ""
    return f"OB {one.ob} {'may be pending' if one.open else 'pending'}{fault}"


def _line(column: _Column, before: _Column | None, rows: _Rows, report: Report) -> Iterator[Node]:
    """The line's number, time and words above, and its mark in the lanes."""
    offending = report.verdict == "rejected" and column.number == report.line
    later = report.verdict == "rejected" and report.line is not None and column.number > report.line
    answer = "wrong" if offending else _class_of_answer(column.event)
    kind = "offending" if offending else "later" if later else "event"
    group = node("g", class_=kind, data_line=str(column.number))
    x = column.x
    add(group, node("path", d=f"M{x:g} 4V{rows.height:g}", class_="tick"))
    add(group, node("title", source(column.text)))
    head = [f"{column.number}", _clock(column, before), *_words(column.event)]
    for i, text in enumerate(head):
        class_, size = (("number", 10), ("time", 11), ("what", 12), (answer, 12))[i]
        fitting = _fitting(text, _COLUMN - 6, size, bold=class_ == "what")
        add(group, node("text", fitting, x=x + 4, y=13 + i * 15, class_=class_))
    state = before.state if before else column.state
    if column.event["event"].endswith(_CALLS) and state and state.running:
        y = rows.lane(state.running[-1].class_) + 16
        add(group, node("circle", cx=x, cy=y, r=5, class_=f"call {answer}"))
    if column.state and before and before.state and not offending:
        found: dict[float, list[str]] = {}
        for ob, why in _come_to_nothing(column, before.state):
            found.setdefault(rows.lost(ob), []).append(why)
        for y, reasons in found.items():
            why = ", ".join(reasons)
            add(group, _cross(x, y, node("title", why)))
            add(
                group,
                node("text", _fitting(why, _COLUMN - 12, 9.5, bold=False), x=x + 8, y=y + 4, class_="small nothing"),
            )
    yield group


def _cross(x: float, y: float, title: Node | None = None) -> Node:
    return node("path", title, d=f"M{x - 4:g} {y - 4:g}l8 8m0 -8l-8 8", class_="lost")


def _come_to_nothing(column: _Column, before: Situation) -> Iterator[tuple[int, str]]:
    """OBs whose start events neither wait nor have started after the line, and the words for it."""
    state = column.state
    assert state is not None
    kept = {one.ob for one in state.pending} | {frame.ob for frame in state.running}
    for lost in dict.fromkeys(one.ob for one in before.pending if one.ob not in kept and not one.open):
        yield lost, f"OB {lost} gone"
    ob = _interrupt(column.event)
    if ob is not None and ob not in kept:
        yield ob, f"OB {ob}: no effect"


def _interrupt(event: dict[str, Any]) -> int | None:
    """The OB whose start event comes from outside in this line."""
    return event["ob"] if event["event"] == "interrupt" else None


def _expected(report: Report, columns: list[_Column], rows: _Rows) -> Iterator[Node]:
    """The OB that had to start, as a ghost in its lane."""
    column = next((one for one in columns if one.number == report.line), None)
    if report.verdict != "rejected" or column is None:
        return
    for state in report.situations[:1]:
        due: dict[int, list[int]] = {}
        for request in state.pending:
            if request.ready and not request.missing:
                due.setdefault(request.class_, []).append(request.ob)
        for number, obs in due.items():
            y = rows.lane(number) + 6
            text = f"OB {ranges(set(obs))} due"
            box = node("rect", node("title", text), x=column.x + 3, y=y, width=_COLUMN - 6, height=20, rx=3)
            box.set("class", "ghost")
            yield box
            yield node("text", _fitting(text, _COLUMN - 14), x=column.x + 8, y=y + 14, class_="due")


# ---------------------------------------------------------------------------- words


def _clock(column: _Column, before: _Column | None) -> str:
    """The time of day, with the date where it is another than that of the line before."""
    at = str(column.event.get("at", "")).removeprefix("DT#")
    date, time = at[:10], at[11:]
    if before is not None and str(before.event.get("at", "")).removeprefix("DT#")[:10] == date:
        return printable(time, 14)
    return printable(f"{date[5:]} {time[:8]}", 16)


def _words(event: dict[str, Any]) -> list[str]:
    name = str(event["event"])
    if name.endswith(_CALLS):
        operand = f" {event['ob']}" if "ob" in event else ""
        return [f"{name}{operand}", _answer(event)]
    if name == "clock":
        return ["clock set", f"to {str(event.get('to', ''))[11:]}"]
    if name in ("restart", "stop", "diag"):
        return [name, str(event.get("type") or event.get("cause") or event.get("id") or "")]
    text = f"{name} OB {event['ob']}" if "ob" in event else name
    info = event.get("info")
    fault = info.get("flt_id") if isinstance(info, dict) else event.get("flt_id")
    return [text, f"fault {fault}" if fault is not None else ""]


def _number(value: object) -> int | None:
    if isinstance(value, int):
        return value & 0xFFFF
    try:
        return int(str(value).rsplit("#", 1)[-1], 16)
    except ValueError:
        return None


def _answer(event: dict[str, Any]) -> str:
    ret = _number(event.get("ret"))
    text = "not logged" if event.get("ret") is None or ret is None else f"= {ret:04X}"
    status = _number(event.get("status")) if "status" in event else None
    return text if status is None else f"{text} st {status:04X}"


def _class_of_answer(event: dict[str, Any]) -> str:
    ret = _number(event.get("ret"))
    return "error" if ret is not None and ret >= _NEGATIVE else "fine"


def _fitting(text: str, width: float, size: float = 12, bold: bool = True) -> str:
    """The text, or as much of it as surely has room in ``width`` pixels with letters of ``size`` pixels."""
    room = width / size / (1 if bold else 0.9)
    if sum(map(_breadth, text)) <= room:
        return text
    room -= 1
    kept = 0
    while kept < len(text) and (room := room - _breadth(text[kept])) >= 0:
        kept += 1
    return text[:kept] + "…"


def _breadth(letter: str) -> float:
    """At most so many times its size a bold letter is broad in the usual fonts."""
    if letter in " .,:;'il|j()":
        return 0.42
    if letter in "tfr-":
        return 0.5
    if letter in "mwMW%@" or letter > "\x7f":
        return 1.1
    return 0.78 if letter.isupper() or letter in "_=" else 0.7
