"""``s7check import`` as its users see it: files in, a log out, or one message."""

import json
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from s7check import check, cli
from s7check.engine import pool
from s7check.importing.asking import kind_of

DATA = Path(__file__).parents[3] / "examples" / "import"
CPU = ["--cpu", "S7-400", "--obs", "1,10,35,80,85,100"]

Run = Callable[..., "tuple[dict[str, Any], list[dict[str, Any]], str]"]


@pytest.fixture
def run(capfdbinary: pytest.CaptureFixture[bytes]) -> Run:
    """Imports with the arguments given: the log's header, its events, what standard error says."""

    def imported(*arguments: str | Path) -> tuple[dict[str, Any], list[dict[str, Any]], str]:
        code = cli.main(["import", *map(str, arguments)])
        out, err = capfdbinary.readouterr()
        assert code == 0, err
        with pool.engine() as engine:
            assert engine.read(out).unusable is None
        header, *events = [json.loads(line) for line in out.splitlines()]
        return header, events, err.decode()

    return imported


@pytest.fixture
def refused(capfdbinary: pytest.CaptureFixture[bytes]) -> Callable[..., str]:
    """The one message with which the arguments given are refused."""

    def message(*arguments: str | Path) -> str:
        code = cli.main(["import", *map(str, arguments)])
        out, err = capfdbinary.readouterr()
        assert (code, out) == (2, b"")
        assert err.count(b"Error:") == 1
        return err.decode().partition("Error: ")[2].rstrip("\n")

    return message


def test_english_text(run: Run) -> None:
    """Oldest first; mode changes beside their entries; every bit of the coding is kept."""
    header, events, err = run("--from", "step7", DATA / "english.txt", *CPU)
    assert header == {
        "format": "s7-interrupt-log/1",
        "cpu": "S7-400",
        "obs": [1, 10, 35, 80, 85, 100],
        "clock": "2012-03-18T00:00:02.000",
        "mode": "STOP",
        "records": ["mode", "diag"],
    }
    assert [event.get("id", event["event"]) for event in events] == [
        *("restart", "W#16#4301", "W#16#1381", "run", "W#16#4302"),
        *("W#16#B046", "W#16#3502", "W#16#38C4", "stop", "W#16#4303"),
    ]
    assert events[0]["type"] == "warm"
    assert events[6] == {
        "event": "diag",
        "at": "2012-03-18T17:30:01.105",
        "id": "W#16#3502",
        "ob": 80,
        "priority": 26,
        "info": {"flt_id": "B#16#02", "error_info": "W#16#0000", "ev": "W#16#1136", "ev_ob": 35},
        "x_coding": "3502 1A50 C358 0000 1136 0C23",
    }
    assert "priority" not in events[7], "16#FE is no class"
    assert events[8]["cause"] == "W#16#4303"
    assert "7 entries read, 0 skipped; 10 events written" in err
    assert "recorded completely: mode, diag" in err


def test_german_text(run: Run) -> None:
    """The same in German, in a Windows code page, with CRLF."""
    header, events, _ = run("--from", "step7", DATA / "german.txt", *CPU)
    assert (header["clock"], header["mode"]) == ("2012-11-21T05:58:11.377", "STOP")
    assert [event.get("id", event["event"]) for event in events] == [
        *("restart", "W#16#4301", "W#16#1381", "run", "W#16#4302", "W#16#3502", "stop", "W#16#4568"),
    ]
    assert events[5]["info"] == {"flt_id": "B#16#02", "error_info": "W#16#0201", "ev": "W#16#1111", "ev_ob": 10}
    assert events[6] == {"event": "stop", "at": "2012-11-21T06:00:00.012", "cause": "W#16#4568"}


