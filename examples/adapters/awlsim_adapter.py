"""Runs the kit's programs as AWL in awlsim, a simulator of S7 in Python that others have written.

awlsim has no interrupts. The bodies of OBs are translated to AWL and run in awlsim's CPU; SFC 28 to 34, 39 to 42 and
the start of OBs come from outside: from `supplied_cpu.py`, by entries in awlsim's table of system functions. An OB is
interrupted between two instructions that call an SFC or work. Needs `pip install -r requirements-awlsim.txt`.
"""

import logging
import sys

import awlsim.core.main  # before its other modules, which import each other
from awlsim.awlcompiler import AwlParser
from awlsim.common.sources import AwlSource
from awlsim.common.util import Logging
from awlsim.core.blockinterface import BlockInterfaceField
from awlsim.core.datatypes import wordToSignedPyInt
from awlsim.core.memory import (
    AwlMemoryObject_asBytes,
    AwlMemoryObject_asScalar,
    make_AwlMemoryObject_fromScalar,
)
from awlsim.core.systemblocks.systemblocks import SFC
from awlsim.core.systemblocks.tables import SFC_table
from supplied_cpu import SuppliedCpu
from template import Adapter, main
from toy_cpu import NEVER, UnsupportedError

IN, OUT = BlockInterfaceField.FTYPE_IN, BlockInterfaceField.FTYPE_OUT
OB_NR = (("OB_NR", "INT"),)
MASK = (("MODE", "BYTE"), *OB_NR)
SFCS = {
    "SET_TINT": (28, (*OB_NR, ("SDT", "DATE_AND_TIME"), ("PERIOD", "WORD")), ()),
    "CAN_TINT": (29, OB_NR, ()),
    "ACT_TINT": (30, OB_NR, ()),
    "QRY_TINT": (31, OB_NR, (("STATUS", "WORD"),)),
    "SRT_DINT": (32, (*OB_NR, ("DTIME", "TIME"), ("SIGN", "WORD")), ()),
    "CAN_DINT": (33, OB_NR, ()),
    "QRY_DINT": (34, OB_NR, (("STATUS", "WORD"),)),
    "DIS_IRT": (39, MASK, ()),
    "EN_IRT": (40, MASK, ()),
    "DIS_AIRT": (41, (), ()),
    "EN_AIRT": (42, (), ()),
}
OPERANDS = {"OB_NR": "ob", "SDT": "sdt", "PERIOD": "period", "DTIME": "dtime", "SIGN": "sign", "MODE": "mode"}
BUSY, RUN = 201, 202
"""SFCs of this adapter: the OB is at work for DTIME ms; which run of the OB this is."""


class StoppedError(Exception):
    """The CPU goes to STOP, or the program ends, while an OB runs."""


