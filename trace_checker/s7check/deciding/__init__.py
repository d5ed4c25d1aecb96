"""Which readings of the open questions logs leave."""
