"""The answer of ``s7check next`` as JSON."""

from typing import Any

import msgspec

from s7check.asking.answers import Line
from s7check.asking.line_text import iso_of
from s7check.asking.next_answer import NextAnswer


def to_json(answer: NextAnswer) -> str:
    """One object on one line; the fields as in docs/checking/asking.md."""
    times = [iso_of(time.at) for time in answer.possible.times]
    return msgspec.json.encode(
        {
            "log": answer.place,
            "message": answer.message,
            "situations": [state.said for state in answer.situations],
            "due": [
                {
                    "by": iso_of(time.at),
                    "events": [allowed.text for allowed in time.due],
                    "requirements": time.requirements,
                }
                for time in answer.possible.times
                if time.due
            ],
            "questions": [{"name": one.name, "explanations": one.explanations} for one in answer.questions],
            "endless": answer.possible.endless,
            "whole": answer.possible.whole,
            "possible": [_line(line, times) for line in answer.possible.lines],
            "columns": answer.columns,
            "differences": [
                {"example": one.example, "others": one.others, "cells": one.cells} for one in answer.differences
            ],
            "broken": answer.broken,
        }
    ).decode()


def _line(line: Line, times: list[str]) -> dict[str, Any]:
    return {
        "event": line.event,
        "from": times[line.first],
        "until": None if line.last is None else times[line.last],
        "requirements": line.requirements,
    }
