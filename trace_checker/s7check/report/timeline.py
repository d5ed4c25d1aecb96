"""A log as a picture: lanes by priority class, with OBs that ran or waited, calls, and lost start events."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from s7check.engine.answer import Pending, Situation
from s7check.judging.verdict import Report
from s7check.log.errors import UnusableLogError, printable, ranges
from s7check.log.events import read_event
from s7check.log.jsonline import decode_object
from s7check.report.lines import source
from s7check.report.markup import Node, add, node

_MOST = 80
_AFTER = 2
_COLUMN = 96.0
_LEFT = 118.0
_HEAD = 66.0
_LANE = 44.0
_STRIP = 20.0
_CALLS = ("TINT", "DINT", "IRT", "AIRT")
_NEGATIVE = 0x8000


@dataclass(frozen=True)
class _Column:
    """A line of the log; ``state`` is the situation after it, before it for the rejected one, None later."""

    number: int
    text: bytes
    event: dict[str, Any]
    state: Situation | None
    x: float


class _Rows:
    """Where the lanes and the strips above them are."""

    def __init__(self, states: list[Situation]) -> None:
        frames = {(one.class_, one.ob) for state in states for one in state.running}
        frames |= {(one.class_, one.ob) for state in states for one in state.pending}
        self.classes = sorted({number for number, _ in frames} | {1}, reverse=True)
        self.obs = {number: ranges({ob for other, ob in frames if other == number}) or "1" for number in self.classes}
        self.strips = ["mode"]
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


def timeline(report: Report) -> Node | None:
    """The picture as SVG, or None where the situations after the lines are not known."""
    columns = _columns(report)
    if not columns:
        return None
    states = [column.state for column in columns if column.state] + report.situations
    rows = _Rows(states)
    width = _LEFT + len(columns) * _COLUMN + 20
    svg = node(
        "svg",
        *_patterns(),
        *_background(rows, width),
        role="img",
        aria_label="timeline of the log",
        viewBox=f"0 0 {width:g} {rows.height:g}",
        width=width,
        height=rows.height,
    )
    add(svg, *_strips(columns, rows), *_bars(columns, rows))
    for before, column in zip([None, *columns[:-1]], columns, strict=True):
        add(svg, *_line(column, before, rows, report))
    add(svg, *_expected(report, columns, rows))
    return svg


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
        event = decode_object(text)
        read_event(event)
    except UnusableLogError:
        return None
    return event


# ---------------------------------------------------------------------------- the parts of the picture


def _patterns() -> Iterator[Node]:
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

    yield node("defs", hatch("interrupted", "runs"), hatch("waiting", "waits"))


def _background(rows: _Rows, width: float) -> Iterator[Node]:
    for name in rows.strips:
        yield node("text", name, x=8, y=rows.strip(name) + 14, class_="label")
    for i, number in enumerate(rows.classes):
        top = rows.lane(number)
        yield node("rect", x=0, y=top, width=width, height=_LANE, class_=f"lane {'even' if i % 2 else 'odd'}")
        yield node("text", f"class {number}", x=8, y=top + 19, class_="label strong")
        yield node("text", f"OB {rows.obs[number]}", x=8, y=top + 35, class_="label")


def _strips(columns: list[_Column], rows: _Rows) -> Iterator[Node]:
    def strip(name: str, value: Any, class_: str) -> Iterator[Node]:
        for text, first, end in _runs(columns, value):
            if text:
                y = rows.strip(name)
                title = node("title", f"{name}: {text}")
                yield node("rect", title, x=first, y=y, width=end - first, height=_STRIP - 4, rx=3, class_=class_)
                yield node("text", _fitting(text, end - first), x=first + 5, y=y + 12, class_="on")

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
                yield node("text", _fitting(text, (end - first) * 1.3), x=first + 5, y=y + 9, class_="small")


def _pending(one: Pending) -> str:
    fault = f" fault 16#{one.fault:02X}" if one.fault > 0 else ""
    return f"OB {one.ob} {'may be pending' if one.open else 'pending'}{fault}"


def _line(column: _Column, before: _Column | None, rows: _Rows, report: Report) -> Iterator[Node]:
    """The line's number, time and words above, and its mark in the lanes."""
    offending = report.verdict == "rejected" and column.number == report.line
    later = report.verdict == "rejected" and report.line is not None and column.number > report.line
    group = node("g", class_="offending" if offending else "later" if later else "event")
    x = column.x
    if offending:
        add(group, node("rect", x=x, y=0, width=_COLUMN, height=rows.height, class_="band"))
    elif column.event["event"] == "clock":
        add(group, node("rect", x=x, y=0, width=_COLUMN, height=rows.height, class_="jump"))
    add(group, node("path", d=f"M{x:g} 4V{rows.height:g}", class_="tick"))
    add(group, node("title", source(column.text)))
    head = [f"{column.number}", _clock(column, before), *_words(column.event)]
    for i, text in enumerate(head):
        class_ = ("number", "time", "what", _class_of_answer(column.event))[min(i, 3)]
        add(group, node("text", _fitting(text, _COLUMN), x=x + 4, y=13 + i * 15, class_=class_))
    state = before.state if before else column.state
    if column.event["event"].endswith(_CALLS) and state and state.running:
        y = rows.lane(state.running[-1].class_) + 16
        add(group, node("circle", cx=x, cy=y, r=5, class_=f"call {_class_of_answer(column.event)}"))
    if column.state and before and before.state and not offending:
        for number, why in _come_to_nothing(column, before.state, rows):
            y = rows.lane(number) + 34
            cross = node("path", node("title", why), d=f"M{x - 4:g} {y - 4:g}l8 8m0 -8l-8 8", class_="lost")
            add(group, cross, node("text", why, x=x + 8, y=y + 4, class_="small nothing"))
    yield group


def _come_to_nothing(column: _Column, before: Situation, rows: _Rows) -> Iterator[tuple[int, str]]:
    """Start events that neither wait nor have started after the line, with their class."""
    state = column.state
    assert state is not None
    kept = {one.ob for one in state.pending} | {frame.ob for frame in state.running}
    gone = {one.ob: one.class_ for one in before.pending if one.ob not in kept and not one.open}
    for lost, number in gone.items():
        if number in rows.classes:
            yield number, f"OB {lost} gone"
    ob = column.event.get("ob")
    if column.event["event"] == "interrupt" and ob not in kept:
        number = next((n for n in rows.classes if str(ob) in rows.obs[n].split(", ")), rows.classes[-1])
        yield number, f"OB {ob}: no effect"


def _expected(report: Report, columns: list[_Column], rows: _Rows) -> Iterator[Node]:
    """The OB that had to start, as a ghost in its lane."""
    column = next((one for one in columns if one.number == report.line), None)
    if report.verdict != "rejected" or column is None:
        return
    for state in report.situations[:1]:
        for request in state.pending:
            if request.ready and not request.missing and request.class_ in rows.classes:
                y = rows.lane(request.class_) + 6
                yield node("rect", x=column.x + 3, y=y, width=_COLUMN - 6, height=20, rx=3, class_="ghost")
                yield node("text", f"OB {request.ob} due", x=column.x + 8, y=y + 14, class_="due")


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


def _fitting(text: str, width: float) -> str:
    most = max(3, int(width / 6.4))
    return text if len(text) <= most else text[: most - 1] + "…"
