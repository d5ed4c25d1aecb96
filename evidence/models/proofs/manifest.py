"""models/proofs.json, the manifest of the proofs: what is claimed, in which world, and what is not."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import msgspec

MANIFEST = Path("models/proofs.json")


class ManifestError(ValueError):
    """The manifest of the proofs is wrong; the text names file and field."""


class NotProved(msgspec.Struct, forbid_unknown_fields=True):
    """A formula not claimed of an action, or a property of states not claimed at all, and the attempt to prove it."""

    action: str
    formula: str
    tried: Annotated[str, msgspec.Meta(min_length=10)]
    letter: Annotated[str, msgspec.Meta(pattern=r"^(AMB-\d\d [a-d](, AMB-\d\d [a-d])*)?$")] = ""
    """The ambiguity and the letter, such as "AMB-49 b", where it is claimed of the other letters; or several that are
    meant together. The query called letter- asks for the counterexample: these letters alone, the others by default."""
    unreached: str = ""
    """Where no behaviour comes to the counterexample: the model in which the formula holds by the letter."""

    @property
    def control(self) -> str:
        """The control of models/controls.txt in which TLC comes to it, such as "letter-66b-CpuProp"."""
        return f"letter-{self._short}-{self.formula}"

    @property
    def readings(self) -> str:
        """The readings of the models that have this letter, in models/MCReadings.tla, such as "Letter66b"."""
        return f"Letter{self._short.replace('-', '')}"

    @property
    def _short(self) -> str:
        return self.letter.replace("AMB-", "").replace(" ", "").replace(",", "-")


class Claim(msgspec.Struct, forbid_unknown_fields=True):
    """A query about an abstract specification: from `init`, after `length` steps, the formula holds."""

    name: str
    module: str
    init: str
    length: int
    formula: str


class Letters(msgspec.Struct, forbid_unknown_fields=True):
    """The actions, by the name of their query, that are asked again of every letter of the ambiguities.

    A CPU shows how it reads the `shown` ones when it is at work, so that they are open in every query.
    """

    together: dict[str, list[str]]
    shown: list[str]


class Elsewhere(msgspec.Struct, forbid_unknown_fields=True):
    """Where a query is asked that needs more than the others: an own module, with own `constants`, if they are named.

    The operators of `instead`, and those that move to the place of each; the last of them replaces it.
    """

    module: str = ""
    constants: str = ""
    instead: dict[str, list[str]] = {}


class Lemma(Elsewhere, forbid_unknown_fields=True, kw_only=True):
    """From the states of `init` the formula holds. With `of`, that operator itself is asked, none in its place."""

    name: str
    init: str
    formula: str
    of: str = ""


class Apart(Elsewhere, forbid_unknown_fields=True, kw_only=True):
    """A query about formulas that speak of more than the world has, of these actions."""

    name: str
    actions: list[str]
    formulas: list[str]
    letters: bool
    """Whether they are asked of every letter, too."""


class OtherFamily(Elsewhere, forbid_unknown_fields=True, kw_only=True):
    """The induction once more, of the CPUs of another family: `formulas` of each action, from the `smaller` states.

    Questions are read by the `letters` of the family, such as "AMB-27 a", the others by default. No other CPU takes the
    actions `only`.
    """

    name: str
    formulas: list[str]
    letters: str
    only: list[str] = []


class World(msgspec.Struct, forbid_unknown_fields=True):
    """The states before a step, `state`, in which at most so many start events wait, and so many OBs run."""

    state: str
    waiting: int
    running: int


class Induction(msgspec.Struct, forbid_unknown_fields=True):
    """The names that the induction has in its module; `timeout` in seconds."""

    module: str
    constants: str
    first: str
    any: str
    invariants: list[str]
    control: str
    world: World
    smaller: World
    """In its place in the queries of letters and refinements, which take longer."""
    refuted: World
    """In its place in the queries that ask for a counterexample: from fewer states it is found in less time."""
    timeout: int
    together: dict[str, list[str]] = {}
    """Actions that are asked in one query of that name: reading the module takes longer than an easy action."""
    divided: dict[str, list[int]] = {}
    """By globs of queries about steps, the transitions at which Apalache begins anew: each makes the question of the
    next ones larger."""
    unfiltered: list[str] = []
    """Queries of steps in which Apalache is not asked first which transitions a state can take."""
    instead: dict[str, list[str]] = {}
    """Operators of spec/, and the operators that move to the place of each; the last of them replaces it."""
    lemmas: list[Lemma] = []
    apart: list[Apart] = []
    """These formulas are not asked of these actions in the queries of the actions themselves."""
    families: list[OtherFamily] = []
    able: dict[str, str] = {}
    """By actions that take no step by default the letter by which their control takes one, such as "AMB-81 b"."""

    def apart_of(self, action: str, formula: str) -> Apart | None:
        """Where the formula is asked of the action, if not in the world of the others."""
        found = (apart for apart in self.apart if action in apart.actions and formula in apart.formulas)
        return next(found, None)


class Refinement(msgspec.Struct, forbid_unknown_fields=True):
    """The formulas by which System implements abstract specifications: `begins` and, of each action, `steps`.

    Its `module` extends that of the induction, with a mapping, with `constants` and initial predicates of its own. Each
    action is asked together with the action `history`, of variables that the mapping alone has.
    """

    module: str
    constants: str
    first: str
    any: str
    history: str
    begins: list[str]
    steps: list[str]
    unfiltered: list[str] = []
    """Globs of queries of the induction: after them Apalache is not asked first which transitions a state can take."""


class ProofsFile(msgspec.Struct, forbid_unknown_fields=True):
    """The whole file."""

    version: Literal[1]
    induction: Induction
    refinements: dict[str, Refinement]
    """By the first word of the names of their queries."""
    letters: Letters
    not_proved: list[NotProved]
    mutants: dict[str, list[str]]
    """By action the controls, each with the formula behind it where that is not the property of the control."""
    claims: list[Claim]
    claim_mutants: dict[str, list[str]]
    """The same by the name of a claim."""


def read(path: Path) -> ProofsFile:
    """The manifest at `path`. Raises `ManifestError`, OSError."""
    try:
        return msgspec.json.decode(path.read_bytes(), type=ProofsFile)
    except msgspec.MsgspecError as error:
        raise ManifestError(f"{path}: {error}") from error