def test_step7_text_with_a_line_of_no_entry(run: Run, tmp_path: Path) -> None:
    """However long it is, it says nothing."""
    text = (DATA / "german.txt").read_bytes()
    (tmp_path / "a").write_bytes(text.replace(b"\n", b"\n" + b"x" * 70_000 + b"\n", 20))
    assert run("--from", "step7", tmp_path / "a", *CPU)[1] == run("--from", "step7", DATA / "german.txt", *CPU)[1]


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16"])
def test_text_of_any_editor(run: Run, tmp_path: Path, encoding: str) -> None:
    """A text that an editor saved anew reads like the original."""
    text = (DATA / "german.txt").read_bytes().decode("cp1252")
    (tmp_path / "saved.txt").write_bytes(text.encode(encoding))
    assert run("--from", "step7", tmp_path / "saved.txt", *CPU) == tuple(
        part.replace("german.txt", "saved.txt").replace(str(DATA), str(tmp_path)) if isinstance(part, str) else part
        for part in run("--from", "step7", DATA / "german.txt", *CPU)
    )


ENTRY = "Event {number} of 9:  Event ID 16# {id}\n{time}\n"


def text(*entries: tuple[int, str, str]) -> bytes:
    """A text of entries without coding."""
    return "".join(ENTRY.format(number=number, id=id_, time=time) for number, id_, time in entries).encode()


@pytest.mark.parametrize(
    ("times", "first"),
    [
        (["08:00:01.000 13.02.2012", "08:00:00.000 03.02.2012"], "2012-02-03T08:00:00.000"),
        (["08:00:01.000 AM 02/13/2012", "12:00:00.000 AM 02/03/2012"], "2012-02-03T00:00:00.000"),
        (["08:00:01.000 13/02/2012", "08:00:00.000 03/02/2012"], "2012-02-03T08:00:00.000"),
        (["01:00:00.000 PM 02/13/12", "12:00:00.000 PM 02/13/12"], "2012-02-13T12:00:00.000"),
        (["08:00:01.000 2012-02-13", "08:00:00.000 2012-02-03"], "2012-02-03T08:00:00.000"),
    ],
)
def test_dates(run: Run, tmp_path: Path, times: list[str], first: str) -> None:
    """The dates of a text tell their order."""
    (tmp_path / "a").write_bytes(text((1, "4303", times[0]), (2, "4302", times[1])))
    header, events, _ = run("--from", "step7", tmp_path / "a", *CPU)
    assert (header["clock"], header["mode"]) == (first, "STARTUP")
    assert events[1] == {"event": "diag", "at": first, "id": "W#16#4302"}, "nothing is known but the event ID"


def test_event_details(run: Run, tmp_path: Path) -> None:
    """STEP 7's form for an event that it has no text for; the time may follow a description."""
    lines = [
        "Event details: 1 of 10  Event ID: 16# B046",
        "  No entry in text database. Hex values are displayed.",
        "  Event ID:  16# B046",
        "  OB:  16# 01",
        "  PK:  16# 01",
        "  DatID 1/ 2:  16# 59 C9",
        "  Supplementary info1 / 2 / 3:  16# 0200 0000 0020",
        "  Outgoing event:  12:36:02.459 08.04.03",
    ]
    (tmp_path / "a").write_text("\n".join(lines))
    _, events, _ = run("--from", "step7", tmp_path / "a", *CPU, "--mode", "RUN")
    assert [(event["at"], event["x_coding"]) for event in events] == [
        ("2003-04-08T12:36:02.459", "B046 0101 59C9 0200 0000 0020")
    ]


def test_dates_that_do_not_tell(run: Run, refused: Callable[..., str], tmp_path: Path) -> None:
    """Day and month are not guessed; the user names their order."""
    (tmp_path / "a").write_bytes(text((1, "4302", "08:00:00.000 02/03/2012")))
    message = refused("--from", "step7", tmp_path / "a", *CPU)
    assert message.endswith("found several ways to read them; name it with --dates")
    header, _, _ = run("--from", "step7", tmp_path / "a", *CPU, "--dates", "DMY")
    assert header["clock"] == "2012-03-02T08:00:00.000"


def test_gap_between_numbers(run: Run, tmp_path: Path) -> None:
    """A text from which entries were taken out does not record diag completely."""
    times = ["08:00:01.000 13.02.2012", "08:00:00.000 13.02.2012"]
    (tmp_path / "a").write_bytes(text((2, "4303", times[0]), (5, "4302", times[1])))
    header, _, err = run("--from", "step7", tmp_path / "a", *CPU)
    assert header["records"] == []
    assert "note: numbers are missing between the entries" in err
    assert "recorded completely: nothing" in err


