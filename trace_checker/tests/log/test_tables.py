"""The tables of the format say what the specification says."""

from s7check.engine.client import Engine
from s7check.log.header import PROFILES, read_header
from s7check.log.tables import READINGS
from s7check.report.clauses import clause
from tests.logs import HEADER


def test_readings(real_engine: Engine) -> None:
    """A header may name the letters of the requirements; those that the specification tells apart are among them."""
    assert {name: "".join(sorted(clause(name).letters)) for name in READINGS} == READINGS
    known = {(name, letter) for name, letters in READINGS.items() for letter in letters}
    told_apart = {(name, letter) for name, letters in real_engine.alternatives().letters for letter in letters}
    assert told_apart <= known
    assert set(real_engine.alternatives().defaults) <= told_apart


def test_profiles(real_engine: Engine) -> None:
    """The profiles of a header are those of the specification."""
    assert sorted(real_engine.alternatives().profiles) == sorted(PROFILES)


def test_cpus(real_engine: Engine) -> None:
    """The specification knows the CPUs that a header can name."""
    assert all(read_header(HEADER | {"cpu": family}) for family in real_engine.alternatives().families)
