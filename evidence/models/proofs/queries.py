"""The queries of the proofs: models/proofs.json, the actions of System, and the properties of spec/properties.

The induction has for each action of System a query: from any state in which the invariant holds, the invariant holds
after the action, and the step is as every property of steps says. The actions and the properties are read from spec/,
so that none is forgotten; models/proofs.json lists the exceptions from the claim, with the reason.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from pathlib import Path
from typing import Annotated, Literal

import msgspec
from msgspec import UNSET, structs
from tree_sitter import Node

from evidence.common.checkout import MANIFEST as MODELS
from evidence.models.entries import Entry, Mutation, read
from evidence.models.entries import ManifestError as ModelsError
from evidence.tla.actions import acting, disjuncts
from evidence.tla.modules import read_modules
from evidence.tla.syntax import Module, operand, token

MANIFEST = Path("models/proofs.json")
BOXED = re.compile(r"^(\w+) ==\s*\[\]\[", re.MULTILINE)
STATED = re.compile(r"^(\w+Inv) ==", re.MULTILINE)

FOLLOWS = "invariants"
"""The query about the properties of states."""

TOGETHER = "Together"
"""The disjunction of the actions of a query, with its history."""

NEXT_OF_CLAIMS = "APNext"
"""The next-state relation of the abstract specifications in models/."""

Kind = Literal[
    "begins", "step", "follows", "lemma", "refines", "letters", "letter", "family", "control", "mutant", "claim"
]


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
        return f"letter-{_short(self.letter)}-{self.formula}"


def _short(letters: str) -> str:
    return letters.replace("AMB-", "").replace(" ", "").replace(",", "-")


@dataclass(frozen=True)
class Mutant:
    """A negative control of models/controls.txt: with its change the formula no longer holds.

    `of` is the action, or the query about an abstract specification, of which it held.
    """

    control: str
    of: str
    formula: str


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


@dataclass(frozen=True)
class Query:
    """What Apalache is asked: `expect` of the formulas from `init` after `length` steps of `next`.

    `actions` are the actions of System whose disjunction is `next`, with `history`; `mutations` changes of the
    specification, `constants` the initial predicate of the constants, `instead` the operators that stand in the places
    of others.
    With `shown` ambiguities are read by any letter, but for these; a formula is not asked of the letters that `unless`
    has for it. With letters in `alone`, such as "AMB-21 b", by these, and the others by default.
    Where it is `unfiltered`, formulas are asked of each transition, whether a state can take it or not. At the
    transitions in `divided` Apalache begins anew.
    """

    name: str
    kind: Kind
    module: str
    init: str
    next: str
    length: int
    formulas: tuple[str, ...]
    timeout: int
    actions: tuple[str, ...] = ()
    history: str = ""
    constants: str = ""
    instead: tuple[tuple[str, tuple[str, ...]], ...] = ()
    shown: tuple[str, ...] | None = None
    unless: tuple[tuple[str, tuple[str, ...]], ...] = ()
    alone: str = ""
    expect: Literal["holds", "violated"] = "holds"
    mutations: tuple[Mutation, ...] = ()
    unfiltered: bool = False
    divided: tuple[int, ...] = ()
    world: str = ""
    """The module whose .cfg names the constants of the world; `module` itself where it is empty."""


@dataclass(frozen=True)
class Proofs:
    """The manifest with its queries in order, and the properties by module: of steps and of states."""

    file: ProofsFile
    queries: tuple[Query, ...]
    actions: tuple[str, ...]
    steps: dict[str, tuple[str, ...]]
    states: dict[str, tuple[str, ...]]

    @property
    def contradicted(self) -> list[NotProved]:
        """The properties that letters contradict: each has a control for TLC and a log.

        The invariants of the induction have none, since they are no properties of System; nor has a counterexample that
        no behaviour comes to.
        """
        return [
            cell
            for cell in self.file.not_proved
            if cell.letter and not cell.unreached and cell.formula not in self.file.induction.invariants
        ]

    def in_small_world(self) -> Proofs:
        """The same, but the queries of steps begin where those begin that ask for a counterexample; none is divided."""
        base = self.file.induction
        steps = {query.name: replace(query, divided=()) for query in self.queries if query.kind == "step"}
        small = [_begun_in(base, base.refuted, steps[q.name]) if q.name in steps else q for q in self.queries]
        file = structs.replace(self.file, induction=structs.replace(base, world=base.refuted))
        return replace(self, file=file, queries=tuple(small))

    def select(self, names: tuple[str, ...]) -> list[Query]:
        """The queries whose name or action a glob matches; all without globs. Raises `ManifestError`."""
        for glob in names:
            if not any(_matches(query, glob) for query in self.queries):
                raise ManifestError(f"no query or action is called {glob}: s7spec prove --list names them")
        return [q for q in self.queries if not names or any(_matches(q, glob) for glob in names)]


def _matches(query: Query, glob: str) -> bool:
    return fnmatchcase(query.name, glob) or (
        query.kind == "step" and any(fnmatchcase(action, glob) for action in query.actions)
    )


def load(root: Path) -> Proofs:
    """The queries of the checkout at `root`. Raises `ManifestError`, OSError."""
    path = root / MANIFEST
    try:
        file = msgspec.json.decode(path.read_bytes(), type=ProofsFile)
    except msgspec.MsgspecError as error:
        raise ManifestError(f"{path}: {error}") from error
    modules = read_modules(root / "spec")
    others = {action for family in file.induction.families for action in family.only}
    actions = tuple(action for action in named_actions(modules) if action not in others)
    steps, states = properties(modules)
    stated = {name for names in states.values() for name in names}
    formulas = {name for names in steps.values() for name in names} | set(file.induction.invariants)
    refined = {formula for refinement in file.refinements.values() for formula in refinement.steps}
    models = _models(root / MODELS)
    changes = {model.name: tuple(model.mutate) for model in models.values()}
    mutants, claim_mutants = (tuple(_mutants(listed, models)) for listed in (file.mutants, file.claim_mutants))
    joined = [action for some in file.induction.together.values() for action in some]
    if len(joined) != len(set(joined)) or not set(joined) <= set(actions):
        raise ManifestError(f"{path}: induction.together: expected actions of System, each once")
    named = [(cell.action, cell.formula) for cell in file.not_proved]
    for action, formula in named:
        if action == FOLLOWS and formula in stated:
            continue
        if action not in actions:
            raise ManifestError(f"{path}: {action} is no action of System")
        if formula not in formulas | refined:
            raise ManifestError(f"{path}: {formula} is neither a property of steps nor an invariant")
    for mutant in mutants:
        if mutant.of not in actions or mutant.formula not in formulas | stated | refined:
            raise ManifestError(f"{path}: mutants: expected an action and a property, not {mutant}")
        if not changes.get(mutant.control):
            raise ManifestError(f"{path}: mutants: {mutant.control} is no control of {MODELS} that changes a module")
    named_claims = {claim.name for claim in file.claims}
    for changed in claim_mutants:
        if changed.of not in named_claims:
            raise ManifestError(f"{path}: claim_mutants: expected the name of a claim, not {changed}")
        if not changes.get(changed.control):
            raise ManifestError(f"{path}: claim_mutants: {changed.control} is no control of {MODELS}")
    proofs = Proofs(
        file, tuple(_queries(file, actions, steps, states, changes, (mutants, claim_mutants))), actions, steps, states
    )
    for glob, places in file.induction.divided.items():
        matched = any(query.divided and fnmatchcase(query.name, glob) for query in proofs.queries)
        if not matched or places != sorted(set(places)) or places[0] < 1:
            said = "expected a glob of queries about steps, and numbers above 0 in order"
            raise ManifestError(f"{path}: induction.divided: {glob}: {places}: {said}")
    if unknown := set(file.induction.unfiltered) - {query.name for query in proofs.queries if query.kind == "step"}:
        raise ManifestError(f"{path}: induction.unfiltered: expected queries about steps, not {', '.join(unknown)}")
    unreached = [cell for cell in file.not_proved if cell.unreached]
    for cell in [*proofs.contradicted, *unreached]:
        name = cell.unreached or cell.control
        if not _shows(models.get(name), cell):
            raise ManifestError(f"{path}: not_proved: {MODELS} has no model {name} of {cell.formula} by {cell.letter}")
    return proofs


def _models(path: Path) -> dict[str, Entry]:
    """The entries of the models by their names. Raises `ManifestError`, OSError."""
    try:
        return {entry.name: entry for entry in read(path).entries}
    except ModelsError as error:
        raise ManifestError(str(error)) from error


def _mutants(listed: dict[str, list[str]], models: dict[str, Entry]) -> Iterator[Mutant]:
    for of, controls in listed.items():
        for text in controls:
            control, _, formula = text.partition(" ")
            own = models[control].expect.property if control in models else ""
            yield Mutant(control, of, formula or own or "")


def _shows(model: Entry | None, cell: NotProved) -> bool:
    """Whether a control violates this formula by this letter; or whether a model has it hold, where it is unreached."""
    if model is None or model.constants.get("ReadingSets") != f"<- Letter{_short(cell.letter).replace('-', '')}":
        return False
    if not cell.unreached:
        return model.expect.property == cell.formula
    return model.expect.exit == 0 and model.properties is not UNSET and cell.formula in model.properties


def named_actions(modules: dict[str, Module]) -> tuple[str, ...]:
    """The actions of which Next of System is the disjunction."""
    system = modules["System"]
    steps = acting("System", modules)

    def parts(node: Node) -> list[str]:
        found = [name for part in disjuncts(node) for name in parts(part) or [token(part)]]
        return found if all(name in steps for name in found) else []

    def ends(name: str) -> list[str]:
        return [end for part in parts(operand(system.definitions[name], "definition")) for end in ends(part)] or [name]

    return tuple(ends("Next"))


def properties(modules: dict[str, Module]) -> tuple[dict[str, tuple[str, ...]], dict[str, tuple[str, ...]]]:
    """The properties of steps and of states, by the module of the properties."""
    others = ("PropertiesS71500",)  # TLC alone checks these; a query about an S7-1500 names its formulas
    stating = [name for name in modules if name.startswith("Properties") and name not in others]
    texts = {name: modules[name].text.decode() for name in stating}
    steps = {name: tuple(BOXED.findall(text)) for name, text in texts.items()}
    states = {name: tuple(STATED.findall(text)) for name, text in texts.items()}
    return {k: v for k, v in steps.items() if v}, {k: v for k, v in states.items() if v}


def _queries(
    file: ProofsFile,
    actions: tuple[str, ...],
    steps: dict[str, tuple[str, ...]],
    states: dict[str, tuple[str, ...]],
    changes: dict[str, tuple[Mutation, ...]],
    changed_rules: tuple[tuple[Mutant, ...], ...],
) -> list[Query]:
    mutants, claim_mutants = changed_rules
    base = file.induction
    left = {(cell.action, cell.formula) for cell in file.not_proved if not cell.letter}
    anywhere = Query(
        name=FOLLOWS,
        kind="follows",
        module=base.module,
        init=base.any,
        next=actions[0],
        length=0,
        formulas=tuple(name for names in states.values() for name in names if (FOLLOWS, name) not in left),
        timeout=base.timeout,
        world=base.module,
        constants=base.constants,
        instead=tuple((name, tuple(others)) for name, others in base.instead.items()),
    )
    queries = [
        replace(anywhere, name="first", kind="begins", init=base.first, formulas=tuple(base.invariants)),
        anywhere,
        *(_lemma(anywhere, lemma) for lemma in base.lemmas),
    ]
    whole = (*base.invariants, *(name for names in steps.values() for name in names))
    joined = {action for some in base.together.values() for action in some}
    groups = {**{action: [action] for action in actions if action not in joined}, **base.together}

    def claimed(formulas: Iterable[str], some: Iterable[str]) -> tuple[str, ...]:
        return tuple(
            formula
            for formula in formulas
            if not any((action, formula) in left or base.apart_of(action, formula) for action in some)
        )

    def step(name: str, kind: Kind, some: list[str], formulas: tuple[str, ...]) -> Query:
        following = some[0] if len(some) == 1 else TOGETHER
        asked = replace(anywhere, name=name, kind=kind, next=following, actions=tuple(some), length=1)
        return replace(asked, formulas=formulas, unfiltered=name in base.unfiltered)

    def divided(query: Query) -> Query:
        found = (at for glob, at in base.divided.items() if fnmatchcase(query.name, glob))
        return replace(query, divided=tuple(next(found, ())))

    def in_its_world(query: Query, action: str, formula: str) -> Query:
        apart = base.apart_of(action, formula)
        return _elsewhere(query, apart) if apart else query

    aparts = [
        (apart, _elsewhere(step(apart.name, "step", apart.actions, tuple(apart.formulas)), apart))
        for apart in base.apart
    ]
    queries += [divided(step(name, "step", some, claimed(whole, some))) for name, some in groups.items()]
    queries += [query for _, query in aparts]
    smaller = _begun_in(base, base.smaller, anywhere)
    refines = {word: _refines(smaller, refinement) for word, refinement in file.refinements.items()}
    stepping = [query for query in queries if query.name in groups]
    for word, refinement in file.refinements.items():
        first = replace(refines[word], name=f"{word}-first", init=refinement.first, actions=actions[:1])
        queries.append(replace(first, formulas=tuple(refinement.begins)))
        for query in stepping:
            name = f"{word}-{query.name}"
            after = replace(refines[word], name=name, actions=query.actions, length=1)
            after = replace(after, unfiltered=any(fnmatchcase(query.name, glob) for glob in refinement.unfiltered))
            queries.append(divided(replace(after, formulas=claimed(refinement.steps, query.actions))))

    def unless(some: list[str]) -> tuple[tuple[str, tuple[str, ...]], ...]:
        cells = [cell for cell in file.not_proved if cell.letter and cell.action in some]
        of = {cell.formula: tuple(sorted({c.letter for c in cells if c.formula == cell.formula})) for cell in cells}
        return tuple(of.items())

    def of_letters(query: Query) -> Query:
        query = replace(query, name=f"letters-{query.name}", kind="letters", unfiltered=True)
        query = _begun_in(base, base.smaller, query)
        return divided(replace(query, shown=tuple(file.letters.shown), unless=unless(list(query.actions))))

    queries += [
        of_letters(step(name, "step", some, claimed(whole, some))) for name, some in file.letters.together.items()
    ]
    queries += [of_letters(query) for apart, query in aparts if apart.letters]

    def one(action: str, asked: Query) -> Query:
        following = TOGETHER if asked.history else action
        refuted = replace(asked, next=following, actions=(action,), length=1, expect="violated")
        return _begun_in(base, base.refuted, refuted)

    queries += [
        replace(
            one(cell.action, in_its_world(anywhere, cell.action, cell.formula)),
            name=f"letter-{cell.action}-{cell.formula}-{cell.letter.replace(', ', '-').replace(' ', '-')}",
            kind="letter",
            formulas=(cell.formula,),
            shown=tuple(file.letters.shown),
            alone=cell.letter,
            unfiltered=True,
        )
        for cell in file.not_proved
        if cell.letter
    ]

    def control(action: str) -> Query:
        query = replace(one(action, anywhere), name=f"control-{action}", kind="control", formulas=(base.control,))
        letter = base.able.get(action)
        return query if letter is None else replace(query, alone=letter, shown=tuple(file.letters.shown))

    controls = list(map(control, actions))
    queries += controls
    for family in base.families:
        first = replace(anywhere, name="first", kind="begins", init=base.first, formulas=tuple(base.invariants))
        its = groups | {action: [action] for action in family.only}
        asked = [step(name, "family", some, tuple(family.formulas)) for name, some in its.items()]
        asked = [first, *(_begun_in(base, base.smaller, query) for query in asked), *controls]
        queries += [_of_family(query, family, file) for query in [*asked, *map(control, family.only)]]
    of = {formula: refines[word] for word, refinement in file.refinements.items() for formula in refinement.steps}
    queries += [
        replace(
            one(mutant.of, in_its_world(of.get(mutant.formula, anywhere), mutant.of, mutant.formula)),
            name=f"mutant-{mutant.control.removeprefix('neg-')}",
            kind="mutant",
            formulas=(mutant.formula,),
            mutations=changes[mutant.control],
        )
        for mutant in mutants
    ]
    claims = {claim.name: _claim(claim, base.timeout) for claim in file.claims}
    changed = [
        replace(
            claims[mutant.of],
            name=f"mutant-{mutant.control.removeprefix('neg-')}",
            kind="mutant",
            formulas=(mutant.formula,),
            expect="violated",
            mutations=changes[mutant.control],
        )
        for mutant in claim_mutants
    ]
    return [*queries, *changed, *claims.values()]


def _begun_in(base: Induction, world: World, query: Query) -> Query:
    """The query from the states of this world instead of the induction's."""
    kept = [(name, others) for name, others in query.instead if name != base.world.state]
    return replace(query, instead=(*kept, (base.world.state, (world.state,))))


