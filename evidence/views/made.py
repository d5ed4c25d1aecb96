"""The views: pages and sources that are made from data and kept nowhere, by the places where links look for them."""

from __future__ import annotations

from pathlib import Path

from evidence.common.checkout import ROOT
from evidence.kit.implementations import kit_results
from evidence.views.differences.migration import migration_page
from evidence.views.differences.pages import SOURCES, differences_page, experiments_page, sources
from evidence.views.gallery import page as gallery
from evidence.views.results import page as results
from evidence.views.results import records
from evidence.views.results.runs import old
from evidence.views.traceability import page as traceability
from evidence.views.traceability.matrix import build
from evidence.views.traceability.project import Project
from s7check.engine.client import Engine
from s7check.simulating.kept import DIFFERENCES, EXPERIMENTS, read_kept

RULES = Path("docs/rules")


def views(project: Project, engine: Engine) -> dict[Path, str]:
    """The texts by their places in a checkout. Raises OSError, ValueError, EngineError."""
    experiments = read_kept(EXPERIMENTS)
    kept = records.read(ROOT / "docs/project/results")
    return {
        RULES / "differences.md": differences_page(engine, read_kept(DIFFERENCES)),
        RULES / "migration-s7-1500.md": migration_page(engine),
        RULES / "experiments.md": experiments_page(engine, experiments),
        **{RULES / SOURCES / f"{name}.scl": text for name, text in sources(experiments).items()},
        RULES / "gallery.md": gallery.page(),
        RULES / "traceability.md": traceability.page(build(project), project),
        Path("docs/project/results-in-full.md"): results.page(kept, old(kept)),
        Path("docs/checking/kit-results.md"): kit_results(),
    }
