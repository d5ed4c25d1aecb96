"""Programs of the kit are read, wrong ones refused by the reader and by the schema."""

import json
from pathlib import Path

import jsonschema_rs
import pytest

from s7check.kit.collection import programs_of
from s7check.kit.program import FORMAT, read_program, read_programs
from s7check.log.errors import UnusableLogError
from s7check.resources import CHECKOUT
from tests.kit.programs import PROGRAM, changed
from tests.shipped import SCHEMA as LOG_FORMAT

KIT = CHECKOUT / "kit"
LOG_SCHEMA = json.loads(LOG_FORMAT.read_text(encoding="utf-8"))
SCHEMA = jsonschema_rs.validator_for(
    json.loads((KIT / "s7-interrupt-program-1.schema.json").read_text(encoding="utf-8")),
    registry=jsonschema_rs.Registry([(LOG_SCHEMA["$id"], LOG_SCHEMA)]),
)

REFUSED: list[tuple[str, object, str]] = [
    ("format", "s7-interrupt-log/1", "format"),
    ("format", None, "format"),
    ("name", "two words", "name"),
    ("about", "", "about"),
    ("requirements", ["AIRT-3"], "requirements"),
    ("requirements", None, "requirements"),
    ("seed", -1, "seed"),
    ("duration", 0, "duration"),
    ("nonsense", 1, "nonsense"),
    ("header.latency_ms", 10, "header.latency_ms"),
    ("header.cpu", "S7-500", "header.cpu"),
    ("header.clock", "2026-11-21", "header.clock"),
    ("outside.1.after", -1, "outside.1.after"),
    ("outside.1.event", "jump", "outside.1.event"),
    ("outside.1.ob", 10, "outside.1.ob"),
    ("outside.1.flt_id", 1, "outside.1.flt_id"),
    ("outside.2.by", None, "outside.2"),
    ("outside.2.to", "2026-11-21T06:00", "outside.2"),
    ("outside.3.flt_id", None, "outside.3.flt_id"),
    ("outside.3.every", 0, "outside.3.every"),
    ("bodies.1.run", 0, "bodies.1.run"),
    ("bodies.1.ob", 40000, "bodies.1.ob"),
    ("bodies.1.steps.1.call", "SET_TIME", "bodies.1.steps.1.call"),
    ("bodies.1.steps.1.sdt", "soon", "bodies.1.steps.1.sdt"),
    ("bodies.1.steps.1.period", None, "bodies.1.steps.1.period"),
    ("bodies.1.steps.1.ret", 0, "bodies.1.steps.1.ret"),
    ("bodies.1.steps.3.wait", "1s", "bodies.1.steps.3.wait"),
    ("bodies.1.steps.4.event", "stop", "bodies.1.steps.4.event"),
    ("bodies.1.steps.5.end", 1, "bodies.1.steps.5.end"),
    ("bodies.1.steps.5", {}, "bodies.1.steps.5"),
    ("bodies.1.steps.5", [], "bodies.1.steps.5"),
]


def text(program: object) -> bytes:
    """The program as a file has it, on several lines."""
    return json.dumps(program, indent=1).encode()


def test_program() -> None:
    """Every part is there; what comes from outside is in the order of its times."""
    program = read_program(text(PROGRAM))
    assert (program.name, program.requirements, program.duration) == ("AIRT-nested", ("AIRT-03",), 5000)
    assert [event["after"] for event in program.outside] == [500, 1000, 1500]
    assert [(body.ob, body.run, len(body.steps)) for body in program.bodies] == [(1, 1, 5), (35, 0, 0)]
    plain = json.loads(program.plain_line())["bodies"][0]["steps"]
    assert (plain[0]["period"], plain[0]["sdt"], plain[3]["to"]) == (
        0x0201,
        "2026-02-30T06:00:00.000",
        "2026-11-21T06:00:00.000",
    )
    assert read_program(program.line()) == program
    assert SCHEMA.is_valid(PROGRAM)


@pytest.mark.parametrize(("path", "value", "field"), REFUSED)
def test_refused(path: str, value: object, field: str) -> None:
    """A wrong field is named by its path, and is not of the schema either."""
    program = changed(path, value)
    with pytest.raises(UnusableLogError) as refusal:
        read_program(text(program))
    assert refusal.value.field == field
    assert not SCHEMA.is_valid(program)


@pytest.mark.parametrize(
    ("path", "value"),
    [
        ("x_own", [1]),
        ("bodies.1.steps.1.x_own", {}),
        ("header.priority", {"10": 5}),
        ("outside", None),
        ("bodies.1.steps.5", {"event": "state", "ob": 10}),
    ],
)
def test_accepted(path: str, value: object) -> None:
    """Own fields, optional ones."""
    program = changed(path, value)
    read_program(text(program))
    assert SCHEMA.is_valid(program)


