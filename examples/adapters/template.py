"""A template of an adapter for `s7check kit run`: copy it, and put your CPU in the place of `ToyCpu`."""

import json
import sys
from datetime import datetime, timedelta

from toy_cpu import ToyCpu, UnsupportedError

HEADER = ("cpu", "obs", "clock", "mode", "cycle", "priority", "step7", "zone", "classes", "queue")


class Adapter:
    """Runs one program: it owns the time, the CPU and the bodies of the OBs that run."""

    cpu_type = ToyCpu

    def __init__(self, program):
        self.program = program
        self.now, self.started, self.stack = 0, {}, []
        self.clock = datetime.fromisoformat(program["header"]["clock"])
        self.cpu = self.cpu_type(program["header"], self)

    def log(self, event, **fields):
        """Called by the CPU for everything that the log format has a line for."""
        at = self.clock + timedelta(milliseconds=self.now)
        line = {"event": event, "at": at.isoformat(timespec="milliseconds"), "up": self.now, **fields}
        if fields.get("ob") != 1 or event not in ("start", "end"):
            print(json.dumps(line))

    def start(self, ob):
        """Called by the CPU when an OB starts: its body for this run."""
        run = self.started[ob] = self.started.get(ob, 0) + 1
        found = {body.get("run", 0): body["steps"] for body in self.program["bodies"] if body["ob"] == ob}
        self.stack.append([ob, list(found.get(run, found.get(0, [])))])

    def stop(self):
        """Called by the CPU in STOP: nothing runs any more."""
        self.stack.clear()

    def step(self):
        """Lets the running OB do its next step; False where there is none that runs or time has to pass."""
        if not self.stack:
            return False
        ob, steps = self.stack[-1]
        if not steps or "end" in steps[0]:
            self.stack.pop()
            self.cpu.ended(ob)
        elif steps[0].get("wait", 0) > 0:
            return False
        else:
            step = steps.pop(0)
            self.cpu.call(step.pop("call"), step) if "call" in step else self.bring_about(step)
        return True

    def bring_about(self, event):
        """Sets the clock to a date, or moves it; SFC 51 and a wait of 0 do nothing, the CPU knows the other events."""
        if event.get("event") == "clock":
            before = self.clock + timedelta(milliseconds=self.now)
            to = datetime.fromisoformat(event["to"]) if "to" in event else before + timedelta(milliseconds=event["by"])
            self.log("clock", to=to.isoformat(timespec="milliseconds"))
            self.clock += to - before
            self.cpu.clock_set(before, to)
        elif event.get("event", "state") != "state":
            self.cpu.outside(event)

    def run(self):
        """Runs the program to its end."""
        outside = list(self.program["outside"])
        if any("every" in event for event in outside):
            raise UnsupportedError("no events that come again")
        while self.now < self.program["duration"]:
            while outside and outside[0]["after"] <= self.now:
                self.bring_about(outside.pop(0))
            self.cpu.poll()
            if self.cpu.dispatch() or self.step():
                continue
            moments = [self.program["duration"], self.cpu.next_moment(), *(event["after"] for event in outside[:1])]
            waiting = self.stack[-1][1][0] if self.stack and self.cpu.runs() else None
            if waiting:
                moments.append(self.now + waiting["wait"])
            passed = max(1, min(moments) - self.now)
            if waiting:
                waiting["wait"] -= passed
            self.now += passed


def main(adapter):
    """Runs the programs on standard input, each with an `adapter` of its own."""
    for program in map(json.loads, sys.stdin):
        own = {name: value for name, value in program["header"].items() if name in HEADER}
        print(json.dumps({"format": "s7-interrupt-log/1", "latency_ms": 0, **own}))
        try:
            adapter(program).run()
            print(json.dumps({"event": "done"}), flush=True)
        except UnsupportedError as error:
            print(json.dumps({"event": "skip", "reason": str(error)}), flush=True)


if __name__ == "__main__":
    main(Adapter)
