"""The numbers of the documentation: what runs of the checks came to, kept as small reports, and one page of them."""
