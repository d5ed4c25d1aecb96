"""The numbers of a command's JSON report that the documentation shows."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable
from pathlib import PurePath
from typing import Any

from evidence.views.results.records import Cell, Table

VERDICTS = ("accepted", "rejected", "unusable", "no verdict")


def models(text: str) -> list[Table]:
    """Models by kind, then each model but the negative controls, as TLC found them."""
    report: dict[str, Any] = json.loads(text)
    found: list[dict[str, Any]] = report["models"]
    rows: list[list[Cell]] = [
        [
            kind,
            len(some),
            sum(not m["ok"] for m in some),
            sum(m["distinct"] or 0 for m in some),
            round(sum(m["seconds"] for m in some), 1),
        ]
        for kind, some in _by_kind(found).items()
    ]
    rows.append(_sums(rows))
    each = [
        [m["name"], m["lane"], m["states"], m["distinct"], m["depth"], m["seconds"]]
        for m in found
        if m["kind"] != "negative"
    ]
    again = report["not run again"]
    earlier = f"{again} of them came as pinned in earlier runs, and nothing changed since" if again else ""
    return [
        Table(["kind", "models", "not as pinned", "distinct states", "seconds"], rows, earlier),
        Table(["model", "lane", "states", "distinct", "depth", "seconds"], each, "Each model"),
    ]


def mutants(text: str) -> list[Table]:
    """The score, by module, and how mutants were killed; of properties alone, also each survivor that counts."""
    report: dict[str, Any] = json.loads(text)
    unevaluated = ("unevaluated",) if report["properties_alone"] else ()
    columns = ("mutants", "invalid", "equivalent", *unevaluated, "killed", "survived", "score")
    groups = {**report["modules"], "all": report["all"]}
    score: list[list[Cell]] = [[name, *(numbers[column] for column in columns)] for name, numbers in groups.items()]
    counted = {*columns, "counted", "unevaluated"}
    kills: list[list[Cell]] = [[how, number] for how, number in report["all"].items() if how not in counted]
    tables = [Table(["module", *columns], score), Table(["killed by", "mutants"], kills)]
    survivors: list[list[Cell]] = [
        [mutant["id"], mutant["detail"] or "nothing", mutant["reason"]]
        for mutant in report["mutants"]
        if mutant["how"] == "survived" and mutant["got_past"] and not mutant["equivalent"]
    ]
    if report["properties_alone"]:
        tables.append(Table(["survivor", "noticed otherwise by", "reason"], survivors, "Each survivor"))
    return tables


def witnesses(text: str) -> list[Table]:
    """Conditions by kind, how they are met, and those that nothing meets and that have no reason."""
    report: dict[str, Any] = json.loads(text)
    groups: dict[str, dict[str, int]] = {**report["kinds"], "all": report["all"]}
    columns = list(report["all"])
    without: list[list[Cell]] = [
        [one["id"], " or ".join(one["missing"]), one["text"]]
        for one in report["conditions"]
        if one["missing"] and one["reason"] is None
    ]
    kinds = Table(["kind", *columns], [[name, *numbers.values()] for name, numbers in groups.items()])
    return [kinds, Table(["condition", "never", "text"], without, "Each without a witness")]


def agreement(text: str) -> list[Table]:
    """Random logs by verdict, and how many were judged differently."""
    report: dict[str, Any] = json.loads(text)
    counts = {
        "logs": report["logs"],
        "accepted": report["accepted"],
        "rejected": report["rejected"],
        "lines": report["lines"],
        "differ": report["differ"],
        "unusable, replaced": report["unreadable"],
        "too many explanations, replaced": report["endless"],
        "engine, s": report["engine_seconds"],
        "TLC, s": report["tlc_seconds"],
    }
    return [Table(list(counts), [list(counts.values())])]


def left_out(text: str) -> list[Table]:
    """Accepted logs with kinds left out, and how many were not."""
    report: dict[str, Any] = json.loads(text)
    counts = {
        "accepted logs": report["logs"],
        "with kinds left out": report["left_out"],
        "only certain facts from some line on": report["loose"],
        "not accepted": len(report["worse"]),
    }
    return [Table(list(counts), [list(counts.values())])]


def growth(text: str) -> list[Table]:
    """What each log costs, ten lines first, and how many times as much CPU as these."""
    report: dict[str, Any] = json.loads(text)
    usual = report["usual"]
    columns = ("lines", "verdict", "largest", "followed", "cpu")
    rows: list[list[Cell]] = [
        [cost["kind"], *(cost[column] for column in columns), round(cost["cpu"] / usual["cpu"], 1), cost["memory"]]
        for cost in (usual, *report["costs"])
    ]
    return [Table(["log", "lines", "verdict", "states at a time", "steps", "CPU, s", "times ten lines", "MB"], rows)]


def logs(text: str) -> list[Table]:
    """Shipped logs by area and verdict."""
    areas: dict[str, Counter[str]] = {}
    events: Counter[str] = Counter()
    for report in map(json.loads, text.splitlines()):
        area = PurePath(report["log"]).parts[-3]
        areas.setdefault(area, Counter())[report["verdict"]] += 1
        events[area] += report["events"]
    verdicts = [verdict for verdict in VERDICTS if any(counts[verdict] for counts in areas.values())]
    rows: list[list[Cell]] = [
        [area, counts.total(), *(counts[verdict] for verdict in verdicts), events[area]]
        for area, counts in sorted(areas.items())
    ]
    rows.append(_sums(rows))
    return [Table(["area", "logs", *verdicts, "events explained"], rows)]


def kit(text: str) -> list[Table]:
    """What the kit reaches."""
    report: dict[str, Any] = json.loads(text)
    counts = {
        "programs": report["programs"],
        "logs": report["logs"],
        "guard outcomes reached": report["met"],
        "that can be observed": report["observable"],
        "%": round(100 * report["share"], 1),
        "that cannot": len(report["excused"]),
        "requirements": report["requirements"],
        "reached by fewer than two programs": ", ".join(report["few"]) or "none",
        "logs not accepted": len(report["not_accepted"]),
    }
    return [Table(list(counts), [list(counts.values())])]


def kit_faults(text: str) -> list[Table]:
    """The faults that the kit finds, known and held out."""
    faults: list[dict[str, Any]] = json.loads(text)["faults"]
    rows: list[list[Cell]] = []
    for kind, held_out in (("known", False), ("held out", True)):
        of = [one for one in faults if one["held_out"] == held_out]
        missed = ", ".join(one["fault"] for one in of if not one["program"])
        rows.append([kind, len(of), sum(bool(one["program"]) for one in of), missed or "none"])
    return [Table(["faults", "number", "found", "not found"], rows)]


def kit_mutants(text: str) -> list[Table]:
    """The mutants that the kit's logs show."""
    report: dict[str, Any] = json.loads(text)
    counts = {
        "mutants": report["mutants"],
        "no specification": report["invalid"],
        "shown by no accepted log": report["shown_by_none"],
        "shown by one": report["shown"],
        "by the kit": report["by_kit"],
        "of these by time": report["by_time"],
        "%": round(100 * (report["share"] or 0), 1),
    }
    return [Table(list(counts), [list(counts.values())])]


