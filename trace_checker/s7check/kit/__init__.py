"""The conformance kit: programs for a CPU, run through an adapter and judged by the specification."""
