"""Chromium, where it is installed, and the checker's page in it."""

from __future__ import annotations

import base64
import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any
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


@contextmanager
def page_engine() -> Iterator[Callable[[bytes], Answer]]:
    """The engine in the checker's page, for one log after another. Raises EngineError if it cannot be started."""
    if lack := missing():
        raise EngineError(lack)
    with sync_playwright() as playwright, playwright.chromium.launch(executable_path=chromium(), args=QUIET) as browser:
        page = browser.new_page()
        page.set_default_timeout(_PATIENCE_MS)
        page.goto(PAGE.as_uri())
        page.wait_for_selector("body[data-ready]")
        yield partial(judged_in, page)


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
