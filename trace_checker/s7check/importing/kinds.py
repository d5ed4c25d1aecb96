"""What kind of source some bytes are, told by their beginning."""

from s7check.importing.errors import SourceError
from s7check.importing.sources import hex_text, step7_text, szl


def kind_of(begin: bytes) -> str | None:
    """``step7`` or ``szl``, as ``--from`` has it, if ``begin`` is the beginning of such a source."""
    if step7_text.has_entry(begin):
        return "step7"
    try:
        return "szl" if szl.has_record(hex_text.decode(begin)) else None
    except SourceError:
        return None