class AwlAdapter(Adapter):
    """The bodies as AWL, an OB at a time on awlsim's CPU."""

    cpu_type = SuppliedCpu
    current = None

    def __init__(self, program):
        AwlAdapter.current = self
        self.begun = []
        self.outside = list(program["outside"])
        self.cycles = [body for body in program["bodies"] if body["ob"] == 1]
        if any("every" in event for event in self.outside):
            raise UnsupportedError("no events that come again")
        if any("event" in step for body in program["bodies"] for step in body["steps"]):
            raise UnsupportedError("no SFC 0 and SFC 51 in AWL")
        self.awl = compiled(program)
        super().__init__(program)

    def start(self, ob):
        """Called by the CPU when an OB starts; it runs as soon as the CPU has said all."""
        self.started[ob] = self.started.get(ob, 0) + 1
        self.begun.append(ob)

    def stop(self):
        """Called by the CPU in STOP."""
        self.begun.clear()
        self.stopped = True

    def run(self):
        """Runs the program to its end."""
        while self.now < self.program["duration"]:
            self.stopped = False
            try:
                self.happen()
            except StoppedError:
                continue
            self.pass_time()

    def happen(self):
        """All that is due: events from outside, then OBs, one in the other."""
        idle = False
        while not idle:
            if self.outside and self.outside[0]["after"] <= self.now:
                self.cpu.poll()  # what is due by now was due before the event
                event = self.outside.pop(0)
                self.bring_about(event)
            elif self.begun:
                self.execute(self.begun.pop())
            else:
                self.cpu.poll()
                idle = not self.begun and not self.cpu.dispatch()
            if self.stopped and self.inside:
                raise StoppedError

    inside = 0

    def execute(self, ob):
        """Runs an OB in awlsim, and goes on with the OB that it has interrupted."""
        cpu = self.awl.getCPU()
        kept = {name: getattr(cpu, name) for name in ("callStackTop", "callStackDepth", "activeLStack")}
        self.inside += 1
        try:
            cpu._S7CPU__runOB(cpu.getOB(ob))
        finally:
            self.inside -= 1
            for name, value in kept.items():
                setattr(cpu, name, value)
        self.cpu.ended(ob)
        if ob == 1 and all(0 < body.get("run", 0) <= self.started[1] for body in self.cycles):
            self.cpu.cycle = NEVER  # empty cycles, which no log shows

    def pass_time(self, most=sys.maxsize):
        """Lets time pass until something happens; how much has passed."""
        moments = [self.program["duration"], self.cpu.next_moment(), *(event["after"] for event in self.outside[:1])]
        passed = min(most, max(1, min(moments) - self.now))
        self.now += passed
        return passed

    def busy(self, ms):
        """The running OB is at work."""
        self.happen()
        while ms > 0:
            ms -= self.pass_time(ms)
            if self.now >= self.program["duration"]:
                raise StoppedError
            self.happen()
        return ()


def operand(block, name):
    """An operand: a number with its sign, or a date as a program has it."""
    if name == "SDT":
        return date_of(AwlMemoryObject_asBytes(block.fetchInterfaceFieldByName(name)))
    value = AwlMemoryObject_asScalar(block.fetchInterfaceFieldByName(name))
    if name == "DTIME":
        return value - (1 << 32) if value >= 1 << 31 else value
    return wordToSignedPyInt(value) if name == "OB_NR" else value


def date_of(octets):
    """The date in the BCD digits of a DATE_AND_TIME, whether it exists or not."""
    digits = octets.hex()
    century = "19" if digits[:2] >= "90" else "20"
    month, day, hour, minute, second = (digits[place : place + 2] for place in range(2, 12, 2))
    return f"{century}{digits[:2]}-{month}-{day}T{hour}:{minute}:{second}.{digits[12:15]}"


def digits_of(date):
    """The other way round: the two double words of a DATE_AND_TIME, without the day of the week."""
    if not "1990" <= date[:4] < "2090":
        raise UnsupportedError("no year outside of 1990 to 2089 in a DATE_AND_TIME")
    digits = "".join(filter(str.isdigit, date))[2:] + "0"
    return digits[:8], digits[8:]


def system_function(name, sfc, inputs, outputs, behaviour):
    """A class for awlsim's table; `behaviour` gets the operands and returns values of the outputs."""

    def run(self):
        values = behaviour({field: operand(self, field) for field, _ in inputs})
        for field, value in zip((field for field, _ in outputs), values, strict=False):
            self.storeInterfaceFieldByName(field, make_AwlMemoryObject_fromScalar(value & 0xFFFF, 16))
        self.cpu.statusWord.BIE = 1

    fields = {
        kind: tuple(BlockInterfaceField(name=field, dataType=kind_of) for field, kind_of in of)
        for kind, of in ((IN, inputs), (OUT, outputs))
        if of
    }
    return type(f"SFC{sfc}", (SFC,), {"name": (sfc, name, name), "interfaceFields": fields, "run": run})


def called(name):
    """The behaviour of a system function that the supplied CPU has."""

    def behaviour(values):
        adapter = AwlAdapter.current
        adapter.happen()
        return adapter.cpu.call(name, {OPERANDS[field]: value for field, value in values.items()})

    return behaviour


