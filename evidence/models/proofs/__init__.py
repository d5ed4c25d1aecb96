"""Proofs about the specification by Apalache: queries, the text that answers them, and the answers."""