def _elsewhere(query: Query, there: Elsewhere) -> Query:
    """The query in another module, with other constants, and with other operators in the place of some."""
    instead = dict(query.instead) | {name: tuple(others) for name, others in there.instead.items()}
    return replace(
        query,
        module=there.module or query.module,
        constants=there.constants or query.constants,
        instead=tuple(instead.items()),
    )


def _of_family(query: Query, family: OtherFamily, file: ProofsFile) -> Query:
    letters = ", ".join(some for some in (family.letters, query.alone) if some)
    named = replace(query, name=f"{family.name}-{query.name}", shown=tuple(file.letters.shown), alone=letters)
    return _elsewhere(named, family)


def _lemma(anywhere: Query, lemma: Lemma) -> Query:
    of_itself = tuple((name, others) for name, others in anywhere.instead if name != lemma.of)
    asked = replace(anywhere, name=lemma.name, kind="lemma", init=lemma.init, instead=of_itself)
    return _elsewhere(replace(asked, formulas=(lemma.formula,)), lemma)


def _refines(anywhere: Query, refinement: Refinement) -> Query:
    """What the queries of a refinement have in common."""
    return replace(
        anywhere,
        kind="refines",
        module=refinement.module,
        world="",
        constants=refinement.constants,
        init=refinement.any,
        next=TOGETHER,
        history=refinement.history,
    )


def _claim(claim: Claim, timeout: int) -> Query:
    return Query(
        name=claim.name,
        kind="claim",
        module=claim.module,
        init=claim.init,
        next=NEXT_OF_CLAIMS,
        length=claim.length,
        formulas=(claim.formula,),
        timeout=timeout,
    )
