"""Tools that give evidence about the specification: they import ``s7check``, which never imports them."""
