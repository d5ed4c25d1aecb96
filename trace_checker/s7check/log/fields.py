"""JSON objects read by tables of their fields."""

from collections.abc import Callable, Mapping

from s7check.log.errors import UnusableLogError, quote

Reader = Callable[[object], object]
"""Turns a decoded JSON value into the normalised one, or raises UnusableLogError."""

OWN = "x_"
"""How the names of an implementer's own fields begin."""


class Fields:
    """The fields of one kind of object.

    Messages call the object ``what`` and its fields ``names``, by default by their list.
    """

    def __init__(
        self, what: str, required: Mapping[str, Reader], optional: Mapping[str, Reader], names: str = ""
    ) -> None:
        self._what = what
        self._readers = {**required, **optional}
        self._required = tuple(required)
        self._names = names or f"a field of {what} ({', '.join(self._readers)})"

    def read(self, raw: dict[str, object]) -> dict[str, object]:
        """The normalised fields of ``raw``, without the implementer's own.

        Raises UnusableLogError, with the field, for the first unknown, wrong or missing one.
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
                    raise UnusableLogError(f'{self._names} or a name that begins with "{OWN}"', "an unknown field")
        except UnusableLogError as error:
            error.inside(name)
            raise
        for name in self._required:
            if name not in fields:
                raise UnusableLogError(f"in every {self._what}", "none", field=name)
        return fields

    def nested(self, value: object) -> dict[str, object]:
        """The normalised fields of ``value``, which must be an object."""
        if isinstance(value, dict):
            return self.read(value)
        raise UnusableLogError("an object", quote(value))


def mapping(names: str, readers: Mapping[str, Reader]) -> Callable[[object], dict[str, object]]:
    """A reader of objects with the keys of ``readers``, none required; messages call them ``names``."""
    return Fields("map", {}, readers, names).nested


def list_of(reader: Reader) -> Callable[[object], list[object]]:
    """A reader of lists whose elements ``reader`` reads and which differ."""

    def read(value: object) -> list[object]:
        if not isinstance(value, list):
            raise UnusableLogError("a list", quote(value))
        elements: list[object] = []
        for element in value:
            normalised = reader(element)
            if normalised in elements:
                raise UnusableLogError("a list without repetitions", f"{quote(element)} twice")
            elements.append(normalised)
        return elements

    return read
