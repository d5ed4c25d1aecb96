"""``make site``: the docs, the specification and the gallery as a folder of static pages that need no network."""
