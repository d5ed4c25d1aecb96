"""Stands in for the engine: answers by rules that a test can foresee.

``fake_engine.py [TRANSCRIPT]``: what it was sent goes to the file TRANSCRIPT.

A line that is no JSON object, that is too long, or that has no number where one is needed, is unusable. An EN_AIRT that
does not answer 0 is rejected, ``hold`` is not covered, ``stop`` makes it fail in a
way that depends on its cause. Everything else is accepted.
"""

import json
import os
import signal
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

Answer = dict[str, Any]


def _crash() -> None:
    print("Exception in thread main\n\tat somewhere", file=sys.stderr, flush=True)
    os._exit(1)


def _exhaust() -> None:
    print("Terminating due to java.lang.OutOfMemoryError: Java heap space", file=sys.stderr, flush=True)
    os._exit(3)


def _babble() -> None:
    print("no JSON \x1b[31m", flush=True)


def _die() -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def _sleep() -> None:
    time.sleep(60)


FAILURES: dict[int, Callable[[], None]] = {
    0x51EE: _sleep,
    0xDEAD: _crash,
    0x0003: _exhaust,
    0xBABE: _babble,
    0x0009: _die,
}


MOMENT = {"min": 19_401_479, "ms": 31_000}
SITUATION = {
    "mode": "RUN",
    "clock": MOMENT,
    "running": [{"ob": 1, "class": 1}, {"ob": 40, "class": 16}],
    "delay": 1,
    "pending": [{"ob": 81, "class": 25, "since": MOMENT}],
    "loaded": [1, 40, 80, 81],
    "said": [["mode", "RUN, clock 2026-11-21T05:59:31.000"], ["loaded", "OB 1, 40, 80-81"]],
}
CANDIDATE = {
    "action": "EnAirt(16#0001)",
    "conjunct": "ret = delay - 1",
    "values": "delay - 1 = 16#0000",
    "place": "Airt:30",
    "requirements": ["AIRT-07"],
}
REFUSAL: Answer = {
    "message": "no behaviour of the specification explains this line",
    "expected": [{"event": "EN_AIRT", "ob": 0, "field": "ret", "value": 0, "text": "EN_AIRT ret=16#0000"}],
    "requirements": ["AIRT-07"],
    "why": "It cannot.",
    "wanted": ["EN_AIRT ret=16#0000"],
    "states": 2,
    "situations": [SITUATION],
    "candidates": [CANDIDATE],
    "decision": [["expected", ["EN_AIRT ret=16#0000"]], ["requirements", ["AIRT-07"]], ["why not", ["It cannot."]]],
    "rules": ["AIRT-07 Calls are counted."],
    "before": [["before the line 1 of 2", ["mode: RUN", "loaded: OB 1"]]],
    "formulas": ["EnAirt(16#0001) does not explain the line: ret = delay - 1 [AIRT-07, Airt:30]"],
}
EXPLAINED = "the specification explains every event"
ALTERNATIVES: Answer = {
    "families": ["S7-300", "S7-400"],
    "profiles": ["2006"],
    "choices": [["AMB-01", ["a", "c"]], ["AMB-12", ["a", "b"]]],
    "letters": [["AMB-01", ["a", "c"]], ["AMB-12", ["a", "b"]]],
    "defaults": [["AMB-01", "c"], ["AMB-12", "a"]],
}


def judge(event: dict[str, Any], line: int, explained: int) -> Answer | None:
    """The answer that ``event`` decides, or None if the log goes on."""
    if event["event"] == "EN_AIRT" and event["ret"]:
        return {
            "verdict": "rejected",
            "line": line,
            "events": explained,
            **{name: REFUSAL[name] for name in ("expected", "requirements", "message")},
        }
    if event["event"] == "hold":
        message = "hold is not covered by the specification"
        return {"verdict": "error", "message": message, "line": line, "events": explained}
    FAILURES.get(event.get("cause", -1), lambda: None)()
    return None


LONGEST = 1 << 20


class UnusableError(Exception):
    """What is expected and found, and in which field."""


def fields_of(text: bytes) -> dict[str, Any]:
    """The fields of a line, numbers as numbers."""
    try:
        fields = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise UnusableError("a JSON object", str(error)) from error
    if not isinstance(fields, dict) or not {"event", "format"} & fields.keys():
        raise UnusableError("a JSON object", "another one")
    for name in {"ret", "cause", "up"} & fields.keys():
        value = fields[name]
        try:
            fields[name] = int(value[3:], 16) if isinstance(value, str) and value.startswith("16#") else int(value or 0)
        except (ValueError, TypeError, OverflowError) as error:
            expected = 'a word such as "W#16#8090" or an integer -32768..65535, or null'
            raise UnusableError(expected, json.dumps(value), name) from error
    return fields


