"""Everything that the check reads, from one folder of the project."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from evidence.views.traceability.controls import Controls, read_controls
from evidence.views.traceability.ids import mentioned
from evidence.views.traceability.logs import Logs, read_logs
from evidence.views.traceability.modules import Module, read_modules
from evidence.views.traceability.proofs import Proof, read_proofs
from evidence.views.traceability.reasons import Reasons, read_reasons
from evidence.views.traceability.roles import rules, statements
from s7check.report.clauses import Clause, questions_of, requirements_of

REQUIREMENTS = Path("docs/rules/requirements.md")
REQUIREMENTS_S7_1500 = Path("docs/rules/requirements-s7-1500.md")
READINGS = Path("docs/rules/readings.md")
REASONS = Path("docs/rules/left_out.json")
MODELS = Path("models")
TRACES = Path("traces")
PROOFS = Path("docs/project/results/proofs.json")

CITING = (
    "README.md", "docs/**/*.md", "docs/rules/left_out.json", "spec/**/*.tla", "models/*.tla", "models/models.txt",
    "models/controls.txt", "traces/README.md", "traces/*.txt", "examples/soft_plc/*.md",
    "examples/soft_plc/*/*.[ch]", "examples/soft_plc/scenarios/*.json",
)  # fmt: skip
"""The files in which every ID has to exist."""


T = TypeVar("T")


@dataclass(frozen=True)
class Project:
    """All that was read; `cited` are the IDs that each of the files names, `proofs` the properties with proofs."""

    requirements: dict[str, Clause]
    ambiguities: dict[str, Clause]
    spec: tuple[Module, ...]
    controls: Controls
    logs: Logs
    reasons: Reasons
    cited: dict[Path, tuple[str, ...]]
    proofs: dict[str, Proof]


def read_project(root: Path) -> Project:
    """Read everything. Raises OSError; ValueError for a source that is missing, unreadable or empty."""
    spec = read_modules(root / "spec")
    models = read_modules(root / MODELS)
    for kind, stating in (("formula", rules(spec)), ("property", statements(spec))):
        if not any(definition.tags for module in stating for definition in module.definitions):
            raise ValueError(f"{root / 'spec'}: no comment of a {kind} names a requirement")
    paths = sorted({path for pattern in CITING for path in root.glob(pattern)})
    return Project(
        {
            clause.id: clause
            for page in (REQUIREMENTS, REQUIREMENTS_S7_1500)
            if page == REQUIREMENTS or (root / page).exists()
            for clause in _of(root / page, requirements_of)
        },
        {clause.id: clause for clause in _of(root / READINGS, questions_of)},
        tuple(spec),
        read_controls(root / MODELS, spec, models),
        read_logs(root / TRACES),
        read_reasons(root / REASONS),
        {path.relative_to(root): tuple(dict.fromkeys(_of(path, mentioned))) for path in paths},
        read_proofs(root / PROOFS),
    )


def _of(path: Path, made: Callable[[str], T]) -> T:
    """What `made` makes of the text of a document. Raises ValueError with its name."""
    try:
        return made(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise ValueError(f"{path}: {error}") from error
