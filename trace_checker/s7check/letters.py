"""Options with words of a log: families, editions, readings of ambiguities. An engine tells which ones there are."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import click
import msgspec

from s7check.engine import pool
from s7check.log.chosen import Chosen
from s7check.log.errors import printable
from s7check.log.profile_file import ENDING

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem


class OneOf(click.ParamType[str]):
    """One of the ``families`` or ``profiles``."""

    name = "word"

    def __init__(self, field: Literal["families", "profiles"]) -> None:
        self._field = field

    def _choice(self) -> click.Choice[str]:
        return click.Choice(getattr(pool.alternatives(), self._field))

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """The word."""
        return self._choice().convert(value, param, ctx)

    def shell_complete(self, ctx: click.Context, param: click.Parameter, incomplete: str) -> "list[CompletionItem]":
        """The words that begin like this."""
        return self._choice().shell_complete(ctx, param, incomplete)


EDITION = OneOf("profiles")


class Letters(click.ParamType[dict[str, str]]):
    """Ambiguities and the letters of their readings, ``AMB-02=a,AMB-17=b``, or ``@FILE`` with a JSON object of them."""

    name = "letters"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> dict[str, str]:
        """The mapping."""
        pairs = [pair.partition("=") for pair in self._written(value, param, ctx).split(",")]
        readings = pool.alternatives().readings
        for ambiguity, _, letter in pairs:
            letters = readings.get(ambiguity)
            if letters is None:
                self.fail(f"expected readings such as AMB-02=a,AMB-17=b; found {printable(value)!r}", param, ctx)
            if letter not in letters:
                self.fail(f"{ambiguity}: expected {' or '.join(letters)}; found {printable(letter)!r}", param, ctx)
        return {ambiguity: letter for ambiguity, _, letter in pairs}

    def _written(self, value: str, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """The letters as text, also those of a file."""
        if not value.startswith("@"):
            return value
        try:
            letters = msgspec.json.decode(Path(value[1:]).read_bytes(), type=dict[str, str])
        except (OSError, ValueError, msgspec.MsgspecError) as error:
            self.fail(f"{printable(value[1:])}: expected a JSON object such as {_EXAMPLE}; {error}", param, ctx)
        if not letters:
            self.fail(f"{printable(value[1:])}: expected at least one reading; found none", param, ctx)
        return ",".join(f"{name}={letter}" for name, letter in letters.items())


_EXAMPLE = '{"AMB-02": "a"}'


class Profile(click.ParamType[Chosen]):
    """An edition of the manual, or a file ``NAME.json`` with the letters of a CPU, as ``s7check decide`` writes it."""

    name = "profile"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Chosen:
        """The edition, or no edition and the letters."""
        if not str(value).endswith(ENDING):
            return Chosen(EDITION.convert(value, param, ctx))
        return Chosen("", Letters().convert(f"@{value}", param, ctx))


def set_option(explanation: str) -> Callable[[click.decorators.FC], click.decorators.FC]:
    """The option, which may be given several times; its value is one mapping, ``letters``."""
    return click.option(
        "--set",
        "letters",
        type=Letters(),
        multiple=True,
        callback=lambda _, __, mappings: {name: letter for one in mappings for name, letter in one.items()},
        metavar="AMB-NN=LETTER,...",
        help=explanation,
    )
