"""Chromium, where it is installed, and the checker's page in it."""

from __future__ import annotations

import base64
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import TracebackType
from typing import Any, Self
from unittest.mock import patch

import msgspec
from playwright.sync_api import Browser, Page, sync_playwright

from evidence.common.checkout import ROOT
from s7check.engine.answer import Answer
from s7check.engine.command import EngineError
from s7check.log.profile_file import HERE, header_line, profile_file
from s7check.resources import PAGE

_NAMES = ("chromium", "chromium-browser", "google-chrome")
QUIET = ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update"]
_PATIENCE_MS = 120_000


def chromium() -> str | None:
    """Its program."""
    return next(filter(None, map(shutil.which, _NAMES)), None)


def firefox() -> str | None:
    """Its program."""
    return shutil.which("firefox-esr") or shutil.which("firefox")


@contextmanager
def in_firefox() -> Iterator[Browser]:
    """Firefox as it is installed, by WebDriver BiDi; pages have its own colour scheme and medium."""
    hook = f"--require {Path(__file__).with_name('without_media.cjs')}"
    with patch.dict(os.environ, NODE_OPTIONS=hook), sync_playwright() as playwright:
        yield playwright.firefox.launch(channel="moz-firefox", executable_path=firefox())


def missing() -> str:
    """What the page lacks to be run; empty if nothing."""
    if chromium() is None:
        return "no Chromium"
    return "" if PAGE.is_file() else f"no {PAGE.relative_to(ROOT)}: run `make page`"


class PageEngine:
    """The engine in the checker's page, for one log after another. Raises EngineError if it cannot be started."""

    def __enter__(self) -> Self:
        if lack := missing():
            raise EngineError(lack)
        self._playwright = sync_playwright().start()
        self._browser: Browser = self._playwright.chromium.launch(executable_path=chromium(), args=QUIET)
        self._page = self._browser.new_page()
        self._page.set_default_timeout(_PATIENCE_MS)
        self._page.goto(PAGE.as_uri())
        self._page.wait_for_selector("body[data-ready]")
        return self

    def __exit__(self, _: type[BaseException] | None, __: BaseException | None, ___: TracebackType | None) -> None:
        self._browser.close()
        self._playwright.stop()

    def judge(self, log: bytes) -> Answer:
        """The answer to a log, with the situation after its last line."""
        return judged_in(self._page, log)


def judged_in(page: Page, log: bytes) -> Answer:
    """The answer of the engine in an open page to a log, with the situation after its last line."""
    begin: dict[str, Any] = {"follow": 1}
    if file := profile_file(header_line(log) or log, HERE):
        begin["file"] = file
    answer = page.evaluate(
        "([log, begin]) => s7check(log, begin).catch((error) => ({verdict: 'error', message: error.message}))",
        [base64.b64encode(log).decode(), begin],
    )
    return msgspec.convert(answer, Answer)