def test_clock_set_back(run: Run, refused: Callable[..., str], tmp_path: Path) -> None:
    """Nothing tells when the clock was set back; the parts are imported apart."""
    times = ["01.01.1994", "02.01.2012", "01.01.2012"]
    entries = [(number, "4302", f"08:00:00.000 {date}") for number, date in enumerate(times, 1)]
    (tmp_path / "a").write_bytes(text(*entries))
    message = refused("--from", "step7", tmp_path / "a", *CPU)
    assert "entry 1 (line 1): expected no time before 2012-01-02T08:00:00.000, that of entry 2;" in message
    assert message.endswith("with --entries 2- and --entries 1-1")
    header, events, err = run("--from", "step7", tmp_path / "a", *CPU, "--entries", "2-")
    assert header["clock"] == "2012-01-01T08:00:00.000"
    assert len(events) == 4
    assert "3 entries read, 1 skipped; 4 events written" in err
    assert "1 skipped: outside --entries" in err


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", 'expected entries such as "Event 1 of 100: Event ID 16# 4302" or'),
        (text((1, "4302", "soon")), 'entry 1 (line 1): expected a line that ends like "05:36:29.972 PM 03/18/2012"'),
        (text((1, "4302", "36:02:45.900 08.04.2003")), "entry 1 (line 1): expected a time and a date (DMY)"),
        (text((1, "4302", "13:02:45.900 PM 08.04.2003")), "entry 1 (line 1): expected a time and a date (DMY)"),
        (text((1, "4302", "08:02:45.900 30.02.2003")), "entry 1 (line 1): expected a time and a date (DMY)"),
        (b"\nEvent 7 of 9:  nothing\n", 'entry 7 (line 2): expected an event ID such as "Event ID 16# 4302"; found '),
        (
            text((3, "4302", "08:02:45.900 01.02.2003")) + b"(Coding: 16# 4303 FF84 C700 0000 0000 0000)\n",
            "entry 3 (line 1): expected a coding that begins with the event ID 16# 4302; found 16# 4303",
        ),
        (
            text((3, "4302", "08:02:45.900 01.02.2003")) + b"(Coding: 16# 4302 FF68)\n",
            'entry 3 (line 1): expected a coding of six words; found "(Coding: 16# 4302 FF68)"',
        ),
    ],
)
def test_text_that_cannot_be_read(refused: Callable[..., str], tmp_path: Path, content: bytes, message: str) -> None:
    """One message: the file, the entry, what was expected."""
    (tmp_path / "a").write_bytes(content)
    assert f"{tmp_path / 'a'}: {message}" in refused("--from", "step7", tmp_path / "a", *CPU)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (
            ["--obs", "1"],
            'header: field "cpu": expected it from --cpu or --header, since the source does not tell it; found none',
        ),
        (["--cpu", "S7-300"], 'header: field "obs": expected it from --obs or --header'),
        (
            [*CPU, "--clock", "yesterday"],
            'header: field "clock": expected a date and time such as "2026-11-21T06:00:00.000"; found',
        ),
        (
            [*CPU, "--records", "clock", "--clock", "2013-01-01T00:00"],
            'entry 7 (line 64): field "at": expected no time before 2013-01-01',
        ),
        ([*CPU, "--set", "AMB-02=z"], "Invalid value for '--set': AMB-02: expected a or b; found 'z'"),
        ([*CPU, "--records", "everything"], 'found "everything"'),
        ([*CPU, "--entries", "9-"], "expected an entry to import; found entries 1 to 7"),
        ([*CPU, "--latency", "-1"], 'header: field "latency_ms": expected an integer'),
    ],
)
def test_wrong_header(refused: Callable[..., str], arguments: list[str], message: str) -> None:
    """What the header lacks or cannot have is said in its terms."""
    assert message in refused("--from", "step7", DATA / "english.txt", *arguments)


