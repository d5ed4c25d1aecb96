"""The events that the specification allows, in the words of the log format."""

from s7check.engine.answer import Allowed, Situation
from s7check.log.values import MS_PER_MINUTE, NOT_LOGGED, iso

_WORDS = frozenset({"ret", "status", "period", "sign", "cause", "error_info", "ev", "id"})
_BYTES = frozenset({"flt_id", "strt_info"})
_TRUTHS = frozenset({"active", "blocked", "loaded", "entries_off", "local", "activate"})


def format_allowed(allowed: Allowed) -> str:
    """Such as ``EN_AIRT ret=16#0000``, ``start ob=80 flt_id=16#05`` or ``end ob=10``; a value that the
    specification leaves open is left out.
    """
    parts = [allowed.event]
    if allowed.ob:
        parts.append(f"ob={allowed.ob}")
    if value := format_value(allowed):
        parts.append(f"{allowed.field}={value}")
    return " ".join(parts)


def format_late(allowed: Allowed, situations: list[Situation]) -> str:
    """The events that had to come before the line, such as ``start ob=40, within 10 ms of 2026-03-02T08:00:31.000``.

    The moment is that of a start event that could have started its OB; of a STOP or an entry none is told.
    """
    since = next(
        (
            f" of {iso(state.clock.min * MS_PER_MINUTE + state.clock.ms - waited)}"
            for state in situations
            for request in state.pending
            for number, waited in state.waited
            if request.ob == allowed.ob and request.ready and request.class_ == number
        ),
        "",
    )
    return f"{format_allowed(allowed)}, within {situations[0].latency} ms{since}"


def format_value(allowed: Allowed) -> str:
    """The value that the field must have; empty if there is no field, or its value is open."""
    field, value = allowed.field, allowed.value
    if field == "time":
        return iso(allowed.time.min * MS_PER_MINUTE + allowed.time.ms)
    return "" if not field or value == NOT_LOGGED else spelled_value(field, value)


def spelled_value(field: str, value: int) -> str:
    """Words and bytes in hexadecimal."""
    if field in _WORDS:
        return f"16#{value & 0xFFFF:04X}"
    if field in _BYTES:
        return f"16#{value & 0xFF:02X}"
    return str(bool(value)).lower() if field in _TRUTHS else str(value)
