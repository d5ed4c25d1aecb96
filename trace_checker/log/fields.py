"""JSON objects read by tables of their fields."""

from collections.abc import Callable, Mapping

from trace_checker.log.errors import UnusableLog, quote

Reader = Callable[[object], object]
"""Turns a decoded JSON value into the normalised one, or raises UnusableLog."""

OWN = "x_"
"""How the names of an implementer's own fields begin."""


class Fields:
    """The fields of one kind of object, which ``what`` names in messages."""

    def __init__(
        self, what: str, required: Mapping[str, Reader], optional: Mapping[str, Reader] | None = None
    ) -> None:
        self._what = what
        self._readers = {**required, **(optional or {})}
        self._required = tuple(required)

    def read(self, raw: dict[str, object]) -> dict[str, object]:
        """The normalised fields of ``raw``, without the implementer's own.

        Raises UnusableLog, with the field, for the first unknown, wrong or missing one.
        """
        fields: dict[str, object] = {}
        readers = self._readers
        name = ""
        try:
            for name, value in raw.items():
                reader = readers.get(name)
                if reader is not None:
                    fields[name] = reader(value)
                elif not name.startswith(OWN):
                    raise self._unknown()
        except UnusableLog as error:
            error.inside(name)
            raise
        for name in self._required:
            if name not in fields:
                raise UnusableLog(f"one, {self._what} needs it", "none", field=name)
        return fields

    def nested(self, value: object) -> dict[str, object]:
        """The normalised fields of ``value``, which must be an object."""
        return self.read(json_object(value))

    def _unknown(self) -> UnusableLog:
        known = ", ".join(self._readers)
        return UnusableLog(
            f'a field of {self._what} ({known}) or a name that begins with "{OWN}"',
            "an unknown field",
        )


def json_object(value: object) -> dict[str, object]:
    """``value``, which must be an object."""
    if isinstance(value, dict):
        return value
    raise UnusableLog("an object", quote(value))


def mapping(what: str, readers: Mapping[str, Reader]) -> Callable[[object], dict[str, object]]:
    """A reader of objects whose keys are those of ``readers``, all optional."""
    return Fields(what, {}, readers).nested


def list_of(reader: Reader) -> Callable[[object], list[object]]:
    """A reader of lists whose elements ``reader`` reads and which differ."""

    def read(value: object) -> list[object]:
        if not isinstance(value, list):
            raise UnusableLog("a list", quote(value))
        elements: list[object] = []
        for element in value:
            normalised = reader(element)
            if normalised in elements:
                raise UnusableLog("a list without repetitions", f"{quote(element)} twice")
            elements.append(normalised)
        return elements

    return read
