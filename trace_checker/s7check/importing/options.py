"""Types of the command line's options."""

import re
from pathlib import Path
from typing import Any

import click

from s7check.log.errors import UnusableLogError
from s7check.log.objects import decoded

_FAMILIES = ("S7-300", "S7-400", "CPU 318")
_NAME = re.compile(r"(?:(?:SIMATIC|CPU|6ES7)[ -]*)*(3|4)(\d)(\d)(?!\d).*", re.IGNORECASE)
"""A CPU's name or order number: CPU 315-2DP, 416-3 PN/DP, 6ES7 315-2AG10-0AB0."""


class Cpu(click.ParamType[str]):
    """A family of CPUs, by its name or by that of one of its CPUs."""

    name = "cpu"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """The family."""
        text = " ".join(value.split())
        for family in _FAMILIES:
            if text.upper() == family:
                return family
        found = _NAME.fullmatch(text)
        if found is None or found[2] != "1":
            self.fail(f"expected S7-300, S7-400, CPU 318, or a CPU such as 315-2DP; found {value!r}", param, ctx)
        if found[1] + found[2] + found[3] == "318":
            return "CPU 318"
        return f"S7-{found[1]}00"


class Obs(click.ParamType[list[int]]):
    """Numbers of OBs with commas between them, with or without ``OB``."""

    name = "obs"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> list[int]:
        """The list."""
        found = [re.fullmatch(r"\s*(?:OB)?\s*([0-9]{1,9})\s*", part, re.IGNORECASE) for part in value.split(",")]
        if not all(found):
            self.fail(f"expected OBs such as 1,10,80 or OB1,OB10,OB80; found {value!r}", param, ctx)
        return [int(number[1]) for number in found if number]


class Words(click.ParamType[list[str]]):
    """Words with commas between them; an empty text is an empty list."""

    name = "words"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> list[str]:
        """The list."""
        return value.split(",") if value else []


class JsonFile(click.Path):
    """A file that holds a JSON object, which is the value."""

    name = "file"

    def __init__(self) -> None:
        super().__init__(exists=True, dir_okay=False)

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The object."""
        super().convert(value, param, ctx)
        try:
            return decoded(Path(value).read_bytes())
        except (UnusableLogError, OSError) as error:
            self.fail(f"{value}: {error}", param, ctx)
