"""What kind of source some bytes are, told by their beginning."""

from s7check.importing.errors import SourceError
from s7check.importing.sources import hex_text, ring_layout, step7_text, szl


def kind_of(begin: bytes) -> str | None:
    """``step7``, ``szl`` or ``ring``, as ``--from`` has it, if ``begin`` is the beginning of such a source."""
    if step7_text.has_entry(begin):
        return "step7"
    try:
        raw = hex_text.decode(begin)
    except SourceError:
        return None
    return "ring" if ring_layout.begins(raw) else "szl" if szl.has_record(raw) else None
