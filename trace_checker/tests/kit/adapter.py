"""An adapter that does as the name of the program says: a log file, or a way to fail."""

import json
import os
import sys
import time
from pathlib import Path

HEADER = ("cpu", "obs", "clock", "mode", "cycle", "priority", "step7")


def header(program: dict[str, dict[str, object]]) -> str:
    """The first line of a log."""
    own = {name: value for name, value in program["header"].items() if name in HEADER}
    return json.dumps({"format": "s7-interrupt-log/1", **own})


for line in sys.stdin:
    program = json.loads(line)
    way = program["name"].partition("-")[2]
    if way == "crash":
        print(header(program), flush=True)
        print("out of cheese", file=sys.stderr)
        os._exit(7)
    if way == "hang":
        time.sleep(60)
    if way == "skip":
        print(json.dumps({"event": "skip", "reason": "no HOLD"}), flush=True)
        continue
    if way == "garbage":
        print("hello")
    elif way == "other":
        print(json.dumps({"format": "s7-interrupt-log/1", "cpu": "S7-300", "obs": [1], "clock": "2026-01-01T00:00"}))
    elif way != "empty":
        print(header(program))
        print(Path(sys.argv[1], f"{way}.events").read_text(encoding="utf-8"), end="")
    print(json.dumps({"event": "done"}), flush=True)
