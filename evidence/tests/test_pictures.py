"""The pictures of the README are those that the program makes now."""

from evidence.views import pictures


def test_the_timeline_is_up_to_date() -> None:
    """`make pictures` would write the same."""
    assert pictures.TIMELINE.read_text(encoding="utf-8") == pictures.rejected()


def test_the_explorer_is_of_this_page() -> None:
    """The page has not changed since the picture was taken; the picture is small."""
    assert pictures.SOURCES.read_text(encoding="utf-8") == pictures.sources(), "make pictures, where there is Chromium"
    assert pictures.EXPLORER.stat().st_size < 100_000


def test_the_readme_shows_them() -> None:
    """Each picture of the folder."""
    text = pictures.README.read_text(encoding="utf-8")
    shown = [path for path in pictures.FOLDER.iterdir() if path.suffix in (".png", ".svg")]
    assert len(shown) == 2
    assert all(f"](docs/pictures/{path.name})" in text for path in shown)
