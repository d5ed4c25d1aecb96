"""The tools of ``s7check mcp``, asked by the client of the protocol's own SDK."""

import json
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import anyio
import pytest
from mcp import Client, StdioServerParameters
from mcp.types import TextContent

import s7check
from s7check import cli
from s7check.assisting import tools
from s7check.assisting.command import INSTALL
from tests.test_shipped_logs import PROJECT

HEADER: dict[str, Any] = {
    "format": "s7-interrupt-log/1",
    "cpu": "S7-300",
    "obs": [1, 10, 80, 85],
    "clock": "2026-11-21T05:59",
    "mode": "RUN",
}
SET: dict[str, Any] = {
    "event": "SET_TINT",
    "at": "2026-11-21T05:59:10.000",
    "ob": 10,
    "sdt": "2026-11-21T06:00",
    "period": 513,
    "ret": 0,
}
ACT: dict[str, Any] = {"event": "ACT_TINT", "at": "2026-11-21T05:59:20.000", "ob": 10, "ret": 0}
EARLY: dict[str, Any] = {"event": "start", "at": "2026-11-21T05:59:30.000", "ob": 10}

Ask = Callable[..., tuple[bool, str]]


def text_of(*lines: dict[str, Any]) -> str:
    """The text of a log."""
    return "".join(json.dumps(line) + "\n" for line in lines)


async def asked(client: Client, tool: str, arguments: dict[str, Any]) -> tuple[bool, str]:
    """Whether the tool failed, and its text."""
    result = await client.call_tool(tool, arguments)
    assert [type(content) for content in result.content] == [TextContent]
    content = result.content[0]
    assert isinstance(content, TextContent)
    assert len(content.text) < tools.LONGEST + 100
    return bool(result.is_error), content.text.removeprefix(f"Error executing tool {tool}: ")


@pytest.fixture
def ask() -> Ask:
    """A function that asks a tool of a server in this process."""

    def one(tool: str, **arguments: Any) -> tuple[bool, str]:
        async def run() -> tuple[bool, str]:
            async with Client(tools.server()) as client:
                return await asked(client, tool, arguments)

        return anyio.run(run)

    return one


def test_over_standard_input_and_output() -> None:
    """The command serves a client that starts it: the tools with their parameters, and a verdict."""

    async def run() -> None:
        command = StdioServerParameters(command=sys.executable, args=["-m", "s7check", "mcp"])
        async with Client(command) as client:
            about = client.server_info
            assert about is not None
            assert (about.name, about.version) == ("s7check", s7check.__version__)
            listed = {tool.name: tool for tool in (await client.list_tools()).tools}
            assert set(listed) == {"check_log", "next_events", "why_not_event", "simulate", "compare", "rule"}
            assert all(tool.description for tool in listed.values())
            assert "log" in listed["check_log"].input_schema["required"]
            failed, said = await asked(client, "check_log", {"log": text_of(HEADER, SET, ACT, EARLY)})
            assert (failed, said.splitlines()[0][:16]) == (False, "log:4: rejected:")
            failed, said = await asked(client, "check_log", {"log": "-"})
            assert failed, "the client's messages are no log"

    anyio.run(run)


def test_instructions_hold(ask: Ask) -> None:
    """The log and the program that the server shows to the assistant are right."""
    shown = [line for line in tools._INSTRUCTIONS.splitlines() if line.startswith("{")]
    failed, said = ask("check_log", log="\n".join(line for line in shown if "program/1" not in line))
    assert not failed
    assert said.startswith("log: accepted: the specification explains every event (4 events)")
    (program,) = (line for line in shown if "program/1" in line)
    failed, said = ask("simulate", program=program)
    assert not failed
    assert json.loads(said.splitlines()[0])["format"] == "s7-interrupt-log/1"
    assert [json.loads(line)["event"] for line in said.splitlines()[1:]] == [
        *("SRT_DINT", "DIS_AIRT", "EN_AIRT", "start", "end")
    ]


def test_check(ask: Ask, tmp_path: Path) -> None:
    """Of text and of a file: the same verdict as that of the package; other readings where they are asked for."""
    lines = [HEADER, SET, ACT, EARLY]
    failed, said = ask("check_log", log=text_of(*lines))
    assert (failed, said) == (False, str(s7check.check(text_of(*lines).splitlines())))
    file = tmp_path / "x.ndjson"
    file.write_text(text_of(*lines))
    failed, said = ask("check_log", log=str(file), other_readings=True)
    assert said.startswith(f"{file}:4: rejected: ")
    assert "would pass with" in said
    failed, said = ask("check_log", log=text_of(HEADER, {"event": "strat"}))
    assert (failed, "log:2: unusable: " in said) == (False, True)
    failed, said = ask("check_log", log=str(tmp_path / "none"))
    assert (failed, "unusable" in said) == (False, True)


