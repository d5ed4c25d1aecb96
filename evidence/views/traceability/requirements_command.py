"""``s7spec views requirements``: does every requirement have its formula, property, model and logs?"""

from __future__ import annotations

from pathlib import Path

import click

from evidence.common.checkout import ROOT
from evidence.views.site import chapters
from evidence.views.traceability.detail import detail
from evidence.views.traceability.matrix import Matrix, build, counts
from evidence.views.traceability.problems import notes, problems
from evidence.views.traceability.project import read_project

GAPS, UNREADABLE = 1, 2


@click.command("requirements", short_help="Trace each requirement to formula, property, model and logs.")
@click.option(
    "--project",
    "root",
    type=click.Path(path_type=Path, file_okay=False),
    default=ROOT,
    help="The project's folder; this checkout by default.",
)
@click.argument("ids", nargs=-1, metavar="[ID]...")
def requirements_command(*, root: Path, ids: tuple[str, ...]) -> int:
    """Check that every requirement and every ambiguity has its entries, or a written reason.

    With IDs: show where these are treated.
    """
    try:
        project = read_project(root)
        matrix = build(project)
        if ids:
            click.echo(detail(root, project, matrix, ids))
            return 0
        book = chapters.problems(project, root) if (root / chapters.BOOK).is_file() else []
    except (OSError, ValueError) as error:
        click.echo(f"Error: {error}", err=True)
        return UNREADABLE
    found = [*problems(project, matrix), *book]
    click.echo(_summary(matrix))
    for note in notes(project):
        click.echo(f"note: {note}")
    for problem in found:
        click.echo(problem)
    click.echo(f"problems: {len(found)}" if found else "nothing is missing")
    return GAPS if found else 0


def _summary(matrix: Matrix) -> str:
    what = f"{len(matrix.rows)} requirements, {len(matrix.readings)} ambiguities"
    lines = [f"{what:38}  have it  (touched)  reason  (not done)  neither"]
    lines += [
        f"  {name:36}  {filled:7}  {indirect:9}  {excused:6}  {not_done:10}  {missing:7}"
        for name, filled, indirect, excused, not_done, missing in counts(matrix)
    ]
    return "\n".join(lines)
