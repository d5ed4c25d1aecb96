"""A query of the proofs, and the making of all queries that the manifest speaks of.

The induction has for each action of System a query: from any state in which the invariant holds, the invariant holds
after the action, and the step is as every property of steps says. Refinements, letters and controls ask of the same
actions, each from states and in a text of its own.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from fnmatch import fnmatchcase
from functools import cached_property
from typing import Literal

from evidence.models.entries import Mutation
from evidence.models.proofs.manifest import (
    Apart,
    Claim,
    Elsewhere,
    Induction,
    Lemma,
    NotProved,
    OtherFamily,
    ProofsFile,
    Refinement,
    World,
)

FOLLOWS = "invariants"
"""The query about the properties of states."""

TOGETHER = "Together"
"""The disjunction of the actions of a query, with its history."""

NEXT_OF_CLAIMS = "APNext"
"""The next-state relation of the abstract specifications in models/."""

Kind = Literal[
    "begins", "step", "follows", "lemma", "refines", "letters", "letter", "family", "control", "mutant", "claim"
]


@dataclass(frozen=True)
class Mutant:
    """A negative control of models/controls.txt: with its mutations the formula no longer holds.

    `of` is the action, or the query about an abstract specification, of which it held.
    """

    control: str
    of: str
    formula: str
    mutations: tuple[Mutation, ...]


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
class Making:
    """Makes the queries of the manifest `file` about these actions, and these properties of `steps` and of `states`."""

    file: ProofsFile
    actions: tuple[str, ...]
    steps: tuple[str, ...]
    states: tuple[str, ...]
    mutants: tuple[Mutant, ...]
    claim_mutants: tuple[Mutant, ...]

    def queries(self) -> tuple[Query, ...]:
        """All of them, in their order."""
        return (
            self._first,
            self._anywhere,
            *map(self._lemma, self._base.lemmas),
            *self._of_actions,
            *(query for _, query in self._aparts),
            *(query for word, refinement in self.file.refinements.items() for query in self._refines(word, refinement)),
            *self._of_every_letter(),
            *(self._of_one_letter(cell) for cell in self.file.not_proved if cell.letter),
            *self._controls,
            *(query for family in self._base.families for query in self._of_family(family)),
            *map(self._mutant, self.mutants),
            *map(self._claim_mutant, self.claim_mutants),
            *map(self._claim, self.file.claims),
        )

    @property
    def _base(self) -> Induction:
        return self.file.induction

    @cached_property
    def _anywhere(self) -> Query:
        """From any state in which `Ind` holds: all properties of states. Others are made of it."""
        return Query(
            name=FOLLOWS,
            kind="follows",
            module=self._base.module,
            init=self._base.any,
            next=self.actions[0],
            length=0,
            formulas=self._claimed(self.states, [FOLLOWS]),
            timeout=self._base.timeout,
            world=self._base.module,
            constants=self._base.constants,
            instead=tuple((name, tuple(others)) for name, others in self._base.instead.items()),
        )

    @property
    def _first(self) -> Query:
        begins = replace(self._anywhere, name="first", kind="begins", init=self._base.first)
        return replace(begins, formulas=tuple(self._base.invariants))

    def _lemma(self, lemma: Lemma) -> Query:
        of_itself = tuple((name, others) for name, others in self._anywhere.instead if name != lemma.of)
        asked = replace(self._anywhere, name=lemma.name, kind="lemma", init=lemma.init, instead=of_itself)
        return _elsewhere(replace(asked, formulas=(lemma.formula,)), lemma)

    def _claimed(self, formulas: Iterable[str], actions: Iterable[str]) -> tuple[str, ...]:
        """Those that are claimed of each of the actions, and asked in the world of the others."""
        left = {(cell.action, cell.formula) for cell in self.file.not_proved if not cell.letter}
        return tuple(
            formula
            for formula in formulas
            if not any((action, formula) in left or self._base.apart_of(action, formula) for action in actions)
        )

    @property
    def _whole(self) -> tuple[str, ...]:
        return (*self._base.invariants, *self.steps)

    @property
    def _groups(self) -> dict[str, list[str]]:
        """The actions of each query of steps, by its name."""
        joined = {action for some in self._base.together.values() for action in some}
        return {**{action: [action] for action in self.actions if action not in joined}, **self._base.together}

    def _step(self, name: str, kind: Kind, actions: list[str], formulas: tuple[str, ...]) -> Query:
        following = actions[0] if len(actions) == 1 else TOGETHER
        asked = replace(self._anywhere, name=name, kind=kind, next=following, actions=tuple(actions), length=1)
        return replace(asked, formulas=formulas, unfiltered=name in self._base.unfiltered)

    def _divided(self, query: Query) -> Query:
        found = (at for glob, at in self._base.divided.items() if fnmatchcase(query.name, glob))
        return replace(query, divided=tuple(next(found, ())))

    @cached_property
    def _of_actions(self) -> list[Query]:
        return [
            self._divided(self._step(name, "step", actions, self._claimed(self._whole, actions)))
            for name, actions in self._groups.items()
        ]

    @property
    def _aparts(self) -> list[tuple[Apart, Query]]:
        return [
            (apart, _elsewhere(self._step(apart.name, "step", apart.actions, tuple(apart.formulas)), apart))
            for apart in self._base.apart
        ]

    def _refined(self, refinement: Refinement) -> Query:
        """What the queries of a refinement have in common."""
        return replace(
            begun_in(self._base, self._base.smaller, self._anywhere),
            kind="refines",
            module=refinement.module,
            world="",
            constants=refinement.constants,
            init=refinement.any,
            next=TOGETHER,
            history=refinement.history,
        )

    def _refines(self, word: str, refinement: Refinement) -> list[Query]:
        asked = self._refined(refinement)
        first = replace(asked, name=f"{word}-first", init=refinement.first, actions=self.actions[:1])

        def after(query: Query) -> Query:
            unfiltered = any(fnmatchcase(query.name, glob) for glob in refinement.unfiltered)
            step = replace(asked, name=f"{word}-{query.name}", actions=query.actions, length=1, unfiltered=unfiltered)
            return self._divided(replace(step, formulas=self._claimed(refinement.steps, query.actions)))

        return [replace(first, formulas=tuple(refinement.begins)), *map(after, self._of_actions)]

    def _of_every_letter(self) -> list[Query]:
        groups = self.file.letters.together.items()
        asked = [self._step(name, "step", some, self._claimed(self._whole, some)) for name, some in groups]
        return [
            self._of_letters(query) for query in (*asked, *(query for apart, query in self._aparts if apart.letters))
        ]

    def _of_letters(self, query: Query) -> Query:
        cells = [cell for cell in self.file.not_proved if cell.letter and cell.action in query.actions]
        unless = {
            cell.formula: tuple(sorted({other.letter for other in cells if other.formula == cell.formula}))
            for cell in cells
        }
        query = replace(query, name=f"letters-{query.name}", kind="letters", unfiltered=True, shown=self._shown)
        query = begun_in(self._base, self._base.smaller, query)
        return self._divided(replace(query, unless=tuple(unless.items())))

    @property
    def _shown(self) -> tuple[str, ...]:
        return tuple(self.file.letters.shown)

    def _refuted(self, name: str, kind: Kind, action: str, formula: str, asked: Query) -> Query:
        """A query for a counterexample to one formula, by one action."""
        following = TOGETHER if asked.history else action
        asked = replace(asked, name=name, kind=kind, next=following, actions=(action,), length=1, formulas=(formula,))
        return begun_in(self._base, self._base.refuted, replace(asked, expect="violated"))

    def _in_its_world(self, query: Query, action: str, formula: str) -> Query:
        apart = self._base.apart_of(action, formula)
        return _elsewhere(query, apart) if apart else query

    def _of_one_letter(self, cell: NotProved) -> Query:
        name = f"letter-{cell.action}-{cell.formula}-{cell.letter.replace(', ', '-').replace(' ', '-')}"
        there = self._in_its_world(self._anywhere, cell.action, cell.formula)
        asked = self._refuted(name, "letter", cell.action, cell.formula, there)
        return replace(asked, shown=self._shown, alone=cell.letter, unfiltered=True)

    @cached_property
    def _controls(self) -> list[Query]:
        return list(map(self._control, self.actions))

    def _control(self, action: str) -> Query:
        query = self._refuted(f"control-{action}", "control", action, self._base.control, self._anywhere)
        letter = self._base.able.get(action)
        return query if letter is None else replace(query, alone=letter, shown=self._shown)

    def _of_family(self, family: OtherFamily) -> list[Query]:
        groups = self._groups | {action: [action] for action in family.only}
        steps = [self._step(name, "family", some, tuple(family.formulas)) for name, some in groups.items()]
        steps = [begun_in(self._base, self._base.smaller, query) for query in steps]

        def of_it(query: Query) -> Query:
            letters = ", ".join(some for some in (family.letters, query.alone) if some)
            named = replace(query, name=f"{family.name}-{query.name}", shown=self._shown, alone=letters)
            return _elsewhere(named, family)

        return [*map(of_it, (self._first, *steps, *self._controls, *map(self._control, family.only)))]

    def _mutant(self, mutant: Mutant) -> Query:
        refinements = self.file.refinements.values()
        of = next((self._refined(some) for some in refinements if mutant.formula in some.steps), self._anywhere)
        there = self._in_its_world(of, mutant.of, mutant.formula)
        asked = self._refuted(_name(mutant), "mutant", mutant.of, mutant.formula, there)
        return replace(asked, mutations=mutant.mutations)

    def _claim_mutant(self, mutant: Mutant) -> Query:
        claim = next(self._claim(claim) for claim in self.file.claims if claim.name == mutant.of)
        asked = replace(claim, name=_name(mutant), kind="mutant", formulas=(mutant.formula,), expect="violated")
        return replace(asked, mutations=mutant.mutations)

    def _claim(self, claim: Claim) -> Query:
        return Query(
            name=claim.name,
            kind="claim",
            module=claim.module,
            init=claim.init,
            next=NEXT_OF_CLAIMS,
            length=claim.length,
            formulas=(claim.formula,),
            timeout=self._base.timeout,
        )


def _name(mutant: Mutant) -> str:
    return f"mutant-{mutant.control.removeprefix('neg-')}"


def begun_in(base: Induction, world: World, query: Query) -> Query:
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