def install():
    """Puts the system functions into awlsim's table."""
    for name, (sfc, inputs, outputs) in SFCS.items():
        SFC_table[sfc] = system_function(name, sfc, inputs, (("RET_VAL", "INT"), *outputs), called(name))
    busy = (("DTIME", "TIME"),)
    SFC_table[BUSY] = system_function("BUSY", BUSY, busy, (), lambda values: AwlAdapter.current.busy(values["DTIME"]))
    of_ob = lambda values: (AwlAdapter.current.started[values["OB_NR"]],)  # noqa: E731
    SFC_table[RUN] = system_function("RUN", RUN, OB_NR, (("RET_VAL", "INT"),), of_ob)


DATE = """DATA_BLOCK DB 1
STRUCT
  SDT : DATE_AND_TIME;
END_STRUCT;
BEGIN
END_DATA_BLOCK
"""
"""An operand of this type stands in a data block, so that it need not exist."""


def dated(step):
    """Statements that put the date of a step into the data block."""
    halves = digits_of(step["sdt"]) if "sdt" in step else ()
    return "".join(f"    L DW#16#{half}\n    T DB1.DBD {4 * place}\n" for place, half in enumerate(halves))


def statement(step):
    """A step as a statement in AWL."""
    if "call" not in step:
        return f"    CALL SFC {BUSY} ( DTIME := L#{step.get('wait', 0)} )"
    if step["call"] not in SFCS:
        raise UnsupportedError(f"no {step['call']}")
    sfc, inputs, outputs = SFCS[step["call"]]
    given = {"OB_NR": "{}", "DTIME": "L#{}", "MODE": "B#16#{:02X}"}
    given |= {"SDT": "DB1.SDT", "SIGN": "W#16#{:04X}", "PERIOD": "W#16#{:04X}"}
    operands = [f"{field} := {given[field].format(step[OPERANDS[field]])}" for field, _ in inputs]
    results = [f"{field} := MW {10 + 2 * place}" for place, (field, _) in enumerate((("RET_VAL", ""), *outputs))]
    return dated(step) + f"    CALL SFC {sfc} ( {', '.join([*operands, *results])} )"


def source(program):
    """The program as AWL: an FC for each body, OBs that choose by their run."""
    blocks, choices = [DATE], {}
    loaded = {event["ob"] for event in program["outside"] if event["event"] == "load"}
    for place, body in enumerate(program["bodies"], 1):
        steps = "\n".join(statement(step) for step in body["steps"] if "end" not in step)
        blocks.append(f"FUNCTION FC {place} : VOID\nBEGIN\n{steps}\nEND_FUNCTION\n")
        choices.setdefault(body["ob"], []).append((body.get("run", 0), place))
    for ob in sorted({1, 100, 102, *program["header"]["obs"], *loaded, *choices}):
        lines = [f"    CALL SFC {RUN} ( OB_NR := {ob}, RET_VAL := MW 0 )"]
        for run, place in sorted(choices.get(ob, []), reverse=True):
            if run:
                skip = f"N{place:03}"
                lines += ["    L MW 0", f"    L {run}", "    <>I", f"    SPB {skip}", f"    CALL FC {place}", "    BEA"]
                lines.append(f"{skip}: NOP 0")
            else:
                lines.append(f"    CALL FC {place}")
        blocks.append(f"ORGANIZATION_BLOCK OB {ob}\nBEGIN\n" + "\n".join(lines) + "\nEND_ORGANIZATION_BLOCK\n")
    return "\n".join(blocks)


def compiled(program):
    """Awlsim with the program in it."""
    parser = AwlParser()
    parser.parseSource(AwlSource(name="kit", filepath=None, sourceBytes=source(program).encode("latin-1")))
    awl = awlsim.core.main.AwlSim()
    awl.load(parser.getParseTree())
    awl.build()
    awl.getCPU().setRunTimeLimit(-1.0)
    awl.getCPU().setCycleTimeLimit(1e9)
    return awl


if __name__ == "__main__":
    logging.disable()
    Logging.setLoglevel(Logging.LOG_NONE)
    install()
    main(AwlAdapter)
