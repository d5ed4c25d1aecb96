"""``s7spec views requirements``: does every requirement have its formula, property, model and logs?"""

from __future__ import annotations

from pathlib import Path

import click

from evidence.common.checkout import ROOT
from evidence.views.traceability import documents
from evidence.views.traceability.detail import detail
from evidence.views.traceability.errors import UnreadableError
from evidence.views.traceability.matrix import Matrix, build, counts
from evidence.views.traceability.page import page
from evidence.views.traceability.problems import notes, problems
from evidence.views.traceability.project import PAGE, Project, read_project

GAPS, UNREADABLE = 1, 2


@click.command("requirements", short_help="Trace each requirement to formula, property, model and logs.")
@click.option("--write", is_flag=True, help="Write traceability.md.")
@click.option(
    "--project",
    "root",
    type=click.Path(path_type=Path, file_okay=False),
    default=ROOT,
    help="The project's folder; this checkout by default.",
)
@click.argument("ids", nargs=-1, metavar="[ID]...")
def requirements_command(*, write: bool, root: Path, ids: tuple[str, ...]) -> int:
    """Check that every requirement and every ambiguity has its entries, or a written reason.

    With IDs: show where these are treated.
    """
    try:
        project = read_project(root)
        matrix = build(project)
        if ids:
            click.echo(detail(root, project, matrix, ids))
            return 0
        stale = _pages(root, project, matrix, write=write)
    except UnreadableError as error:
        click.echo(f"Error: {error}", err=True)
        return UNREADABLE
    outdated = [f"{path}: not up to date: s7spec views requirements --write" for path in stale]
    found = [*problems(project, matrix), *outdated]
    click.echo(_summary(matrix))
    for note in notes(project):
        click.echo(f"note: {note}")
    for problem in found:
        click.echo(problem)
    click.echo(f"problems: {len(found)}" if found else "nothing is missing")
    return GAPS if found else 0


def _pages(root: Path, project: Project, matrix: Matrix, *, write: bool) -> list[Path]:
    """The generated pages that are not up to date, after writing them if that was asked for."""
    texts = {
        PAGE: page(matrix, project),
    }
    if write:
        for path, text in texts.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text, encoding="utf-8")
    return [p for p, text in texts.items() if not (root / p).is_file() or documents.read(root / p) != text]


def _summary(matrix: Matrix) -> str:
    what = f"{len(matrix.rows)} requirements, {len(matrix.readings)} ambiguities"
    lines = [f"{what:38}  have it  (touched)  reason  (not done)  neither"]
    lines += [
        f"  {c.name:36}  {c.filled:7}  {c.indirect:9}  {c.excused:6}  {c.not_done:10}  {c.missing:7}"
        for c in counts(matrix)
    ]
    return "\n".join(lines)
