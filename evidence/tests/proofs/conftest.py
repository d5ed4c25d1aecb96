"""The queries of the checkout, for all tests of the proofs."""

import pytest

from evidence.common.checkout import ROOT
from evidence.models.proofs.queries import Proofs, load


@pytest.fixture(scope="module")
def proofs() -> Proofs:
    """The queries of the checkout."""
    return load(ROOT)
