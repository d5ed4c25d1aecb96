"""Everything that the check reads, from one folder of the project."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from evidence.views.traceability import documents
from evidence.views.traceability.controls import Controls, read_controls
from evidence.views.traceability.errors import UnreadableError
from evidence.views.traceability.ids import mentioned
from evidence.views.traceability.logs import Logs, read_logs
from evidence.views.traceability.modules import Module, read_modules
from evidence.views.traceability.proofs import Proof, read_proofs
from evidence.views.traceability.reasons import Reasons, read_reasons
from evidence.views.traceability.roles import rules, statements
from s7check.report.clauses import Clause

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
    """Read everything. Raises `UnreadableError` for a source that is missing, unreadable or empty."""
    spec = read_modules(root / "spec")
    models = read_modules(root / MODELS)
    for kind, stating in (("formula", rules(spec)), ("property", statements(spec))):
        if not any(definition.tags for module in stating for definition in module.definitions):
            raise UnreadableError(f"{root / 'spec'}: no comment of a {kind} names a requirement")
    paths = sorted({path for pattern in CITING for path in root.glob(pattern)})
    return Project(
        {
            name: clause
            for page in (REQUIREMENTS, REQUIREMENTS_S7_1500)
            if page == REQUIREMENTS or (root / page).exists()
            for name, clause in documents.requirements(root / page).items()
        },
        documents.ambiguities(root / READINGS),
        tuple(spec),
        read_controls(root / MODELS, spec, models),
        read_logs(root / TRACES),
        read_reasons(root / REASONS),
        {path.relative_to(root): tuple(dict.fromkeys(mentioned(documents.read(path)))) for path in paths},
        read_proofs(root / PROOFS),
    )
