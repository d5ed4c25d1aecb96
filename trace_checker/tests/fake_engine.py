"""Stands in for the engine: answers by rules that a test can foresee.

``fake_engine.py [TRANSCRIPT]``: what it was sent goes to the file TRANSCRIPT.

An EN_AIRT that does not answer 0 is rejected, ``hold`` is not covered, ``stop`` makes it fail in a
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
}
CANDIDATE = {
    "action": "EnAirt(1)",
    "conjunct": "ret = delay - 1",
    "values": "delay - 1 = 0",
    "place": "Airt:30",
    "requirements": ["AIRT-07"],
}
ALTERNATIVES = {
    "families": ["S7-300", "S7-400"],
    "profiles": ["2006"],
    "letters": [["AMB-01", ["a", "c"]], ["AMB-12", ["a", "b"]]],
    "defaults": [["AMB-01", "c"], ["AMB-12", "a"]],
}


def judge(event: dict[str, Any], explained: int) -> Answer | None:
    """The answer that ``event`` decides, or None if the log goes on."""
    if event["event"] == "EN_AIRT" and event["ret"] > 0:
        return {
            "verdict": "rejected",
            "line": event["line"],
            "events": explained,
            "expected": [{"event": "EN_AIRT", "ob": 0, "field": "ret", "value": 0}],
            "requirements": ["AIRT-07"],
            "states": 2,
            "situations": [SITUATION],
            "candidates": [CANDIDATE],
        }
    if event["event"] == "hold":
        message = "hold is not covered by the specification"
        return {"verdict": "error", "message": message, "line": event["line"], "events": explained}
    FAILURES.get(event.get("cause", -1), lambda: None)()
    return None


def main() -> None:
    """Serves logs until the end of the input."""
    print(json.dumps({"engine": "ready", "tlc": "none"}), flush=True)
    explained, answer, lenient = 0, None, False
    steps: list[Answer] | None = None
    for line in sys.stdin:
        for transcript in sys.argv[1:]:
            with Path(transcript).open("a") as file:
                file.write(line)
        entry = json.loads(line)
        message = entry.get("message")
        if message == "alternatives":
            print(json.dumps({"alternatives": ALTERNATIVES}), flush=True)
        elif message == "begin":
            explained, answer = 0, None
            lenient = ["AMB-12", "b"] in entry["header"]["readings"]
            steps = [] if "follow" in entry else None
        elif message == "decisions":
            print(json.dumps({"decisions": []}), flush=True)
        elif message == "verdict":
            if answer is None:
                print('{"verdict":"open"}', flush=True)
        elif answer is None:
            accepted = {"verdict": "accepted", "events": explained}
            answer = accepted if message == "finish" else None if lenient else judge(entry, explained)
            explained += 1
            if steps is not None and "line" in entry and not answer:
                steps.append({"line": entry["line"], "situation": SITUATION})
            if answer:
                answer |= {"steps": steps} if steps else {}
                print(json.dumps(answer), flush=True)


if __name__ == "__main__":
    main()
