"""Types of the command line's options."""

import re
from pathlib import Path
from typing import Any

import click

from s7check.log.errors import UnusableLogError
from s7check.log.jsonline import decode_object


class Numbers(click.ParamType[list[int]]):
    """Numbers with commas between them."""

    name = "numbers"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> list[int]:
        """The list."""
        if not re.fullmatch(r"[0-9]{1,9}(,[0-9]{1,9})*", value):
            self.fail(f"expected numbers such as 1,10,80; found {value!r}", param, ctx)
        return [int(number) for number in value.split(",")]


class Words(click.ParamType[list[str]]):
    """Words with commas between them; an empty text is an empty list."""

    name = "words"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> list[str]:
        """The list."""
        return value.split(",") if value else []


class Span(click.ParamType[range]):
    """Numbers of entries, ``5-20``, ``5-`` or ``-20``."""

    name = "span"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> range:
        """The numbers, the last one included."""
        match = re.fullmatch(r"([0-9]{0,9})-([0-9]{0,9})", value)
        if not match or value == "-":
            self.fail(f"expected numbers of entries such as 5-20, 5- or -20; found {value!r}", param, ctx)
        return range(int(match[1] or 0), int(match[2]) + 1 if match[2] else 1 << 31)


class JsonFile(click.Path):
    """A file that holds a JSON object, which is the value."""

    name = "file"

    def __init__(self) -> None:
        super().__init__(exists=True, dir_okay=False)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The object."""
        super().convert(value, param, ctx)
        try:
            return decode_object(Path(value).read_bytes())
        except (UnusableLogError, OSError) as error:
            self.fail(f"{value}: {error}", param, ctx)
