"""TLC looks for the shortest behaviour of a case."""

from __future__ import annotations

from dataclasses import dataclass

from evidence.common.checkout import ROOT
from evidence.common.gallery import Case
from evidence.common.processes import Processes
from evidence.tla import tlc
from evidence.tla.behaviour import Line, as_log, behaviour
from evidence.tla.modules import module_folders

MODULE = "GalleryCase"
_HEAP = 1500


class NotFoundError(RuntimeError):
    """TLC did not find the case; the message has TLC's words."""


@dataclass(frozen=True)
class Search:
    """How long a search may take, with which TLC."""

    tools: tlc.Toolchain
    processes: Processes
    timeout: float = 120.0

    def __call__(self, case: Case) -> list[Line]:
        """Give header and events of a shortest behaviour of the case. Raises `NotFoundError`."""
        library = (*module_folders(ROOT / "spec"), ROOT / "models")
        config = configuration(case, (ROOT / "models" / "MCGallery.cfg").read_text())
        with tlc.workspace(library, MODULE, module(case), config) as space:
            run = tlc.run(self.tools, space.as_one_module(), tlc.Options(1, False, _HEAP, self.timeout), self.processes)
        outcome = run.outcome
        if outcome.kind != "invariant" or not outcome.trace:
            said = outcome.errors[0] if outcome.errors else outcome.detail
            raise NotFoundError(f"{case.name}: no behaviour found: {outcome.kind}: {said}")
        return as_log(behaviour(outcome.trace))


def module(case: Case) -> str:
    """Write the module that gives the model's constants their values in this case."""
    kinds = ", ".join(f'"{kind}"' for kind in case.kinds)
    definitions = {"MayHappen": f"{{{kinds}}}", "Budget": str(case.budget), "Middle": case.middle, "Goal": case.goal}
    definitions |= {f"Gallery{name}": text for name, text in case.world.items()}
    body = "\n".join(f"Case{name} ==\n    {text}" for name, text in definitions.items())
    return f"---- MODULE {MODULE} ----\nEXTENDS MCGallery\n{body}\n====\n"


def configuration(case: Case, text: str) -> str:
    """Write the configuration: the model's, with the case's definitions in the place of its constants."""
    for name in case.world:
        text = text.replace(f"<- Gallery{name}\n", f"<- CaseGallery{name}\n")
    own = "\n".join(f"    {name} <- Case{name}" for name in ("MayHappen", "Budget", "Middle", "Goal"))
    return text.replace("CONSTANTS\n", f"CONSTANTS\n{own}\n")
