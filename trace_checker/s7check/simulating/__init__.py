"""The specification as an implementation: it runs programs of the kit."""
