"""``s7spec views requirements``, over small projects and over this one."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from evidence import cli
from evidence.views.traceability import page as made
from evidence.views.traceability.matrix import COLUMNS, build
from evidence.views.traceability.project import read_project

REQUIREMENTS = """# Requirements

- <a id="TINT-01"></a>**TINT-01** Something. *(S; H)*
- <a id="TINT-02"></a>**TINT-02** Something else
  (see TINT-01). *(S;
  H)*
- <a id="OBS-09"></a>**OBS-09** The rest. *(S; H)*
"""
AMB_01 = '<a id="AMB-01"></a>**AMB-01** Which?\n\n- (a) one\n- (b) two\n'
READINGS = f"""# Readings

{AMB_01}
Default a: why not.

<a id="AMB-02"></a>**AMB-02** When?

- (a) now
- (b) never

Default a: why not.

AMB-01: a log may show anything
"""
SPEC = r"""---- MODULE System ----
(* Rules.  Left out: sizes of buffers [OBS-09]. *)
EXTENDS Integers

(* [TINT-01] .. [TINT-02] *)
Rule == Reading("AMB-01") = "a"
====
"""
PROPERTIES = """---- MODULE Properties ----
EXTENDS System

(* [TINT-02] *)
Part == TRUE
(* [TINT-01] *)
RuleInv == Part
====
"""
MODEL = """---- MODULE MCRules ----
(* A world for [TINT-02]. *)
EXTENDS Properties

OwnInv == TRUE
====
"""
MODELS = """== rules model smoke MCRules.tla 0
Rules.
requirements TINT-01
seconds 0..9, config MCRules.cfg
"""
CONTROLS = """== neg-rule rules 12 OwnInv
System.tla: `= "a"` -> `= "b"`
"""
CASES = """cpu=S7-300 obs=1 clock=2026-03-02T08:00:30.000
== a A TINT-01 TINT-02
== b R1 TINT-02
== c R1 TINT-01
"""
REASONS = [{"ids": ["AMB-02"], "columns": ["reading"], "kind": "unseen", "reason": "no line of a log can show it"}]

FILES = {
    "docs/rules/requirements.md": REQUIREMENTS,
    "docs/rules/readings.md": READINGS,
    "docs/rules/left_out.json": json.dumps(REASONS),
    "spec/System.tla": SPEC,
    "spec/Properties.tla": PROPERTIES,
    "models/MCRules.tla": MODEL,
    "models/MCRules.cfg": "SPECIFICATION Spec\nINVARIANTS RuleInv OwnInv\n",
    "models/models.txt": MODELS,
    "models/controls.txt": CONTROLS,
    "traces/TINT.txt": CASES,
}

Run = Callable[..., int]


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A small project in which nothing is missing."""
    for name, text in FILES.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return tmp_path


@pytest.fixture
def run(project: Path) -> Run:
    """Runs the command over the small project."""
    return lambda *arguments: cli.main(["views", "requirements", "--project", str(project), *arguments])


def replace(path: Path, old: str, new: str) -> None:
    """Change a file of the small project."""
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")


