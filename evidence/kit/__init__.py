"""Makes the programs of the conformance kit."""
