"""A certificate of turning points to 20 digits: its size, the time to make it, and that of the page that checks it."""

from functools import partial

from asymptotics.certificates.of_results import of_turning_points
from asymptotics.law import Law
from asymptotics.testing.check_certificate import check
from asymptotics.turning.choose import turning_points
from benchmarks.table import Table, best_time, seconds_text

LAWS = (
    Law({2: "1/10"}),
    Law({"3/2": "1/5"}),
    Law({1: "1/20", 2: "1/10"}),
    Law({0: "1/50", 2: "1/10"}),
)
GOAL = 2.0
"""Seconds for the page, for 20 half-swings of each of the laws."""


def run(size: int = 20, digits: int = 20) -> Table:
    """A row for each law: ``size`` half-swings, or as many as there are, with times."""
    rows = []
    for law in LAWS:
        table = turning_points(law, size + 1, digits, times=True)
        made = of_turning_points(law, table)
        making = best_time(partial(of_turning_points, law, table), 1)
        checking = best_time(partial(check, made.content[0]))
        share = f"{checking / GOAL:.2g}"
        kilobytes = f"{len(made.to_json()) / 1000:.0f}"
        row = (str(law), str(len(table.points) - 1), kilobytes, seconds_text(making), seconds_text(checking), share)
        rows.append(row)
    columns = ("law", "half-swings", "kB", "made in", "checked in", "share of 2 s")
    return Table(f"Certificates to {digits} digits", columns, tuple(rows))
