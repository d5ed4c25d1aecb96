"""``s7check verify``: the project's main job."""
