"""IDs for places of a module.

An id is made of the module, the definition, the kind of place, and a hash of the code there and of the few words before
it: lines may move, and other definitions change, without a new id.
"""

from __future__ import annotations

import hashlib
from collections import Counter

from tree_sitter import Node

from evidence.tla.syntax import COMMENTS, code, leaves, token

CONTEXT = 3
"""How many words tell equal changes of one definition apart."""


class Names:
    """Gives ids to places of a module that last while lines move and other definitions change."""

    def __init__(self, module: str) -> None:
        """Begin with none."""
        self._module = module
        self._given: Counter[str] = Counter()

    def give(self, definition: str, kind: str, body: Node, node: Node, *more: str) -> str:
        """Make an id of a definition, a kind, and a hash of a node of its body, of words before it, and of `more`."""
        words = "\0".join([_before(body, node), code(node), *more])
        name = f"{self._module}/{definition}/{kind}/{hashlib.sha256(words.encode()).hexdigest()[:8]}"
        self._given[name] += 1
        return f"{name}-{self._given[name]}" if self._given[name] > 1 else name


def _before(body: Node, node: Node) -> str:
    """The last words of a definition's body before a node."""
    words = [leaf for leaf in leaves(body) if leaf.type not in COMMENTS and leaf.end_byte <= node.start_byte]
    return " ".join(map(token, words[-CONTEXT:]))