@pytest.mark.parametrize(
    "arguments",
    [
        ["--obs", "one"],
        ["--set", "AMB-02"],
        ["--set", "AMB-99=a"],
        ["--entries", "7"],
        ["--step7", str(DATA / "english.txt")],
        ["--header", str(DATA / "absent.json")],
        ["--from", "csv"],
        ["--from", "tia"],
        ["--port", "0"],
    ],
)
def test_wrong_arguments(refused: Callable[..., str], arguments: list[str]) -> None:
    """Each wrong option is named."""
    assert refused(DATA / "english.txt", *arguments)


@pytest.mark.parametrize(
    ("name", "more"),
    [
        ("english.txt", []),
        ("german.txt", []),
        ("szl.hex", ["--mode", "RUN"]),
        ("ring.hex", ["--mode", "RUN"]),
        ("events.csv", ["--map", DATA / "columns.json", "--mode", "RUN"]),
    ],
)
def test_kind_of_a_file(run: Run, name: str, more: list[str | Path]) -> None:
    """A file shows what it is."""
    kind = {"hex": name.partition(".")[0], "csv": "csv"}.get(name.partition(".")[2], "step7")
    assert run(DATA / name, *CPU, *more)[:2] == run("--from", kind, DATA / name, *CPU, *more)[:2]


def test_kind_of_another_file(refused: Callable[..., str], tmp_path: Path) -> None:
    """What it may be is said in words."""
    (tmp_path / "a").write_bytes(b"Date;Event\n")
    said = refused(tmp_path / "a", *CPU)
    assert said.startswith("--from is missing, and SOURCE does not show what it is: expected the text of a diagnostic")
    assert "with --map a table (csv)" in said


FRENCH = """Tampon de diagnostic du module  CPU 315-2 DP

Ev\u00e9nement 1 sur 2 :  ID d'\u00e9v\u00e9nement 16# 4302
Passage de l'\u00e9tat de fonctionnement MISE EN ROUTE \u00e0 MARCHE
\u00e9v\u00e9nement apparaissant
05:58:11.402  21.11.2012
(Codage : 16# 4302 FF68 C700 0000 0000 0000)

\u00c9v\u00e9nement 2 sur 2 :  ID d'\u00e9v\u00e9nement 16# B046
Pas de texte
OB : 16# 01
PK : 16# 01
DatID 1/ 2 : 16# 59 C9
Info suppl. 1 / 2 / 3 : 16# 0200 0000 0020
05:58:11.401  21.11.2012
"""

IN_LINES = """Details on event: 1 of 1
Event ID: 16#4302
Description: Mode transition from STARTUP to RUN
(Coding: 16#4302 FF68 C700 0000 0000 0000)
05:58:11.402  21.11.2012
"""


@pytest.mark.parametrize("encoding", ["cp1252", "utf-8", "utf-16"])
@pytest.mark.parametrize(("content", "ids"), [(FRENCH, ["W#16#B046", "W#16#4302"]), (IN_LINES, ["W#16#4302"])])
def test_other_words_for_the_same_facts(run: Run, tmp_path: Path, content: str, ids: list[str], encoding: str) -> None:
    """French; and the ID in a line of its own, as TIA Portal shows it. The texts are made by hand."""
    (tmp_path / "a").write_bytes(content.encode(encoding))
    _, events, _ = run(tmp_path / "a", *CPU, "--mode", "RUN")
    entries = [one for one in events if one["event"] == "diag"]
    assert [one["id"] for one in entries] == ids
    assert all(one["x_coding"] for one in entries)
    assert entries[-1]["x_coding"].startswith("43 02 FF 68") or entries[-1]["x_coding"].startswith("4302 FF68")


def test_entry_without_an_id(refused: Callable[..., str], tmp_path: Path) -> None:
    """Neither in its first line nor in another."""
    (tmp_path / "a").write_text("Event 1 of 1:\n05:58:11.402  21.11.2012\n")
    assert 'entry 1 (line 1): expected an event ID such as "Event ID 16# 4302"; found none' in refused(
        tmp_path / "a", *CPU
    )


