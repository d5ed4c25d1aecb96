"""The tables of the format say what the specification says."""

from s7check.engine.client import Engine
from s7check.log import tables
from s7check.log.header import CPUS, PROFILES
from s7check.report.clauses import clause


def test_readings(real_engine: Engine) -> None:
    """A header may name the letters of the requirements; those that the specification tells apart are among them."""
    alternatives = real_engine.alternatives()
    assert {name: "".join(sorted(letters)) for name, letters in alternatives.choices} == tables.READINGS
    assert {name: "".join(sorted(clause(name).letters)) for name in tables.READINGS} == tables.READINGS
    known = {(name, letter) for name, letters in tables.READINGS.items() for letter in letters}
    told_apart = {(name, letter) for name, letters in alternatives.letters for letter in letters}
    assert told_apart <= known
    assert set(alternatives.defaults) <= told_apart


def test_profiles(real_engine: Engine) -> None:
    """The profiles of a header are those of the specification."""
    assert sorted(real_engine.alternatives().profiles) == sorted(PROFILES)


def test_families(real_engine: Engine) -> None:
    """A header can name the families that have a record in the specification."""
    assert set(real_engine.alternatives().families) == set(CPUS)
    assert set(real_engine.alternatives().settable) == tables.PRIORITY_CPUS


def test_classes(real_engine: Engine) -> None:
    """A header can give an OB the classes of the specification."""
    classes = {ob: sorted(classes) for ob, classes in real_engine.alternatives().classes}
    assert classes == {ob: [*classes] for ob, classes in tables.SETTABLE_PRIORITIES.items()}


def test_obs(real_engine: Engine) -> None:
    """The kinds of OB are those of the specification."""
    alternatives = real_engine.alternatives()
    assert set(alternatives.obs) == {*tables.OB_NUMBERS}
    assert set(alternatives.tod_obs) == {*tables.TIME_OF_DAY_OBS}
    assert set(alternatives.dint_obs) == {*tables.TIME_DELAY_OBS}
    assert set(alternatives.external) == tables.EXTERNAL_OBS
    assert set(alternatives.faulty) == tables.OBS_WITH_FAULT