def fuzz(text: str) -> list[Table]:
    """Damaged inputs by damage and outcome."""
    report: dict[str, Any] = json.loads(text)
    kinds: dict[str, dict[str, int]] = report["outcomes"]
    found = dict.fromkeys(outcome for counts in kinds.values() for outcome in counts)
    outcomes = [outcome for outcome in found if outcome != "failed"]
    rows: list[list[Cell]] = [
        [
            kind,
            *(counts.get(outcome, 0) for outcome in outcomes),
            sum(f": {kind}: " in fault for fault in report["faults"]),
        ]
        for kind, counts in kinds.items()
    ]
    rows.append(_sums(rows))
    return [Table(["damage", *outcomes, "faults"], rows), Table(["slowest, s"], [[report["slowest"]]])]


def edges(text: str) -> list[Table]:
    """Each world with its states, edges and differences."""
    worlds: list[dict[str, Cell]] = json.loads(text)["worlds"]
    return [Table(list(worlds[0]), [list(world.values()) for world in worlds])]


def engines(text: str) -> list[Table]:
    """Each kind of logs with its verdicts and the answers that differ."""
    kinds: list[dict[str, Cell]] = json.loads(text)["kinds"]
    return [Table(list(kinds[0]), [list(kind.values()) for kind in kinds])]