def test_mode_is_not_guessed(run: Run, refused: Callable[..., str], tmp_path: Path) -> None:
    """A buffer without a change of the mode does not tell it."""
    (tmp_path / "a").write_bytes(text((1, "3501", "08:02:45.900 01.02.2003")))
    assert 'header: field "mode"' in refused("--from", "step7", tmp_path / "a", *CPU)
    header, _, _ = run("--from", "step7", tmp_path / "a", *CPU, "--mode", "RUN")
    assert (header["mode"], header["records"]) == ("RUN", ["diag"])


def test_header_file_and_options(run: Run, tmp_path: Path) -> None:
    """--header gives any field, an option counts more, both count more than the source."""
    (tmp_path / "header.json").write_text(
        json.dumps({"cpu": "S7-300", "obs": [1], "priority": {"10": 3}, "cycle": True, "records": ["diag"]})
    )
    (tmp_path / "step7.json").write_text(json.dumps({"tod": {"10": {"execution": "none"}}}))
    header, _, _ = run(
        *("--from", "step7", DATA / "english.txt", "--header", tmp_path / "header.json"),
        *("--cpu", "CPU 318", "--obs", "1,10,80", "--step7", tmp_path / "step7.json", "--latency", "50"),
        *("--set", "AMB-02=a", "--set", "AMB-17=b", "--mode", "STOP", "--clock", "2012-01-01T00:00"),
    )
    assert header == {
        "format": "s7-interrupt-log/1",
        "cpu": "CPU 318",
        "obs": [1, 10, 80],
        "clock": "2012-01-01T00:00",
        "mode": "STOP",
        "records": ["diag"],
        "priority": {"10": 3},
        "cycle": True,
        "step7": {"tod": {"10": {"execution": "none"}}},
        "latency_ms": 50,
        "readings": {"AMB-02": "a", "AMB-17": "b"},
    }


def test_csv(run: Run) -> None:
    """Columns become fields; rows that the map leaves out and unused columns are reported."""
    arguments = ("--from", "csv", DATA / "events.csv", "--map", DATA / "columns.json", *CPU, "--mode", "RUN")
    header, events, err = run(*arguments, "--records", "call,ob")
    assert (header["clock"], header["records"]) == ("2026-11-21T05:59:31.000", ["call", "ob"])
    assert events == [
        {
            "event": "SET_TINT",
            "at": "2026-11-21T05:59:31.000",
            "ob": 10,
            "sdt": "2026-11-21T06:00:00.000",
            "period": "W#16#0201",
            "ret": "W#16#0000",
        },
        {"event": "ACT_TINT", "at": "2026-11-21T05:59:31.001", "ob": 10, "ret": "W#16#0000"},
        {"event": "start", "at": "2026-11-21T06:00:00.003", "ob": 10},
        {"event": "end", "at": "2026-11-21T06:00:00.009", "ob": 10},
    ]
    assert "5 entries read, 1 skipped; 4 events written" in err
    assert "1 skipped: left out by the column map" in err
    assert 'note: columns not used: "Bemerkung"' in err


def test_csv_texts_that_the_map_does_not_have(run: Run, tmp_path: Path) -> None:
    """``others`` says for them; without it they stand in the log as they are, where the format refuses them."""
    (tmp_path / "events.csv").write_text("at,what,ob\n2026-11-21T06:00,begins,10\n2026-11-21T06:00,a remark,10\n")
    columns = {"columns": {"at": "at", "event": "what", "ob": "ob"}, "values": {"event": {"begins": "start"}}}
    (tmp_path / "columns.json").write_text(json.dumps(columns | {"others": {"event": None}}))
    arguments = ("--from", "csv", tmp_path / "events.csv", "--map", tmp_path / "columns.json", *CPU, "--mode", "RUN")
    _, events, err = run(*arguments)
    assert [event["event"] for event in events] == ["start"]
    assert "1 skipped: left out by the column map" in err
    (tmp_path / "columns.json").write_text(json.dumps(columns | {"others": {"event": "end"}}))
    assert [event["event"] for event in run(*arguments)[1]] == ["start", "end"]