def test_nothing_is_missing(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    """The command says so."""
    assert run() == 0
    assert capsys.readouterr().out.endswith("nothing is missing\n")


def test_this_project(capsys: pytest.CaptureFixture[str]) -> None:
    """Nothing is missing, and the pages are up to date."""
    code = cli.main(["views", "requirements"])
    assert code == 0, capsys.readouterr()


def page_of(project: Path) -> str:
    """The page of the small project."""
    read = read_project(project)
    return made.page(build(read), read)


def test_page(project: Path) -> None:
    """What each requirement has stands on the page, what only touches it in italics."""
    page = page_of(project)
    assert (
        "| [TINT-01](requirements.md#TINT-01) | System: Rule | Properties: RuleInv | rules; *neg-rule* |"
        " [a](../../traces/TINT.txt) | [c](../../traces/TINT.txt) | TLC |\n"
    ) in page
    assert (
        "| [TINT-02](requirements.md#TINT-02) | System: Rule | MCRules: OwnInv; Properties: Part | neg-rule |"
        " *[a](../../traces/TINT.txt)* | [b](../../traces/TINT.txt) | TLC |\n"
    ) in page
    assert "| [OBS-09](requirements.md#OBS-09) | [module] | [module] | [module] | [module] | [module] |  |\n" in page
    assert "| [AMB-01](readings.md#AMB-01) | Which? | System: Rule |  |  |\n" in page
    assert "| [AMB-02](readings.md#AMB-02) | When? | [unseen] |  |  |\n" in page
    assert "| AMB-02 | reading | unseen | no line of a log can show it |\n" in page
    assert "| model that would fail without it | 2 | 1 | 1 | 0 | 0 |\n" in page


def test_modules_that_word_rejections(project: Path, run: Run) -> None:
    """What builds on the explanation of a log names and looks up no rule, and states no property."""
    page = page_of(project)
    (project / "spec" / "PartialLogs.tla").write_text(
        "---- MODULE PartialLogs ----\nEXTENDS System\nA == 1\n====\n", encoding="utf-8"
    )
    explain = SPEC.replace("MODULE System", "MODULE Explain").replace("EXTENDS Integers", "EXTENDS PartialLogs")
    (project / "spec" / "Explain.tla").write_text(explain, encoding="utf-8")
    assert run() == 0
    assert page_of(project) == page


def test_specification_that_the_rules_implement(project: Path, run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    """Where a model checks an instance of it, its formulas are properties."""
    abstract = r"""---- MODULE Abstract ----

(* [TINT-01] *)
Step == TRUE
Next == Step
(* [TINT-02] *)
Unused == FALSE
====
"""
    (project / "spec" / "Abstract.tla").write_text(abstract, encoding="utf-8")
    replace(project / "models/MCRules.tla", "OwnInv == TRUE", "A == INSTANCE Abstract\nOwnInv == A!Next")
    assert run() == 0
    assert "\nnote: Abstract: no model checks Unused\n" in capsys.readouterr().out
    page = page_of(project)
    assert "#TINT-01) | System: Rule | Abstract: Step; Properties: RuleInv | rules; *neg-rule* |" in page


def test_detail(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    """One requirement is shown with files and lines."""
    assert run("TINT-02", "OBS-09", "AMB-01") == 0
    assert capsys.readouterr().out.splitlines() == [
        "TINT-02",
        "  formula   spec/System.tla:6: Rule",
        "  property  models/MCRules.tla:5: OwnInv",
        "  property  spec/Properties.tla:5: Part",
        "  model     models: neg-rule",
        "  accepted  traces/TINT.txt:2: a",
        "  rejected  traces/TINT.txt:3: b",
        "OBS-09",
        *(
            f"  {column:9} [module] sizes of buffers [OBS-09]."
            for column in ("formula", "property", "model", "accepted", "rejected")
        ),
        "AMB-01",
        "  reading   spec/System.tla:6: Rule",
    ]
    assert run("TINT-77") == 2


def test_reading_by_name(project: Path, run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    """A formula looks an ambiguity up by a name of module Readings; a name that none uses is no formula."""
    readings = '---- MODULE Readings ----\n\nChosen == Reading("AMB-01")\n====\n'
    (project / "spec" / "Readings.tla").write_text(readings, encoding="utf-8")
    replace(project / "spec/System.tla", "EXTENDS Integers", "EXTENDS Integers, Readings")
    replace(project / "spec/System.tla", 'Reading("AMB-01")', "Chosen")
    assert run("AMB-01") == 0
    assert capsys.readouterr().out == "AMB-01\n  reading   spec/System.tla:6: Rule\n"
    replace(project / "spec/System.tla", "Rule == Chosen", "Rule == 1")
    assert run() == 1
    assert "AMB-01: no formula that looks its letter up" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("name", "old", "new", "problems"),
    [
        (
            "spec/System.tla",
            "[TINT-01] ..",
            "",
            ["TINT-01: no formula", "TINT-01: no model that would fail without it"],
        ),
        ("spec/Properties.tla", "[TINT-01]", "", ["TINT-01: no property that a model checks"]),
        ("spec/System.tla", 'Reading("AMB-01")', "One", ["AMB-01: no formula that looks its letter up"]),
        ("spec/System.tla", "[OBS-09]", "", [f"OBS-09: no {column}" for column in COLUMNS.values()]),
        ("traces/TINT.txt", "A TINT-01 TINT-02", "A TINT-01", ["TINT-02: no accepted log"]),
        ("traces/TINT.txt", "R1 TINT-02", "R1 TINT-01", ["TINT-02: no rejected log"]),
        (
            "docs/rules/requirements.md",
            '- <a id="OBS-09">',
            '- <a id="OBS-08"></a>**OBS-08** New. *(S; H)*\n- <a id="OBS-09">',
            [f"OBS-08: no {column}" for column in COLUMNS.values()],
        ),
        ("docs/rules/left_out.json", json.dumps(REASONS), "[]", ["AMB-02: no formula that looks its letter up"]),
        ("docs/rules/readings.md", f"{AMB_01}\n", "", ["docs/rules/readings.md: no AMB-01"]),
    ],
)
def test_gap(
    name: str, old: str, new: str, problems: list[str], project: Path, run: Run, capsys: pytest.CaptureFixture[str]
) -> None:
    """What has neither an entry nor a reason is named, and nothing else."""
    replace(project / name, old, new)
    assert run() == 1
    *_, last = lines = capsys.readouterr().out.splitlines()
    unknown = [line for line in lines if "does not exist" in line]
    assert [line for line in lines[7:-1] if line not in unknown] == problems
    assert last == f"problems: {len(problems) + len(unknown)}"


@pytest.mark.parametrize(
    ("name", "old", "new", "unknown"),
    [
        ("spec/System.tla", "[TINT-01] ..", "[TINT-17] [TINT-01] ..", "TINT-17"),
        ("spec/System.tla", "Reading", 'Name("DINT-03") = Reading', "DINT-03"),
        ("models/MCRules.tla", "A world", "A world for IRT-01", "IRT-01"),
        ("models/models.txt", "TINT-01", "TINT-01 CLK-03", "CLK-03"),
        ("traces/TINT.txt", "R1 TINT-02", "R1 TINT-02 AIRT-02", "AIRT-02"),
        ("docs/rules/readings.md", "AMB-01: a log may show anything", "AMB-01: see AMB-17", "AMB-17"),
    ],
)
def test_id_that_does_not_exist(
    name: str, old: str, new: str, unknown: str, project: Path, run: Run, capsys: pytest.CaptureFixture[str]
) -> None:
    """Wherever an ID stands, it has to exist."""
    replace(project / name, old, new)
    assert run() == 1
    assert f"\n{name}: {unknown} does not exist\n" in capsys.readouterr().out


def test_property_that_no_model_checks(project: Path, run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    """It says nothing of a requirement, though its comment names one."""
    replace(project / "models/MCRules.cfg", "RuleInv", "")
    assert run() == 1
    out = capsys.readouterr().out
    assert "\nTINT-01: no property that a model checks\n" in out
    assert "\nnote: Properties: no model checks Part, RuleInv\n" in out


def test_fairness_is_assumed(project: Path, run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    """What stands in the formula of a SPECIFICATION needs no model that checks it."""
    replace(project / "spec/Properties.tla", "====", "\n(* [TINT-01] *)\nFairness == TRUE\n====")
    assert run() == 0
    assert "\nnote: Properties: no model checks Fairness\n" in capsys.readouterr().out
    replace(project / "models/MCRules.tla", "OwnInv ==", "FairSpec == Fairness\nOwnInv ==")
    replace(project / "models/MCRules.cfg", "SPECIFICATION Spec", "SPECIFICATION FairSpec")
    assert run() == 0
    assert "note:" not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("ids", "columns", "problem"),
    [
        (["TINT-01"], ["formula"], "TINT-01: the reason for no formula is void, there is System.Rule"),
        (["TINT-03"], ["formula"], "TINT-03 has no column formula"),
        (["TINT-01"], ["reading"], "TINT-01 has no column reading"),
        (["AMB-01"], ["reading"], "AMB-01: the reason for no reading is void, there is System.Rule"),
    ],
)
def test_void_reason(
    ids: list[str], columns: list[str], problem: str, project: Path, run: Run, capsys: pytest.CaptureFixture[str]
) -> None:
    """A reason for something that is not missing has to go."""
    more = {"ids": ids, "columns": columns, "kind": "not done", "reason": "a reason of some length"}
    (project / "docs/rules/left_out.json").write_text(json.dumps([*REASONS, more]), encoding="utf-8")
    assert run() == 1
    assert f"\ndocs/rules/left_out.json: {problem}\n" in capsys.readouterr().out


def test_reason_that_points_nowhere(project: Path, run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    """The properties, negative controls and logs that a reason names have to be there."""
    reason = "see RuleInv, neg-rule, TINT/a, OtherProp, neg-other, TINT/other and Part"
    (project / "docs/rules/left_out.json").write_text(json.dumps([REASONS[0] | {"reason": reason}]), encoding="utf-8")
    assert run() == 1
    lines = capsys.readouterr().out.splitlines()
    assert lines[7:] == [
        f"docs/rules/left_out.json: AMB-02: {name} does not exist, or no model checks it"
        for name in ("OtherProp", "neg-other", "TINT/other")
    ] + ["problems: 3"]


def test_work_that_is_not_done_is_counted_apart(project: Path, run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    """A reason that only says so is a reason, and shows in the summary."""
    replace(project / "traces/TINT.txt", "R1 TINT-02", "R1 TINT-01")
    more = {"ids": ["TINT-02"], "columns": ["rejected"], "kind": "not done", "reason": "no such log is written yet"}
    (project / "docs/rules/left_out.json").write_text(json.dumps([*REASONS, more]), encoding="utf-8")
    assert run() == 0
    (line,) = (line for line in capsys.readouterr().out.splitlines() if "rejected log" in line)
    assert line.split()[2:] == ["1", "0", "2", "1", "0"]


@pytest.mark.parametrize(
    ("name", "text", "error"),
    [
        ("docs/rules/requirements.md", "# Requirements\n", "requirements.md: no entries"),
        (
            "docs/rules/requirements.md",
            REQUIREMENTS + '- <a id="TINT-01"></a>**TINT-01** Again. *(S; H)*\n',
            "TINT-01 has more than one entry",
        ),
        (
            "docs/rules/requirements.md",
            REQUIREMENTS.replace("rest. *(S; H)*", "rest. *(S)*"),
            "OBS-09: expected an entry like the others behind the anchor",
        ),
        ("docs/rules/readings.md", "# Readings\n", "readings.md: no entries"),
        ("docs/rules/left_out.json", "{}", "left_out.json: Expected `array`"),
        (
            "docs/rules/left_out.json",
            '[{"ids": ["TINT-01"], "columns": ["formulas"]}]',
            "Invalid enum value 'formulas'",
        ),
        ("docs/rules/left_out.json", json.dumps([*REASONS, *REASONS]), "AMB-02, reading: two reasons"),
        ("docs/rules/left_out.json", None, "left_out.json"),
        ("spec/System.tla", SPEC.replace("[TINT-01] .. [TINT-02]", ""), "spec: no comment of a formula names"),
        ("spec/System.tla", SPEC.replace("[TINT-01] ..", "[TINT-03] .."), "is no range"),
        ("spec/System.tla", SPEC.replace("[TINT-01] ..", "[DINT-01] .."), "is no range"),
        ("spec/Properties.tla", PROPERTIES.replace("[", ""), "spec: no comment of a property names"),
        ("spec/System.tla", "nothing", "/System.tla:1: the grammar cannot read this"),
        ("models/MCRules.tla", None, "models: no module"),
        ("models/MCRules.cfg", None, "MCRules.cfg"),
        ("models/models.txt", "rules", "models.txt:1: expected spec FOLDER"),
        ("models/models.txt", None, "models.txt: cannot be read"),
        ("models/controls.txt", None, "models.txt: no negative controls"),
        ("models/models.txt", "", "'rules' is not the name of an entry"),
        ("models/controls.txt", CONTROLS.replace("System.tla", "Rule.tla"), "Rule.tla is not in exactly one of"),
        ("models/controls.txt", CONTROLS.replace('`= "a"', '`= "c"'), "its text is not in System.tla"),
        ("traces/TINT.txt", "", "traces: no accepted log names a requirement"),
        ("traces/TINT.txt", CASES[: CASES.index("== b")], "traces: no rejected log names a requirement"),
        ("traces/TINT.txt", "== a A\n0:31 act 10", "TINT.txt:2: expected clock="),
    ],
)
def test_unreadable(
    name: str, text: str | None, error: str, project: Path, run: Run, capsys: pytest.CaptureFixture[str]
) -> None:
    """What is missing, is something else, or holds nothing is an error with its file."""
    path = project / name
    if text is None:
        path.unlink()
    else:
        path.write_text(text, encoding="utf-8")
    assert run() == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("Error: ")
    assert error in captured.err