def test_next_and_why_not(ask: Ask) -> None:
    """What must come, on other CPUs too; why an event may not come, or that it may."""
    log = text_of(HEADER, SET, ACT, EARLY)
    failed, said = ask("next_events", log=log, line=3, cpus=["S7-400"])
    assert not failed
    assert "start ob=10, by 2026-11-21T06:00:00.010 [TINT-" in said
    assert "differs" in said
    assert "\x1b" not in said
    failed, said = ask("why_not_event", log=log, line=3, event={"event": "start", "ob": 10})
    assert said.startswith("log:4: rejected: ")
    assert "why not" in said
    assert ask("why_not_event", log=log, line=3, event={"event": "stop"}) == (False, "log:3: this may come next")
    failed, said = ask("next_events", log=log, line=5)
    assert (failed, said) == (True, "expected a line 1 to 4; found 5")
    failed, said = ask("why_not_event", log=log, event={"event": "strat"})
    assert (failed, said.startswith('field "event": expected ')) == (True, True)


def test_programs(ask: Ask) -> None:
    """A program of the kit by its name: its log, its outcomes, two CPUs beside each other."""
    name = "AIRT-03-nested-delay"
    failed, said = ask("simulate", program=name)
    assert not failed
    assert '"event":"DIS_AIRT"' in said
    failed, said = ask("compare", program_or_log=name, cpus=["S7-300", "S7-400"])
    assert (failed, said.startswith("no difference: ")) == (False, True)
    assert ask("compare", program_or_log=name, cpus=["S7-300"]) == (
        *(True, "expected two of cpus, profiles, readings; found 1"),
    )
    failed, said = ask("simulate", program="no-such-program")
    assert (failed, said) == (True, "expected a program, its file, or a name of the kit; found 'no-such-program'")
    failed, said = ask("simulate", program='{"format": "s7-interrupt-program/1"}')
    assert (failed, said.startswith('field "')) == (True, True)


def test_compare_a_log(ask: Ask) -> None:
    """Who allows a log, with the rule."""
    back = {"event": "clock", "at": "2026-11-21T05:59:30.000", "to": "2026-11-21T06:00:10"}
    late = {"event": "start", "at": "2026-11-21T06:00:10.000", "ob": 80}
    failed, said = ask("compare", program_or_log=text_of(HEADER, SET, ACT, back, late), cpus=["S7-300", "S7-400"])
    assert (failed, said) == (False, "cpu S7-300: allows it\ncpu S7-400: allows it")
    failed, said = ask("compare", program_or_log=text_of(HEADER, SET, ACT, EARLY), cpus=["S7-400"])
    assert said.startswith("cpu S7-400: line 4 is not possible: TINT-")
    assert "SF06" in said or "SF97" in said
    failed, said = ask("compare", program_or_log=text_of(HEADER), cpus=["S7-2000"])
    assert (failed, said.startswith('field "cpu": expected ')) == (True, True)


def test_rule(ask: Ask) -> None:
    """By ID with its sources; by words; an open question with its readings."""
    failed, said = ask("rule", name="AIRT-03")
    assert said.startswith("AIRT-03 ")
    assert "docs/rules/requirements.md#AIRT-03" in said
    failed, said = ask("rule", name="AMB-12")
    assert "\n  (a) " in said
    assert "docs/rules/readings.md#AMB-12" in said
    failed, said = ask("rule", name="points served again")
    assert not failed
    assert any(line.startswith("CLK-") for line in said.splitlines())
    failed, said = ask("rule", name="a")
    assert said.splitlines()[-1].endswith("more: name more words")
    assert ask("rule", name="ABCD-77")[0]


def test_long_answers_come_in_parts(ask: Ask, monkeypatch: pytest.MonkeyPatch) -> None:
    """The parts together are the answer; one that there is not is refused."""
    monkeypatch.setattr(tools, "LONGEST", 100_000)
    log = text_of(HEADER, SET, ACT)
    whole = ask("next_events", log=log)[1]
    monkeypatch.setattr(tools, "LONGEST", 2000)
    first = ask("next_events", log=log)[1]
    count = int(first.rpartition(" of ")[2].rstrip(")"))
    assert count > 1
    parts = [ask("next_events", log=log, part=number)[1].rpartition("\n(part ")[0] for number in range(1, count + 1)]
    assert "\n".join(parts) == whole
    assert ask("next_events", log=log, part=count + 1) == (True, f"part: expected 1 to {count}; found {count + 1}")
    assert tools._part("x" * 5000, 3).startswith("x" * 1000 + "\n(part 3")


def test_without_the_sdk(capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """The message says how to get it, by the name of the extra in pyproject.toml."""
    monkeypatch.setitem(sys.modules, "mcp", None)
    assert cli.main(["mcp"]) == 2
    assert capfd.readouterr().err == (f"Error: expected the SDK of the Model Context Protocol: {INSTALL}; found none\n")
    assert "mcp" in tomllib.loads((PROJECT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