class Log:
    """A log that comes in pieces."""

    def __init__(self, beginning: dict[str, Any]) -> None:
        self.answer: Answer | None = None
        self._begun = beginning
        self._rest = b""
        self._line = 0
        self._explained = 0
        self._header = False
        self._lenient = False
        self._steps: list[Answer] = []

    def take(self, data: bytes) -> None:
        """The next piece."""
        if self.answer is not None:
            return
        *lines, self._rest = (self._rest + data).split(b"\n")
        for text in lines:
            self._line += 1
            if self.answer is None and text.strip():
                self._take_line(text)
        if len(self._rest) > LONGEST and self.answer is None:
            self._line += 1
            self._unusable("a shorter line", "a longer one")

    def _take_line(self, text: bytes) -> None:
        try:
            fields = fields_of(text)
        except UnusableError as error:
            self._unusable(*error.args)
            return
        if not self._header:
            self._header = "format" in fields
            letters = {**fields.get("readings", {}), **self._begun.get("chosen", {}).get("readings", {})}
            self._lenient = letters.get("AMB-12") == "b"
            if not self._header:
                self._unusable("the header", "an event")
            return
        if "event" not in fields or (fields["event"] == "EN_AIRT" and "ret" not in fields):
            self._unusable("an event", "none")
            return
        decided = None if self._lenient else judge(fields, self._line, self._explained)
        if decided is not None:
            self._say(decided)
            return
        self._explained += 1
        if "follow" in self._begun:
            self._steps.append({"line": self._line, "situation": SITUATION})

    def _unusable(self, expected: str, found: str, field: str | None = None) -> None:
        unusable = {"expected": expected, "found": found, "line": self._line, "field": field}
        self._say({"verdict": "unusable", "unusable": unusable, "events": self._explained})

    def finish(self) -> None:
        """The end."""
        self.take(b"\n" if self._rest else b"")
        if self.answer is None and not self._header:
            self._line = 1
            self._unusable("a header", "an empty log")
        if self.answer is None:
            self._say({"verdict": "accepted", "events": self._explained, "message": EXPLAINED})

    def _say(self, answer: Answer) -> None:
        self.answer = answer | ({"steps": self._steps} if self._steps else {})
        print(json.dumps(self.answer), flush=True)


HEADER = {"cpu": "S7-400", "profile": "", "readings": []}


def header_of(data: bytes, chosen: dict[str, Any]) -> dict[str, Any]:
    """The header that is read in the begin of a log."""
    readings = json.loads(data.split(b"\n")[0]).get("readings", {}) | chosen.get("readings", {})
    return HEADER | {"readings": list(map(list, readings.items()))}


def others(readings: dict[str, str], rules: list[str]) -> list[Answer]:
    """The headers beside one with these readings; those of the rules matter most."""
    own = dict(ALTERNATIVES["defaults"]) | readings
    letters = [(name, letter) for name, letters in ALTERNATIVES["letters"] for letter in letters if letter != own[name]]
    return [
        {"kind": "cpu", "change": "cpu S7-300", "chosen": {"cpu": "S7-300"}},
        {"kind": "profile", "change": "profile 2006", "chosen": {"profile": "2006"}},
        *(
            {"kind": "letter", "change": f"{n} {a}", "chosen": {"readings": {n: a}}, "distance": 3 * (n not in rules)}
            for n, a in letters
        ),
    ]


def main() -> None:
    """Serves logs until the end of the input."""
    print(json.dumps({"engine": "ready", "tlc": "none"}), flush=True)
    log = Log({})
    for line in sys.stdin.buffer:
        entry = json.loads(line)
        data = sys.stdin.buffer.read(entry.get("count", 0))
        for transcript in sys.argv[1:]:
            with Path(transcript).open("ab") as file:
                file.write(line + data)
        match entry["message"]:
            case "alternatives":
                print(json.dumps({"alternatives": ALTERNATIVES}), flush=True)
            case "decisions":
                print(json.dumps({"decisions": []}), flush=True)
            case "kind":
                print(json.dumps({"object": {"kind": None, "what": None}}), flush=True)
            case "read":
                header = header_of(data, entry.get("chosen", {}))
                rules = entry.get("others", {}).get("rules", [])
                print(json.dumps({"header": header, "others": others(dict(header["readings"]), rules)}), flush=True)
            case "readings":
                passing = [one["change"] for one in entry["tried"] if one["verdict"] == "accepted"]
                parts = [["would pass with", passing], ["not tried", entry["untried"]]]
                print(json.dumps({"parts": [part for part in parts if part[1]]}), flush=True)
            case "texts":
                print("{}", flush=True)
            case "rejected":
                print(json.dumps({"refusal": REFUSAL}), flush=True)
            case "begin":
                log = Log(entry)
            case "bytes":
                log.take(data)
            case "verdict" if log.answer is None:
                print('{"verdict":"open"}', flush=True)
            case "finish":
                log.finish()


if __name__ == "__main__":
    main()