@pytest.mark.parametrize(
    ("name", "family"),
    [
        ("S7-300", "S7-300"),
        ("s7-400", "S7-400"),
        ("cpu 318", "CPU 318"),
        ("315-2DP", "S7-300"),
        ("CPU 317-2 PN/DP", "S7-300"),
        ("CPU318-2", "CPU 318"),
        ("416-3", "S7-400"),
        ("6ES7 315-2AG10-0AB0", "S7-300"),
        ("6ES7412-3HJ14-0AB0", "S7-400"),
    ],
)
def test_names_of_cpus(run: Run, name: str, family: str) -> None:
    """A CPU's own name or order number tells its family."""
    header, _, _ = run("--from", "step7", DATA / "english.txt", "--cpu", name, "--obs", "OB1, ob 10,35")
    assert (header["cpu"], header["obs"]) == (family, [1, 10, 35])


@pytest.mark.parametrize("name", ["S7-1500", "1516-3", "CPU 224", "515", "3155", ""])
def test_other_cpus(refused: Callable[..., str], name: str) -> None:
    """No family of these rules: the message says which are."""
    message = refused("--from", "step7", DATA / "english.txt", "--cpu", name, "--obs", "1")
    assert "expected S7-300, S7-400, CPU 318, or a CPU such as 315-2DP" in message


@pytest.mark.parametrize("obs", ["OB", "1;10", "1,,10", "FB1"])
def test_no_obs(refused: Callable[..., str], obs: str) -> None:
    """The message shows both spellings."""
    message = refused("--from", "step7", DATA / "english.txt", "--cpu", "S7-300", "--obs", obs)
    assert "expected OBs such as 1,10,80 or OB1,OB10,OB80" in message


def test_entries_that_contradict_the_obs(run: Run) -> None:
    """They are named and stay as they are, and so does the header."""
    header, events, err = run("--from", "step7", DATA / "english.txt", "--cpu", "S7-400", "--obs", "1,86")
    assert header["obs"] == [1, 86]
    assert "entry 2 (line 18): OB 86 could not be started (priority 16#FE), as if it were not loaded; --obs" in err
    assert "OB 80 was started, so it is loaded; --obs does not name it" in err
    assert next(event for event in events if event.get("ob") == 86)["x_coding"].startswith("38C4 FE56")
    _, _, err = run("--from", "step7", DATA / "english.txt", *CPU)
    assert "note" not in err


@pytest.mark.parametrize("encoding", ["utf-8", "cp1252"])
def test_text_from_a_forum(run: Run, tmp_path: Path, encoding: str) -> None:
    """Its spaces are no-break ones."""
    text = (
        (DATA / "english.txt").read_text(encoding="utf-8").replace("  ", "\u00a0 ").replace(" 16# ", "\u00a016#\u00a0")
    )
    (tmp_path / "forum.txt").write_text(text, encoding=encoding)
    _, events, _ = run("--from", "step7", tmp_path / "forum.txt", *CPU)
    assert events == run("--from", "step7", DATA / "english.txt", *CPU)[1]
    assert kind_of((tmp_path / "forum.txt").read_bytes()) == "step7"


@pytest.mark.parametrize(
    ("source", "kind"), [("english.txt", "step7"), ("german.txt", "step7"), ("szl.hex", "szl"), ("szl", "szl")]
)
def test_diagnostic_buffer(tmp_path: Path, source: str, kind: str, capsys: pytest.CaptureFixture[str]) -> None:
    """The message names the command that makes a log of it."""
    content = bytes.fromhex((DATA / "szl.hex").read_text()) if source == "szl" else (DATA / source).read_bytes()
    (tmp_path / "buffer").write_bytes(content)
    assert cli.main(["trace", str(tmp_path / "buffer")]) == 2
    found = f"a diagnostic buffer, of which `s7check import --from {kind}` makes one"
    assert capsys.readouterr().out == f"{tmp_path / 'buffer'}:1: unusable: expected a log; found {found}\n"


@pytest.mark.parametrize("indent", [None, 1])
def test_a_program(tmp_path: Path, indent: int | None, capsys: pytest.CaptureFixture[str]) -> None:
    """It is neither a log nor a source, and the message names the command that runs it; a log has no program."""
    file = tmp_path / "program.json"
    file.write_text(json.dumps({"format": "s7-interrupt-program/1", "name": "x"}, indent=indent), encoding="utf-8")
    found = "a program of the kit, which `s7check simulate` runs"
    assert cli.main(["trace", str(file)]) == 2
    assert capsys.readouterr().out == f"{file}:1: unusable: expected a log; found {found}\n"
    assert cli.main(["import", str(file), "--cpu", "S7-300", "--obs", "1"]) == 2
    assert found in capsys.readouterr().err
    assert kind_of(b'{"format": "s7-interrupt-log/1", "x_of": "s7-interrupt-program/1"}\n{"event": "hold"}') is None


