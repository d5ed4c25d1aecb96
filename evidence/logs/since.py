"""Two checkouts side by side: verdicts about logs, pinned results, reasons."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from evidence.common.cases import Case
from evidence.logs.since_judging import Judged

NO_VERDICT = "no verdict"

Content = tuple[str, ...]
"""Header and events of a log, however they are spelled."""

_WORDS = ("verdict", "line", "requirements", "reason")
"""What a case says of its log."""


@dataclass(frozen=True)
class Logs:
    """The cases of a checkout, with the file and the content of each log, by the names of the cases."""

    cases: Mapping[str, Case]
    files: Mapping[str, Path]
    content: Mapping[str, Content]


@dataclass(frozen=True)
class Difference:
    """A result that is not that of the earlier revision; `id` names it in the file of expected differences."""

    id: str
    text: str


@dataclass
class Comparison:
    """One kind of result in two checkouts.

    `same` counts the results that are alike, also results `moved` to another name; `new` are only in this
    checkout. `undecided` are the logs without a verdict in both. `notes` are worth a line and no difference.
    """

    what: str
    same: int = 0
    moved: int = 0
    new: int = 0
    differences: list[Difference] = field(default_factory=list)
    undecided: list[Difference] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


def renamed(before: Mapping[str, Content], now: Mapping[str, Content]) -> dict[str, str]:
    """The name in this checkout of each earlier log that is still there, under its name or with its very content."""
    by_content: defaultdict[Content, list[str]] = defaultdict(list)
    for name, content in now.items():
        if name not in before:
            by_content[content].append(name)
    found = {}
    for name, content in before.items():
        if name in now:
            found[name] = name
        elif same := by_content[content]:
            found[name] = same.pop(0)
    return found


def cases(before: Logs, now: Logs, names: Mapping[str, str]) -> Comparison:
    """Compare what logs consist of; other words about them are noted. `names` maps earlier names to present ones."""
    found = Comparison("cases with the same events and words", new=len(now.cases) - len(names))
    for old, new in names.items():
        was, case = before.cases[old], now.cases[new]
        words = [name for name in _WORDS if getattr(was, name) != getattr(case, name)]
        if before.content[old] != now.content[new]:
            found.differences.append(Difference(f"case/{old}", "its log has other events"))
        elif words:
            found.notes.append(f"case/{old}: another {', '.join(words)}")
        else:
            found.same += 1
            found.moved += old != new
    return found


def logs(
    what: str, kind: str, before: Mapping[str, Judged], now: Mapping[str, Judged], names: Mapping[str, str]
) -> Comparison:
    """Compare verdict and line; other requirements are noted. `names` maps earlier names to present ones."""
    found = Comparison(what, new=len(now.keys() - set(names.values())))
    for name, was in before.items():
        if name not in names:
            found.differences.append(Difference(f"{kind}/{name}", f"{was}; the log is gone"))
            continue
        judged = now[names[name]]
        if (was.verdict, was.line) != (judged.verdict, judged.line):
            found.differences.append(Difference(f"{kind}/{name}", f"{was}; now {judged}: {judged.message}"))
            continue
        if was.verdict == NO_VERDICT:
            found.undecided.append(Difference(f"{kind}/{name}", f"{NO_VERDICT}: {judged.message}"))
            continue
        found.same += 1
        found.moved += name != names[name]
        if was.requirements != judged.requirements:
            ids = (" ".join(one.requirements) or "none" for one in (was, judged))
            found.notes.append(f"{kind}/{name}: requirements {'; now '.join(ids)}")
    return found


def pins(before: Mapping[str, str], now: Mapping[str, str]) -> Comparison:
    """Compare the pinned results of models and negative controls."""
    found = Comparison("models and negative controls, pinned", new=len(now.keys() - before.keys()))
    for name, was in before.items():
        if name not in now:
            found.differences.append(Difference(f"model/{name}", f"{was}; the model is gone"))
        elif now[name] != was:
            found.differences.append(Difference(f"model/{name}", f"{was}; now {now[name]}"))
        else:
            found.same += 1
    return found


def reasons(what: str, kind: str, before: Mapping[str, str], now: Mapping[str, str]) -> Comparison:
    """Compare reasons: one with the same words for another id has moved, since an id depends on the text around it."""
    by_words: defaultdict[str, list[str]] = defaultdict(list)
    for name, words in now.items():
        if name not in before:
            by_words[words].append(name)
    found = Comparison(what)
    for name, words in before.items():
        if name in now:
            found.same += 1
            if now[name] != words:
                found.notes.append(f"{kind}/{name}: another reason: {now[name]}")
        elif by_words[words]:
            found.same += 1
            found.moved += 1
            found.notes.append(f"{kind}/{name}: now {by_words[words].pop(0)}")
        else:
            found.differences.append(Difference(f"{kind}/{name}", f"gone: {words}"))
    found.new = sum(map(len, by_words.values()))
    return found