ZONE = {"event": "zone", "zone": -720, "reason": "daylight"}


def zoned(cpu: str = "S7-1500", **fields: object) -> dict[str, object]:
    """A program with a step and an event from outside that set local time; None takes a field away."""
    zone = {name: value for name, value in (ZONE | fields).items() if value is not None}
    header = changed("header.cpu", cpu)["header"] | {"obs": [1, 10, 35, 80, 100]}
    return PROGRAM | {"header": header, "outside": [{"after": 10, **zone}], "bodies": [{"ob": 1, "steps": [zone]}]}


def test_a_zone() -> None:
    """An S7-1500 alone has one; its values are those of a log."""
    program = read_program(text(zoned()))
    assert (program.plain["outside"], program.bodies[0].steps) == ([{"after": 10, **ZONE}], (ZONE,))
    assert SCHEMA.is_valid(zoned())
    for wrong in ({"zone": 841}, {"reason": "summer"}, {"zone": None}, {"reason": None}, {"to": "2026-11-21T06:00"}):
        with pytest.raises(UnusableLogError):
            read_program(text(zoned(**wrong)))
        assert not SCHEMA.is_valid(zoned(**wrong))
    with pytest.raises(UnusableLogError):
        read_program(text(zoned("S7-400")))


def test_kit_is_of_the_schema() -> None:
    """Programs for an S7-1500 are, too."""
    assert [program.name for program in programs_of() if not SCHEMA.is_valid(program.raw)] == []


def test_beyond_the_schema() -> None:
    """Two bodies for a run, OBs from 123 on without an event class, and steps behind the end."""
    with pytest.raises(UnusableLogError, match="two of OB 1, run 1"):
        read_program(text(changed("bodies.2", {"ob": 1, "run": 1, "steps": []})))
    newer = changed(
        "header", {"cpu": "S7-1500", "obs": [1, 130], "classes": {"130": "hardware"}, "clock": "2026-11-21T06:00"}
    )
    assert read_program(text(newer | {"bodies": [{"ob": 130, "steps": []}], "outside": []})).header["classes"]
    with pytest.raises(UnusableLogError, match=r"one of the header's .*classes.*; found OB 131"):
        read_program(text(newer | {"bodies": [{"ob": 131, "steps": []}], "outside": []}))
    with pytest.raises(UnusableLogError, match="end as the last step"):
        read_program(text(changed("bodies.1.steps.1", {"end": True})))


def test_no_json() -> None:
    """The line is named."""
    with pytest.raises(UnusableLogError) as refusal:
        read_program(b'{\n"format":\n}')
    assert refusal.value.line == 3


def test_files(tmp_path: Path) -> None:
    """A file of one program, and one with a program a line, where an error has its line."""
    one, lines = tmp_path / "one.json", tmp_path / "lines.ndjson"
    one.write_bytes(text(PROGRAM))
    lines.write_bytes(json.dumps(PROGRAM).encode() + b"\n\n" + json.dumps(PROGRAM | {"format": FORMAT + "0"}).encode())
    assert len(list(read_programs(one))) == 1
    with pytest.raises(UnusableLogError) as refusal:
        list(read_programs(lines))
    assert (refusal.value.line, refusal.value.field) == (3, "format")


def test_one_spelling_for_an_adapter() -> None:
    """A program may be a text; its dates have one spelling, the start points of STEP 7 among them."""
    parameters = {"execution": "daily", "start": "DT#2026-11-21-06:00:00", "active": True}
    header = PROGRAM["header"] | {"step7": {"tod": {"10": parameters, "11": {"deselected": True}}}}
    plain = json.loads(read_program(json.dumps(PROGRAM | {"header": header})).plain_line())["header"]
    assert plain["step7"]["tod"] == {
        "10": parameters | {"start": "2026-11-21T06:00:00.000"},
        "11": {"deselected": True},
    }
    assert plain["clock"] == "2026-11-21T05:59:30.000"
    call = {"call": "SET_TINTL", "ob": 10, "sdt": "2026-11-21T06:00", "period": 0, "local": True, "activate": False}
    newer = PROGRAM | {"bodies": [{"ob": 1, "steps": [call]}]}
    ((step,),) = (body["steps"] for body in json.loads(read_program(json.dumps(newer)).plain_line())["bodies"])
    assert (step["local"], step["activate"]) == (True, False)