def bench(text: str) -> list[Table]:
    """The tables of the benchmark, as they are."""
    report: dict[str, Any] = json.loads(text)
    return [Table(table["columns"], table["rows"], table["title"]) for table in report["tables"]]


def proofs(text: str) -> list[Table]:
    """Queries by kind, then each query that is to hold, each property, and how many formulas are not proved."""
    report: dict[str, Any] = json.loads(text)
    found: list[dict[str, Any]] = report["queries"]
    rows: list[list[Cell]] = [
        [
            kind,
            len(some),
            sum(not q["ok"] and q["outcome"] != "not asked" for q in some),
            sum(q["outcome"] == "not asked" for q in some),
            sum(q["conditions"] for q in some),
            round(sum(q["seconds"] for q in some)),
            max(q["megabytes"] for q in some),
        ]
        for kind, some in _by_kind(found).items()
    ]
    each: list[list[Cell]] = [
        [q["name"], len(q["formulas"]), q["outcome"], q["conditions"], q["seconds"], q["megabytes"]]
        for q in found
        if q["expect"] == "holds"
    ]
    standing: list[list[Cell]] = [
        [
            *(row[column] for column in ("formula", "module", "of", "proved", "actions")),
            ", ".join(row["not claimed"]),
            _unknown(row),
        ]
        for row in report["formulas"]
    ]
    by_letter = sum("AMB-" in cell["formula"] for cell in report["not_proved"])
    left: list[list[Cell]] = [["the other letters", by_letter], ["no letter", len(report["not_proved"]) - by_letter]]
    return [
        Table(
            ["kind", "queries", "not as claimed", "not asked", "conditions", "seconds", "MB at most"],
            rows,
            f"Apalache {report['apalache']}. {report['assumptions']}",
        ),
        Table(["query", "formulas", "answer", "conditions", "seconds", "MB"], each, "Each proof"),
        Table(
            [
                *("property", "module", "of", "proved of actions", "actions", "not claimed of"),
                "not known of: TLC alone, within its bounds",
            ],
            standing,
            "Each property",
        ),
        Table(["claimed of", "formulas of an action"], left, "Not proved: models/proofs.json says why"),
    ]


def _unknown(row: dict[str, Any]) -> str:
    """The actions of which it is not known if a property can be proved; their number where there are many."""
    actions: list[str] = row["unknown"]
    return ", ".join(actions) if len(actions) <= 8 else f"{len(actions)} actions"


def _by_kind(found: Iterable[dict[str, Any]]) -> dict[str, list[dict[str, Any]]]:
    """Entries of a report by their kind, in the order of the report."""
    kinds: dict[str, list[dict[str, Any]]] = {}
    for one in found:
        kinds.setdefault(one["kind"], []).append(one)
    return kinds


def _sums(rows: list[list[Cell]]) -> list[Cell]:
    """The row of sums of a table whose first column names its rows."""
    return ["all", *(_sum(row[column] for row in rows) for column in range(1, len(rows[0])))]


def _sum(cells: Iterable[Cell]) -> int | float:
    total = sum(cell for cell in cells if isinstance(cell, int | float))
    return total if isinstance(total, int) else round(total, 1)
