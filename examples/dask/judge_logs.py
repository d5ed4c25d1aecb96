"""Judges logs on a Dask cluster: `judge_logs.py [--scheduler tcp://HOST:8786] LOG... > report.json`.

A log is a unit of work without shared state, so any engine for such units will do. Each worker process keeps its
engine for its next logs. The workers need s7check, and see the logs under the same names. Without a scheduler
there is a cluster of two workers on this machine.
"""

import argparse
import sys
from contextlib import ExitStack

from dask import bag
from distributed import Client, LocalCluster

import s7check
from s7check.names import logs_of
from s7check.report.as_json import to_json


def judge(log: str) -> str:
    """The report about a log, a line of `s7check trace --format json`."""
    return to_json(s7check.check(log)).decode()


def main() -> None:
    """Judge the logs and print a line for each, in their order."""
    parser = argparse.ArgumentParser(description="Judge logs on a Dask cluster.")
    parser.add_argument("--scheduler", help="address of the scheduler; none: two workers on this machine")
    parser.add_argument("logs", nargs="+", metavar="LOG", help="a file, a folder or a pattern")
    arguments = parser.parse_args()
    with ExitStack() as stack:
        address = arguments.scheduler or stack.enter_context(
            LocalCluster(n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address=None)
        )
        stack.enter_context(Client(address))
        logs = logs_of(arguments.logs)
        for report in bag.from_sequence(logs, partition_size=20).map(judge).compute():
            sys.stdout.write(report + "\n")


if __name__ == "__main__":
    main()