@pytest.mark.parametrize("content", ["1234\n", "Event\n", "00A0 0000 0014 0001\n", "", "\n\n{}"])
def test_no_diagnostic_buffer(tmp_path: Path, content: str, capsys: pytest.CaptureFixture[str]) -> None:
    """Of other files nothing of the kind is said."""
    (tmp_path / "other").write_text(content, encoding="utf-8")
    assert cli.main(["trace", str(tmp_path / "other")]) == 2
    assert "s7check import" not in capsys.readouterr().out


def test_example_commands(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each command of the page beside the sources makes a log with the verdict that the page tells."""
    page = (DATA / "README.md").read_text(encoding="utf-8").replace("\\\n", "")
    assert all(path.name in page for path in DATA.iterdir() if path.name != "README.md")
    commands = [line.split()[2:] for line in page.splitlines() if line.startswith("s7check import")]
    monkeypatch.chdir(DATA)
    judged = []
    for number, command in enumerate(commands):
        log = tmp_path / f"{number}.ndjson"
        assert cli.main(["import", *command[:-1], str(log)]) == 0
        report = check(log)
        judged.append((report.verdict, report.line))
    assert judged == [("accepted", None)] * 4 + [("rejected", 5)]


def test_csv_newest_first_with_info(run: Run, tmp_path: Path) -> None:
    """Rows may come newest first; a dotted field is one of info."""
    (tmp_path / "a.csv").write_text("t,e,o,p\n2026-11-21T06:00:01,end,10,\n2026-11-21T06:00:00,start,10,513\n")
    columns = {"at": "t", "event": "e", "ob": "o", "info.period": "p"}
    (tmp_path / "map.json").write_text(json.dumps({"columns": columns, "newest_first": True}))
    arguments = ("--from", "csv", tmp_path / "a.csv", "--map", tmp_path / "map.json", *CPU, "--mode", "RUN")
    _, events, _ = run(*arguments)
    assert events == [
        {"event": "start", "at": "2026-11-21T06:00:00", "ob": 10, "info": {"period": 513}},
        {"event": "end", "at": "2026-11-21T06:00:01", "ob": 10},
    ]


COLUMNS = {"columns": {"at": "t", "event": "e", "ob": "o"}}


@pytest.mark.parametrize(
    ("rows", "columns", "message"),
    [
        ("t,e\n", COLUMNS, 'line 1: expected the heading "o"; found "t,e"'),
        ("t,e,o\n2026-11-21T06:00:00,start\n", COLUMNS, "line 2: expected 3 cells; found another number of them"),
        ("t,e,o\n2026-11-21T06:00:00,start,ten\n", COLUMNS, 'line 2: field "ob": expected an integer 1..32767; found'),
        ("t,e,o\nsoon,start,10\n", COLUMNS, 'header: field "clock": expected a date and time such as'),
        (
            "t,e,o\nsoon,start,10\n",
            COLUMNS | {"times": "%H"},
            'line 2: field "at": expected a time like "06" ("times": "%H"); found "soon"',
        ),
        ("t,e,o\n2026-11-21T06:00:00,begin,10\n", COLUMNS, 'line 2: field "event": expected the name of an event'),
        ("t,e,o\n", COLUMNS, "expected an entry to import; found no entry"),
        ('t,e,o\n"a"b,1,2\n', COLUMNS, "line 2: expected CSV; found"),
        (
            "t,e,o\n\xff",
            COLUMNS | {"encoding": "ascii"},
            'line 2: expected text in ascii; the "encoding" of the column',
        ),
        (
            "t,e,o\n",
            COLUMNS | {"encoding": "klingon"},
            'column map: expected in "encoding" the name of one, such as "utf-8", "cp1252" or "utf-16"; found',
        ),
        ("t,e,o\n", {"columns": {"at": "t"}}, 'column map: expected "event" among the columns; found none'),
        (
            "t,e,o\n",
            {"columns": {}, "colour": 1},
            "column map: expected a JSON object with columns, see docs/checking/import.md",
        ),
        ("t,e,o\n", COLUMNS | {"delimiter": ", "}, 'column map: expected a delimiter of one character; found ", "'),
    ],
)
def test_csv_that_cannot_be_read(
    refused: Callable[..., str], tmp_path: Path, rows: str, columns: dict[str, Any], message: str
) -> None:
    """One message: the line of the file, the field, what was expected."""
    (tmp_path / "a.csv").write_text(rows)
    (tmp_path / "map.json").write_text(json.dumps(columns))
    arguments = ("--from", "csv", tmp_path / "a.csv", "--map", tmp_path / "map.json", *CPU, "--mode", "RUN")
    assert f"{tmp_path / 'a.csv'}: {message}" in refused(*arguments)


def test_output_file(tmp_path: Path) -> None:
    """The file is written whole, and what standard output would have had."""
    log = tmp_path / "log.ndjson"
    arguments = ["import", "--from", "step7", str(DATA / "german.txt"), *CPU]
    assert cli.main([*arguments, "-o", str(log)]) == 0
    piped = subprocess.run([sys.executable, "-m", "s7check", *arguments], capture_output=True, check=True)
    assert log.read_bytes() == piped.stdout
    assert list(tmp_path.iterdir()) == [log]


def test_failed_import_leaves_the_file(tmp_path: Path, refused: Callable[..., str]) -> None:
    """A source that cannot be read leaves the old file alone."""
    log = tmp_path / "log.ndjson"
    log.write_text("old")
    (tmp_path / "a").write_bytes(b"")
    refused("--from", "step7", tmp_path / "a", *CPU, "-o", log)
    assert log.read_text() == "old"


def test_failed_writing_leaves_the_file(
    tmp_path: Path, refused: Callable[..., str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A disk that is full leaves the old file alone, and nothing beside it."""

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    log = tmp_path / "log.ndjson"
    log.write_text("old")
    message = refused("--from", "step7", DATA / "german.txt", *CPU, "-o", log)
    assert message == f"{log}: cannot be written: No space left on device"
    assert [path.read_text() for path in tmp_path.iterdir()] == ["old"]


def test_standard_output_that_cannot_be_written() -> None:
    """One message, exit code 2."""
    arguments = ["import", "--from", "step7", str(DATA / "english.txt"), *CPU]
    with Path("/dev/full").open("wb") as full:
        run = subprocess.run(
            [sys.executable, "-m", "s7check", *arguments], stdout=full, stderr=subprocess.PIPE, text=True, check=False
        )
    message = "Error: standard output: cannot be written: No space left on device\n"
    assert (run.returncode, run.stderr) == (2, message)


def test_no_file(tmp_path: Path, refused: Callable[..., str]) -> None:
    """A file that is not there, an output that cannot be."""
    name = tmp_path / "absent"
    expected = f"{name}: expected a file that can be read; found No such file or directory"
    assert refused("--from", "szl", name, *CPU) == expected
    assert "cannot be written" in refused("--from", "step7", DATA / "german.txt", *CPU, "-o", name / "log")


def test_standard_input() -> None:
    """- is standard input."""
    command = [sys.executable, "-m", "s7check", "import", "--from", "step7", "-", *CPU]
    content = (DATA / "german.txt").read_bytes()
    run = subprocess.run(command, input=content, capture_output=True, check=True)
    assert run.stderr.startswith(b"standard input: 5 entries read, 0 skipped")
    assert run.stdout.startswith(b'{"format": "s7-interrupt-log/1"')


def test_help(capsys: pytest.CaptureFixture[str]) -> None:
    """Help names every kind of source, with its lines as they were set."""
    assert cli.main(["import", "--help"]) == 0
    help_text = capsys.readouterr().out
    assert "\\b" not in help_text
    for kind in ("step7", "szl", "csv", "ring"):
        assert f"\n    {kind} " in help_text
