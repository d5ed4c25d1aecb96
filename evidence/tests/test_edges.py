"""The explorer's steps and the edges of a graph that TLC exports."""

import pytest

from evidence.common.processes import Processes
from evidence.logs.explored import Comparison
from evidence.logs.graph import WORLDS, Graph, exported
from evidence.tla.tlc import Toolchain
from s7check.engine.client import Engine


@pytest.fixture(scope="module")
def graph(tools: Toolchain) -> Graph:
    """The graph of the smallest world."""
    return exported(WORLDS["hold"], tools, Processes(), 300)


def test_every_edge_is_offered_and_no_other(engine: Engine, graph: Graph) -> None:
    """But for lines before a start that is due, which a log may have."""
    found = Comparison(engine, graph).run()
    assert (found.missing, found.more) == ([], [])
    assert len(found.edges) == graph.edges > 200
    assert found.logs > 90
    assert found.early < found.logs


def test_edges_that_are_not_there_are_told(engine: Engine, graph: Graph) -> None:
    """The first state has another edge than its own two."""
    (begin,) = graph.headers
    own = graph.shown[begin]
    graph.shown[begin] = {(b'{"event":"hold"}', begin)}
    found = Comparison(engine, graph).run()
    graph.shown[begin] = own
    assert [log.rpartition(" ")[2] for log in found.missing] == ['{"event":"hold"}']
    assert len(found.more) == len(own)
    assert found.logs == 1
