"""The explorer's server: the page, its questions, and the logs that it may open.

It listens on the loopback address alone. Every address begins with a token that only the started page knows, the
Host header has to name the loopback address, and the page may load nothing from elsewhere.
"""

import secrets
import threading
from collections.abc import Awaitable, Callable, Mapping
from importlib.resources import files
from importlib.resources.abc import Traversable
from typing import Any

import msgspec
from starlette.applications import Starlette
from starlette.middleware.trustedhost import TrustedHostMiddleware
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Mount, Route

from s7check.engine.client import Engine
from s7check.engine.command import EngineError
from s7check.exploring.desk import Call, Comparison, Desk, Object, Question, Why
from s7check.exploring.library import Library
from s7check.kit.program import read_program
from s7check.log.errors import UnusableLogError
from s7check.report.clauses import all_clauses
from s7check.report.markup import as_text
from s7check.report.timeline import legend

HOSTS = ("127.0.0.1", "localhost")
_PAGE = files(__package__) / "page"
_TYPES = {"html": "text/html", "css": "text/css", "js": "text/javascript"}
_HEADERS = {
    "Content-Security-Policy": "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; "
    "img-src 'self' data:; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "Cache-Control": "no-store",
}

Handler = Callable[[Request], Awaitable[Response]]


def new_token() -> str:
    """A token that nobody guesses."""
    return secrets.token_urlsafe(16)


def application(engine: Engine, library: Library, token: str) -> Starlette:
    """The explorer as an ASGI application; everything lies under ``/<token>/``."""
    desk = Desk(engine)
    one_at_a_time = threading.Lock()

    def opened(name: str) -> Object:
        program = library.program(name)
        return library.open(name) if program is None else desk.run(program)

    def question(shape: type[Any], answer: Callable[[Any], Any]) -> Callable[[Request], Awaitable[Response]]:
        async def handle(request: Request) -> Response:
            body = await request.body()
            return await _in_thread(lambda: _answered(body, shape, answer, one_at_a_time))

        return handle

    routes = [
        Route("/", _static(_PAGE / "index.html")),
        *(Route(f"/{name}", _static(_PAGE / name)) for name in ("explorer.css", "explorer.js", "model.js")),
        Route("/report.css", _static(files("s7check.report") / "report.css")),
        Route("/look", question(Question, desk.look), methods=["POST"]),
        Route("/questions", question(Question, desk.questions), methods=["POST"]),
        Route("/timeline", question(Question, desk.timeline), methods=["POST"]),
        Route("/call", question(Call, desk.call), methods=["POST"]),
        Route("/answers", question(Why, desk.answers), methods=["POST"]),
        Route("/compare", question(Comparison, desk.compare), methods=["POST"]),
        Route("/why", question(Why, desk.why), methods=["POST"]),
        Route("/program", question(Question, desk.program), methods=["POST"]),
        Route("/run", question(Object, lambda raw: desk.run(read_program(msgspec.json.encode(raw)))), methods=["POST"]),
        Route("/open", question(str, opened), methods=["POST"]),
        Route("/start", _json({"clauses": all_clauses(), "legend": as_text(legend()), **library.contents()})),
    ]
    app = Starlette(routes=[Mount(f"/{token}", routes=routes)])
    app.add_middleware(TrustedHostMiddleware, allowed_hosts=list(HOSTS))
    return app


def _answered(body: bytes, shape: type[Any], answer: Callable[[Any], Any], lock: threading.Lock) -> Response:
    """A question that does not fit, or whose log cannot be used, is answered by a sentence and 422."""
    try:
        asked = msgspec.json.decode(body, type=shape)
        with lock:
            return _response(msgspec.json.encode(answer(asked)), "application/json")
    except (msgspec.MsgspecError, UnusableLogError, EngineError) as error:
        said = error.reason if isinstance(error, UnusableLogError) else str(error)
        return _response(said.encode(), "text/plain", status=422)


async def _in_thread(work: Callable[[], Response]) -> Response:
    from starlette.concurrency import run_in_threadpool

    return await run_in_threadpool(work)


def _static(source: Traversable) -> Handler:
    data = source.read_bytes()

    async def handle(_: Request) -> Response:
        return _response(data, _TYPES[source.name.rpartition(".")[2]])

    return handle


def _json(content: Mapping[str, Any]) -> Handler:
    data = msgspec.json.encode(content)

    async def handle(_: Request) -> Response:
        return _response(data, "application/json")

    return handle


def _response(data: bytes, media: str, status: int = 200) -> Response:
    return PlainTextResponse(data, status_code=status, headers=_HEADERS, media_type=media)
