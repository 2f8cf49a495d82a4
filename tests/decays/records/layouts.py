"""Layouts in which people store decays, each written from one known motion; ``python -m tests.decays.records.layouts``.

The motion is x'' + 9 x + 0.12 x'|x'| = 0 from x = 1 (an integrator's, of no other part of the project) with noise of
2e-4.  A layout is text, or what a writer makes of a path.  The page ``docs/layouts.md`` says what happens to each.
"""

import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime, timedelta
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

from asymptotics.decays.identification.sources import load
from asymptotics.decays.records.sources import How
from asymptotics.decays.records.table import read_table
from asymptotics.errors import InputError

PAGE = Path(__file__).parents[3] / "docs" / "layouts.md"
EPSILON, OMEGA, END = 0.12, 3.0, 24.0


def _turn(t, y):
    return y[1]


SOLVED = solve_ivp(
    lambda t, y: [y[1], -(OMEGA**2) * y[0] - EPSILON * y[1] * abs(y[1])], (0, END), [1.0, 0.0],
    method="DOP853", rtol=1e-11, atol=1e-13, max_step=0.05, dense_output=True, events=_turn,
)  # fmt: skip
RANDOM = np.random.default_rng(40)
T = np.arange(600) * 0.04
X, V = SOLVED.sol(T)
A = -(OMEGA**2) * X - EPSILON * V * np.abs(V)
N = X + 2e-4 * RANDOM.standard_normal(len(T))
TURNS = np.concatenate([[0.0], SOLVED.t_events[0][SOLVED.t_events[0] > 0.1]])
PEAKS = SOLVED.sol(TURNS)[0]
NOISE = 2e-3 * RANDOM.standard_normal(len(T))
OTHER = np.exp(-T / 25) * np.cos(4.1 * T)
LATE = np.arange(0.0, 400.0, 4.0)
LEVEL = 20 * np.log10(1 / (1 + 4 / 3 / np.pi * EPSILON * OMEGA * LATE))
HERTZ = OMEGA / 2 / np.pi


def rows(*columns, sep=",", mark=".", form="{:.5f}", before="", end=""):
    """Lines of the columns: numbers in the form, with the decimal mark; texts and whole numbers as they are."""
    text = lambda v: str(v) if isinstance(v, str | int) else form.format(v).replace(".", mark)  # noqa: E731
    return "".join(f"{before}{sep.join(map(text, row))}{end}\n" for row in zip(*columns))


@dataclass(frozen=True)
class Written:
    """``data``: the text, or a writer; ``size``: x = 1 of the motion in the file's ``unit``; ``asked``: a part of the
    refusal or question; ``how``: what is said of the file."""

    data: str | Callable[[Path], object]
    size: float = 1.0
    unit: str = ""
    asked: str = ""
    how: How = How()  # noqa: RUF009 (immutable)
    suffix: str = ".csv"
    encoding: str = "utf-8"
    stem: str = "file"

    def write(self, folder: Path) -> Path:
        """The file."""
        path = folder / f"{self.stem}{self.suffix}"
        if isinstance(self.data, str):
            path.write_bytes(self.data.encode(self.encoding))
        else:
            self.data(path)
        return path


def stamps(form, cut=None):
    """Dates or times of day that pass midnight, of the rows."""
    start = datetime(2024, 3, 1, 23, 59, 55)  # noqa: DTZ001 (as instruments write them)
    return [(start + timedelta(seconds=float(t))).strftime(form)[:cut] for t in T]


def strength(seen):
    """The strength that falls out of 1/|x_n| = 1/x_0 + (4/3) epsilon n, in which no fit of the program enters."""
    n, x = seen.n * seen.stride, np.abs(seen.x)
    return 0.75 * float(np.polyfit(n[seen.inside], 1 / x[seen.inside], 1)[0])


def happens(layout, folder):
    """What the program says of a layout: what it has read, or what it asks."""
    path = layout.write(folder)
    try:
        table = read_table(path, how=layout.how)
        # What is read is loaded by the test that asks for its strength.
        if layout.asked:
            load(path, how=layout.how)
    except InputError as error:
        return "asked", error.accepted.replace("|", r"\|")
    return "read", table.notes[0].replace("|", r"\|")


def page():
    """The page of the documentation."""
    # They are made of what stands here.
    from tests.decays.records.layouts_of_people import TEXTS  # noqa: PLC0415
    from tests.decays.records.layouts_of_programs import FILES  # noqa: PLC0415

    lines = [
        "# Layouts of data files", "",
        "What `asymptotics identify FILE` does with the layouts in which people store decays, of which each is written "
        "from one known motion by a test: the strength comes back, or the program asks what is told here. This page is "
        "written by `python -m tests.decays.records.layouts`; the test compares them.", "",
        "| layout | what happens |", "|---|---|",
    ]  # fmt: skip
    with tempfile.TemporaryDirectory() as folder:
        for name, layout in {**TEXTS, **FILES}.items():
            what, said = happens(layout, Path(folder))
            lines.append(f"| {name.replace('|', chr(92) + '|')} | {what}: {said} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
