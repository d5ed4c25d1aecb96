"""Logs drawn from a seed: random programs on the soft PLC, as they are or changed."""

from __future__ import annotations

import copy
import json
import subprocess
from dataclasses import dataclass
from datetime import timedelta
from pathlib import Path
from random import Random

from evidence.logs import damage, setups
from evidence.logs.damage import Log
from s7check.engine.answer import Alternatives

UNCHANGED = "as it is"
FAULTY = "a mistake of the soft PLC"
LEFT_OUT = "kinds left out"
READINGS = "header: readings"
PROFILE = "header: profile"

TIMES = (0, 1, 1, 2)
"""How often a log is changed; about half of the logs are accepted then."""

LONGEST = timedelta(hours=1)
"""A clock that runs longer from one event to the next reaches many start points; the soft PLC's takes minutes."""


class SoftPlcError(RuntimeError):
    """The soft PLC is not there or failed; the text says how."""


@dataclass(frozen=True)
class Generated:
    """A log as bytes, the CPU of its header, and its changes; an unchanged log has `UNCHANGED` alone."""

    content: bytes
    cpu: str
    done: tuple[str, ...]

    @property
    def lines(self) -> int:
        """How many physical lines it has."""
        return self.content.count(b"\n")


class Generator:
    """Draws logs. The same seed, number and attempt give the same log."""

    def __init__(self, seed: int, soft_plc: Path, words: Alternatives) -> None:
        """`words` are those that headers and lines may have. Raises `SoftPlcError`."""
        self._seed = seed
        self._soft_plc = soft_plc
        self._words = words
        told = self._run("--fault", "help")
        self._faults = [line.split()[0] for line in told.splitlines() if line.strip()]
        self._behaviours = dict(map(_behaviour, self._run("--choose", "help").splitlines()))

    def draw(self, number: int, attempt: int) -> Generated:
        """Draw a log, which may be unreadable. Raises `SoftPlcError`."""
        random = Random(f"{self._seed}/{number}/{attempt}")  # noqa: S311
        log, done = self._written(random)
        if random.random() < 0.12:
            damage.leave_out(random, log)
            done.append(LEFT_OUT)
        if random.random() < 0.2:
            damage.ask_for_readings(random, log, self._words)
            done.append(READINGS)
        if random.random() < 0.05:
            damage.ask_for_profile(random, log, self._words)
            done.append(PROFILE)
        weights = [one.weight for one in damage.DAMAGES]
        for chosen in random.choices(damage.DAMAGES, weights, k=random.choice(TIMES)):
            before = copy.deepcopy(log)
            if log.events:
                chosen.do(random, log, self._words)
            if damage.elapses(log) > LONGEST:
                log = before
            elif log != before:
                done.append(chosen.what)
        return Generated(_text(random, log), log.header["cpu"], tuple(dict.fromkeys(done)) or (UNCHANGED,))

    def written(self, random: Random, events: int | None = None) -> Log:
        """A log as the soft PLC writes it, without a mistake, of so many events. Raises `SoftPlcError`.

        What the requirements leave open it does in one of the ways that it has. OBs that start at once leave no
        order open (AMB-69).
        """
        options = [option for option in ("--up", "--state") if random.random() < 0.5]
        program = setups.scenario(random, self._words, events)
        at_once = json.loads(program)["x_soft_plc"]["latency_ms"] == 0
        for name, ways in self._behaviours.items():
            if random.random() < 0.4 and not (name == "OBS-03" and at_once):
                options += ["--choose", f"{name}={random.choice(ways)}"]
        header, *lines = map(json.loads, self._run(*options, "-", stdin=program).splitlines())
        return Log(header, lines)

    def _written(self, random: Random) -> tuple[Log, list[str]]:
        scenario = setups.scenario(random, self._words)
        options = ["--up"] if random.random() < 0.4 else []
        done = []
        if random.random() < 0.1:
            options += ["--fault", random.choice(self._faults)]
            done = [FAULTY]
        header, *events = map(json.loads, self._run(*options, "-", stdin=scenario).splitlines())
        return Log(header, events), done

    def _run(self, *arguments: str, stdin: str = "") -> str:
        try:
            run = subprocess.run([self._soft_plc, *arguments], input=stdin, capture_output=True, text=True, check=True)
        except OSError as error:
            raise SoftPlcError(f"the soft PLC is not at {self._soft_plc}: run `make setup`") from error
        except subprocess.CalledProcessError as error:
            raise SoftPlcError(f"the soft PLC failed: {error.stderr.strip()}\n{stdin}") from error
        return run.stdout


def _behaviour(line: str) -> tuple[str, list[str]]:
    """A name and its ways, as the soft PLC tells them: `OBS-03 =highest or lowest: ...`."""
    name, told = line.split("=", 1)
    return name.strip(), told.partition(":")[0].split(" or ")


def _text(random: Random, log: Log) -> bytes:
    """The lines; now and then some are blank, or end as on Windows."""
    lines = [json.dumps(entry) for entry in (log.header, *log.events)]
    if random.random() < 0.1:
        for _ in range(3):
            lines.insert(random.randint(0, len(lines)), "")
    end = "\r\n" if random.random() < 0.05 else "\n"
    return "".join(line + end for line in lines).encode()
