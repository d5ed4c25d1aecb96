"""The parts of a property: its definition, and the definitions that it uses in modules with properties."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from evidence.views.traceability.modules import Definition, Module
from evidence.views.traceability.roles import extended, statements


class Properties:
    """The definitions of modules with properties and of models, as each module sees them."""

    def __init__(self, spec: Sequence[Module], models: Sequence[Module]) -> None:
        everything = [*spec, *models]
        self._models = {module.name: module for module in models}
        telling = {module.name for module in [*statements(spec), *models]}
        self._seen = {
            module.name: {
                d.name: d
                for other in everything
                if other.name in telling & extended({module.name}, everything)
                for d in other.definitions
            }
            for module in everything
        }

    def parts(self, model: str, name: str, *, instances: bool) -> tuple[Definition, ...]:
        """The definitions that a property of a model consists of, with or without definitions of instances.

        The box of a model says the purpose of the properties that the model itself defines.
        """
        found: dict[tuple[str, str], Definition] = {}
        todo = [self._find(model, name)]
        while todo:
            part = todo.pop()
            if part is None or (part.module, part.name) in found:
                continue
            own = part.name == name and part.module in self._models
            box = self._models[part.module].tags if own else ()
            found[part.module, part.name] = replace(part, tags=tuple(dict.fromkeys((*part.tags, *box))))
            todo += [self._find(part.module, word) for word in sorted(part.words) if instances or "!" not in word]
        return tuple(found.values())

    def _find(self, module: str, word: str) -> Definition | None:
        name, _, inner = word.partition("!")
        seen = self._seen.get(module, {}).get(name)
        return self._find(seen.instance_of, inner) if seen and inner else seen
