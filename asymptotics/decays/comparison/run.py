"""A file of somebody's values, compared: every value with its right digits, and what the errors look like together.

>>> import tempfile
>>> from asymptotics.law import Oscillator
>>> path = Path(tempfile.mkdtemp()) / "mine.csv"
>>> _ = path.write_text("n,x\\n0,1\\n1,-0.4107197\\n2,0.2635711\\n")
>>> found = compare_file(path, Given(Oscillator({2: 1})))
>>> for row in found.rows:
...     print(row.key, row.column, row.marked, row.certified, row.digits)
0 x 1 1.0000000000000000000 20.00
1 x -0.4107197 -0.41071968606103944670 7.47
2 x 0.26357[11] 0.26356838641759692059 4.99
>>> found.summary["values"], found.summary["worst_digits"], found.certified
(3, '4.99', True)
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from statistics import median
from typing import Any

import numpy as np

from asymptotics.certificates.certificate import Certificate
from asymptotics.decays.comparison.certified import MotionBeside
from asymptotics.decays.comparison.digits import judged, right_in_words, significant
from asymptotics.decays.comparison.errors import Errors, of_motion, of_turning_points
from asymptotics.decays.comparison.order import order_of, told_order
from asymptotics.decays.comparison.quick_look import Look, look_of
from asymptotics.decays.comparison.reading import Columns, Sheet, as_double, read_sheet
from asymptotics.decays.comparison.truth import Truth, at_envelope, at_times, at_turning_points, of_its_law
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.frames import STRENGTHS, Frame
from asymptotics.law import of_unit_start
from asymptotics.law_given import Given
from asymptotics.numbers.digits import spread
from asymptotics.numbers.double_error import DoubleError
from asymptotics.numbers.double_words import stated_errors
from asymptotics.numbers.integers import parse_integer
from asymptotics.numbers.policy import Number
from asymptotics.present.counts import many
from asymptotics.present.drawn import Drawn
from asymptotics.present.figures import counted
from asymptotics.present.inputs import csv_text
from asymptotics.present.shown import Page, Rows, Shown
from asymptotics.running.cut_short import changed
from asymptotics.running.public import public
from asymptotics.turning.choose import turning_points

MAX_DIGITS, MAX_N = 1000, 10**30
LEAST_DIGITS, GUARD = 20, 4
"""Certified digits: four more than the longest value has, so that its last digit is judged; at least 20, more than
doubles have.  MAX_N is far beyond any table."""
_AXES = {"n": "turning point n", "tau": r"$\tau = \omega_0 t$", "t": "t (s)"}
_LOOKED_AT = 500  # half-swings whose errors are judged


@dataclass(frozen=True, repr=False)
class ComparedValue(Shown):
    """One value: where it stands, what it should be, and its right digits (-log10 of the relative error, two decimals).

    ``certified`` is None where there is no such value (the motion has ended); ``marked`` has wrong digits in brackets.
    ``key_name`` is n, tau or t; for a table the names of its keys with commas, and ``key`` their values with ", ".
    """

    line: int
    key: str
    column: str
    given: str
    certified: str | None
    digits: str
    error: str
    marked: str
    key_name: str = "n"

    def _page(self) -> Page:
        right = "there is no such value" if self.certified is None else f"certified {self.certified}"
        title = f"{self.column} at {self.key_name} = {self.key}: {self.marked}, {self.digits} right digits"
        return Page(title, (right, f"line {self.line}"))

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready."""
        keys: dict[str, Any] = dict(zip(self.key_name.split(","), self.key.split(", ")))
        if self.key_name == "n":
            keys = {"n": int(self.key)}
        names = ("column", "given", "certified", "digits", "error", "marked")
        return {"line": self.line, **keys, **{name: getattr(self, name) for name in names}}


