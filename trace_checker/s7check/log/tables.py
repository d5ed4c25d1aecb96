"""Numbers that the format allows: OBs, priority classes that can be set, letters of readings."""

OB_NUMBERS = range(1, 123)
"""Numbers that an OB of the CPU can have."""

TIME_OF_DAY_OBS = range(10, 18)
TIME_DELAY_OBS = range(20, 24)

EXTERNAL_OBS = frozenset({*range(30, 39), *range(40, 48), 55, 56, 57, 60, 70, 72, *range(80, 88), 121, 122})
"""OBs that an ``interrupt`` line may name."""

OBS_WITH_FAULT = frozenset({80, 85})
"""The OBs of these whose ``interrupt`` line carries a ``flt_id``."""

DESELECTED = 0
"""As a priority class: the OB is deselected [OBS-06]."""

PRIORITY_CPUS = frozenset({"S7-400", "CPU 318"})
"""CPUs whose priority classes can be set [OBS-05]."""

SETTABLE_PRIORITIES: dict[int, range] = {
    **dict.fromkeys([*range(10, 18), *range(20, 24), *range(30, 39), *range(40, 48)], range(2, 24)),
    **dict.fromkeys([70, 72], range(2, 29)),
    **dict.fromkeys([81, 82, 83, 84, 86, 87], range(2, 27)),
    85: range(24, 27),
}
"""OB -> the priority classes it can be given [OBS-05]."""

_THREE_READINGS = frozenset([
    1, 4, 5, 6, 14, 15, 19, 28, 34, 38, 39, 45, 47, 48, 49, 50, 52, 53, 54, 55, 57, 60, 61, 67, 68, 69, 70, 79, 83, 85,
    87,
])  # fmt: skip
_FOUR_READINGS = frozenset([3, 11, 13, 18, 56, 71, 77, 84, 86])

READINGS: dict[str, str] = {
    f"AMB-{n:02}": "abcd" if n in _FOUR_READINGS else "abc" if n in _THREE_READINGS else "ab" for n in range(1, 88)
}
"""Ambiguity -> the letters of its readings."""