@dataclass(frozen=True, repr=False)
class Comparison(Rows, Drawn):
    """All values of a file beside the truth; ``certified`` is whether every value beside them is.

    ``side``: what the certified values are of, where there is a certificate of it: a motion, a table, another result.
    """

    rows: tuple[ComparedValue, ...]
    summary: dict[str, Any]
    certified: bool
    method: str
    side: Any = field(default=None, compare=False)

    @public
    def certificate(self, *, max_seconds: Number = 60) -> Certificate:
        """A file from which ``check_certificate.py`` proves the certified values: turning points, x and v at times.

        InputError for a comparison with anything else, and with estimates.
        """
        if not self.certified:
            raise InputError("certificate", "what stands beside is an estimate", "certified values")
        if isinstance(self.side, MotionBeside):
            return self.side.certificate(self.rows)
        if not hasattr(self.side, "certificate"):
            reason = "what stands beside is neither turning points nor a motion at times"
            raise InputError("certificate", reason, "a comparison with turning points, x or v, or a table of them")
        made: Certificate = self.side.certificate()
        return made

    def _page(self) -> Page:
        summary, look = self.summary, self.summary["look"]
        title = f"right digits: worst {summary['worst_digits']}, median {summary['median_digits']}"
        right = right_in_words(summary["all_right"], summary["values"])
        worth = f"certified: {str(self.certified).lower()} ({self.method})"
        order = told_order(summary.get("order", {}))
        lines = (right, *([order] if order else []), f"the errors look like {look['kind']}: {look['reason']}", worth)
        head = (self.rows[0].key_name, "column", "given", "certified", "digits")
        return Page(title, lines, head, tuple((r.key, r.column, r.marked, r.certified, r.digits) for r in self.rows))

    def _heading(self) -> str:
        return f"digits lost: looks like {self.summary['look']['kind']}"

    def lost_digits(self) -> dict[str, tuple[list[float], list[float]]]:
        """For each column the keys, and the digits lost there: written with 16 of which 7.4 are right, 8.6."""
        columns: dict[str, tuple[list[float], list[float]]] = {}
        for row in self.rows:
            if row.certified is not None:
                keys, lost = columns.setdefault(row.column, ([], []))
                keys.append(as_double(row.key) if row.key_name in _AXES else len(keys))
                lost.append(max(0.0, significant(row.given) - float(row.digits)))
        return columns

    def _curve(self, axes: Any, **style: Any) -> None:
        for column, (keys, lost) in self.lost_digits().items():
            axes.plot(keys, lost, **{"marker": ".", "markersize": 3, "linewidth": 0.8, "label": column, **style})
        axes.set(xlabel=_AXES.get(self.rows[0].key_name, "value"), ylabel="digits lost")
        if self.rows[0].key_name == "n":
            counted(axes.xaxis)

    def _table(self) -> dict[str, list[Any]]:
        rows = self.rows
        found: dict[str, list[Any]] = {"line": [row.line for row in rows]}
        found |= {name: [row.to_dict()[name] for row in rows] for name in rows[0].key_name.split(",")}
        found |= {"column": [row.column for row in rows], "given": [as_double(row.given) for row in rows]}
        found |= spread("certified", [row.certified for row in rows], certified=self.certified)
        return found | {"right_digits": [float(row.digits) for row in rows]}

    def to_csv(self) -> str:
        """All rows as CSV; the last column says what code made it."""
        rows = [row.to_dict() for row in self.rows]
        return csv_text([*rows[0]], [[row.get(name) for name in rows[0]] for row in rows])

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready."""
        rows = [row.to_dict() for row in self.rows]
        return {"rows": rows, "summary": self.summary, "certified": self.certified, "method": self.method}


def compare_file(
    path: Path | Columns,
    given: Given,
    *,
    columns: str | None = None,
    digits: int | None = None,
) -> Comparison:
    """Compare turning points (a column n) or a motion (a column tau or t) with the certified ones: a file, or columns.

    The file is in the frame of what is given.  ``digits`` of the certified values: by
    default four more than the longest value given.  InputError for what the file does not say or says wrongly; an error
    that cuts the work short carries the rows that are done.
    """
    # With m = k = 1 a place in m and one in the units of the strengths are the same number.
    bare = given.oscillator.mass == given.oscillator.stiffness == 1
    lengths = (STRENGTHS,) if given.frame and bare else ()
    sheet, left = read_sheet(path, columns, frame=given.frame, lengths=lengths), list[str]()
    doubles = stated_errors(path) if isinstance(path, Path) else {}
    key = next((name for name in ("n", "tau", "t") if name in sheet.columns), None)
    # The first of n, tau, t is the key; a time beside n is a value.
    values = [name for name in sheet.columns if name != key]
    if key is None or not values:
        raise InputError("columns", "there is no key", "n or tau, and what is to be compared")
    wanted = digits or min(MAX_DIGITS, max(LEAST_DIGITS, *(GUARD + _written(sheet, name) for name in values)))
    # At a time amplitude and phase belong to the averaged law: beside x they are another motion's, and are left out and
    # told.
    if key != "n" and not set(values) <= {"amplitude", "phase"}:
        left = [name for name in values if name not in ("x", "v")]
        values = [name for name in values if name in ("x", "v")]
        if not values or (left and columns is not None):
            raise InputError("columns", "at a time there are x and v", "tau,x  or  tau,x,v  or  tau,amplitude,phase")

    # Without units turning points are in those of the start, and a motion is that of the law alone.
    alone = key == "n" and not given.frame
    side = MotionBeside(of_unit_start(given.oscillator.dimensionless) if alone else of_its_law(given))

    def compared(sheet: Sheet, truth: Truth, look: Callable[[Sequence[ComparedValue]], Look]) -> Comparison:
        rows = _rows(sheet, truth, key, values, wanted, given.frame, doubles)
        summary = summary_of(rows, look(rows))
        summary["order"] = order_of(list(sheet.numbers[key]), counted=key == "n")
        summary |= {"ended": truth.ended} if truth.ended else {}
        summary |= {"not_compared": left} if left else {}
        summary |= {"converted": list(sheet.converted)} if sheet.converted else {}
        summary |= told_doubles(doubles, values)
        return Comparison(rows, summary, truth.certified, truth.method, side)

    def so_far(truth: Truth) -> Comparison:
        places = range(len(sheet.lines)) if truth.places is None else truth.places
        return short_of(compared(sheet.only(places), truth, lambda _: UNJUDGED), sheet.lines)

    with changed(so_far):
        truth, judge = _truth(sheet, given, key, values, wanted, "FILE line" if isinstance(path, Path) else "row")
        # The values are there: if the time ends here, they are told without a look at their errors.
        with changed(lambda _: truth, otherwise=lambda: truth):
            errors, shift = judge()
    return compared(sheet, truth, lambda rows: _judged(rows, errors, shift))


UNJUDGED = Look("undecided", "the comparison was cut short, and errors are judged by all rows together")


def short_of(found: Comparison, lines_of_file: Sequence[int]) -> Comparison:
    """The same, telling which lines of the file are missing."""
    there = {row.line for row in found.rows}
    lines = [line for line in lines_of_file if line not in there]
    missing = f"lines {lines[0]} ... {lines[-1]} ({many(len(lines), 'row')})" if lines else "how the errors look"
    return replace(found, summary={**found.summary, "missing": missing})


Judge = Callable[[], tuple[Errors, Any | None]]


def _truth(sheet: Sheet, given: Given, key: str, values: list[str], digits: int, where: str) -> tuple[Truth, Judge]:
    """The certified values, and how the errors beside them are found."""
    if key == "n":
        _require_at_turning(values)
        numbers = [parse_integer(cell, f"{where} {n}", 0, MAX_N) for n, cell in zip(sheet.lines, sheet.column("n"))]
        turned = at_turning_points(given, numbers, digits, set(values))
        return turned, lambda: _of_turning(sheet, turned, numbers, values, given)
    times = list(sheet.numbers[key])
    if not set(values) <= {"x", "v"}:
        return at_envelope(given, times, digits, values), lambda: (Errors(*np.zeros((4, 0))), None)
    moved = at_times(given, times, digits, values)
    return moved, lambda: _of_motion(sheet, moved, times, given)


def _require_at_turning(values: list[str]) -> None:
    if "v" in values:
        raise InputError("columns", "v is 0 at every turning point", "x, amplitude, tau, t")
    if "phase" in values:
        raise InputError("columns", "the phase is pi n at every turning point", "x, amplitude, tau, t")


def _written(sheet: Sheet, name: str) -> int:
    return max(map(significant, sheet.column(name)))


def _rows(
    sheet: Sheet,
    truth: Truth,
    key: str,
    values: Sequence[str],
    digits: int,
    frame: Frame,
    doubles: Mapping[str, DoubleError],
) -> tuple[ComparedValue, ...]:
    # Counts as numpy.savetxt writes them, 0.000e+00, are told as 0.
    keys = [str(int(Fraction(cell))) for cell in sheet.column(key)] if key == "n" else sheet.column(key)
    name = "n" if key == "n" else frame.time if key == "t" else "tau"
    found = []
    for column in values:
        cells, right = sheet.column(column), truth.columns[column]
        numbers = sheet.numbers[column]
        may, places = doubles.get(column), zip(sheet.lines, keys, cells, numbers, right)
        found += [row_of(*where, column, name, digits, may) for where in places]
    return tuple(sorted(found, key=lambda row: row.line))


def row_of(
    line: int,
    key: str,
    given: str,
    value: Fraction,
    right: str | None,
    column: str,
    name: str,
    digits: int,
    double: DoubleError | None = None,
) -> ComparedValue:
    """One value, as text and as a number, beside the right one; ``double``: the error that it may have."""
    if right is None:
        return ComparedValue(line, key, column, given, None, "0.00", "", given, name)
    # The certified decimal as an exact fraction, through integers: its exponent may be beyond the doubles.
    found = judged(given, value, Fraction(*Decimal(right).as_integer_ratio()), digits, double)
    return ComparedValue(line, key, column, given, right, found.digits, found.error, found.marked, name)


def told_doubles(doubles: Mapping[str, DoubleError], columns: Sequence[str]) -> dict[str, list[str]]:
    """For the summary: which of the columns are doubles, and the errors that the header of the file gives them."""
    names = {column.split(" [")[0] for column in columns}
    told = [f"{name} ({error})" for name, error in doubles.items() if name in names]
    return {"doubles": told} if told else {}


def summary_of(rows: Sequence[ComparedValue], look: Look) -> dict[str, Any]:
    """Counts, best, median and worst right digits, the worst row, and the look of the errors."""
    digits = [float(row.digits) for row in rows]
    worst = rows[int(np.argmin(digits))]
    return {
        "values": len(rows),
        "all_right": sum("[" not in row.marked and row.certified is not None for row in rows),
        "best_digits": f"{max(digits):.2f}",
        "median_digits": f"{median(digits):.2f}",
        "worst_digits": worst.digits,
        "worst_line": worst.line,
        "look": look.to_dict(),
    }


def _judged(rows: Sequence[ComparedValue], errors: Errors, shift: Any | None) -> Look:
    lost = max(significant(row.given) - float(row.digits) for row in rows)
    # Values with few digits lose none when all that is written is right.
    wrong = any("[" in row.marked for row in rows)
    finite = len(errors) == 0 or bool(np.all(np.isfinite(errors.amplitude)))
    if not finite:
        return Look("undecided", "a turning point is given as 0, or as less than a double holds")
    return look_of(_without_rounding(errors, rows), shift, lost if wrong else 0.0)


def _without_rounding(errors: Errors, rows: Sequence[ComparedValue]) -> Errors:
    """At turning points: a column that is right in every digit written says nothing about errors."""
    wrong = {row.column for row in rows if "[" in row.marked or row.digits == "0.00"}
    if rows[0].key_name != "n" or not wrong:
        return errors
    advance = errors.advance if wrong & {"tau", "t"} else None
    amplitude = errors.amplitude if wrong & {"x", "amplitude"} else 0 * errors.amplitude
    return replace(errors, advance=advance, amplitude=amplitude)


def _of_turning(
    sheet: Sheet, truth: Truth, numbers: list[int], values: list[str], moving: Given
) -> tuple[Errors, Any | None]:
    size = next((name for name in ("x", "amplitude") if name in values), None)
    time = next((name for name in ("tau", "t") if name in values), None)
    scale = float(moving.oscillator.omega_0().mid()) if time == "t" and moving.frame else 1.0
    right = truth.columns[size] if size else []
    # Beyond the end of the motion there is nothing to compare with; 500 half-swings show what errors look like.
    there = [i for i, text in enumerate(right) if text is not None][:_LOOKED_AT]
    if size is None or not there:
        return Errors(*np.zeros((4, 0))), None
    ns = np.array([numbers[i] for i in there], float)
    given, x = _floats(sheet.column(size), there), _floats(right, there)
    if time is None:
        return of_turning_points(ns, given, x), None
    taus = _floats(truth.columns[time], there) * scale
    errors = of_turning_points(ns, given, x, _floats(sheet.column(time), there) * scale, taus)
    return errors, np.sort(taus) - np.pi * np.sort(ns)


def _of_motion(sheet: Sheet, truth: Truth, times: list[Fraction], moving: Given) -> tuple[Errors, Any | None]:
    """Errors at the true turning points, and the sum of T - pi there."""
    nothing = Errors(*np.zeros((4, 0)))
    if "x" not in sheet.columns:
        return nothing, None
    everything = list(range(len(times)))
    oscillator = moving.oscillator
    omega, length = (float(ball.mid()) if moving.frame else 1.0 for ball in (oscillator.omega_0(), oscillator.length()))
    tau = np.array([float(t) for t in times]) * omega
    given, x = (_floats(cells, everything) for cells in (sheet.column("x"), truth.columns["x"]))
    v = np.array(truth.speeds)
    # A half-swing lasts pi or so: as many turning points as the samples reach, and one more.
    last = min(int(tau.max() / np.pi) + 1, _LOOKED_AT)
    try:
        # Fifteen digits, for doubles; where they cannot be had, the values are judged and the look is not.
        points = turning_points(oscillator.dimensionless, last + 1, 15, times=True).points
    except (UndecidedError, LimitError):
        return nothing, None
    ts, sizes = (np.array([abs(float(text or 0)) for text in texts]) for texts in zip(*((p.tau, p.x) for p in points)))
    errors, ns = of_motion(tau, given / length, x / length, v / (length * omega), (ts, sizes))
    return errors, errors.tau - np.pi * ns


def _floats(texts: Sequence[str | None], places: Sequence[int]) -> Any:
    return np.array([as_double(text) if (text := texts[i]) else np.nan for i in places])
