r"""The numbers that notes, conditions, methods and slips quote, each computed again: a digit that is wrong is noticed.

A number is the statement's own (it stands in its forms or its LaTeX, or in the code of its check), or it is computed
here.  These are ties of a text to a value, in doubles: what is claimed of the paper is claimed by the checks.

>>> quoted("2^{-3/2} = 0.354, within 8 %, 2 10^-6 of x_0, (4.3)"), rounded("0.354", 2**-1.5), rounded("8 %", 0.084)
(['0.354', '8 %', '10^-6', '4.3'], True, True)
"""

import inspect
import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache
from importlib import import_module
from math import cos, exp, log, pi, sqrt
from typing import Any

import sympy

from asymptotics.law import Law
from asymptotics.turning.choose import turning_points
from paper_checks.lancaster2020.model import mean
from paper_checks.registry import Statement

NUMBER = re.compile(r"(?<![\w.^{/])-?\d+\.\d+(?:\.\.\.| ?%)?(?!\d)|(?<![\w.])\d+ ?%|10\^-\d+")
DOUBLES = 1e-9  # of the last digit: a value that lies on the edge of rounding in doubles is taken
Value = Callable[[], float]


def quoted(text: str) -> list[str]:
    """The decimals, percentages and powers of ten in a text."""
    return [found.lstrip("-") for found in NUMBER.findall(text)]


def texts(s: Statement) -> str:
    """What a statement says in words of ours."""
    return " | ".join((s.title, s.note, s.conditions, s.slip, *s.methods))


def rounded(text: str, value: float) -> bool:
    """Whether the text is this value, rounded to the digits of the text; before an ellipsis, cut off there."""
    share = text.rstrip(" %.")
    if share.startswith("10^"):
        return round(log(abs(value), 10)) == int(share[3:])
    places = len(share.partition(".")[2])
    size = abs(value) * (100 if text.endswith("%") else 1)
    if text.endswith("..."):
        return -DOUBLES * 10.0**-places <= size - float(share) < 10.0**-places
    return abs(size - float(share)) <= (0.5 + DOUBLES) * 10.0**-places


def untied(s: Statement) -> list[str]:
    """The numbers that a statement quotes and that are neither its own nor computed, or computed otherwise."""
    known, asked = COMPUTED.get(s.id, {}), quoted(texts(s))
    own = {*_own(s)} if asked else set()
    return [
        text
        for text in asked
        if not (rounded(text, known[text]()) if text in known else any(rounded(text, float(v)) for v in own))
    ]


def _own(s: Statement) -> Iterator[Fraction]:
    """The numbers in the forms, the LaTeX and the code of a check."""
    for form in (s.printed, s.corrected, s.near_miss):
        yield from _numbers(form)
    said = f"{s.latex} {s.corrected_latex or ''} {s.extent}"
    code = inspect.getsource(inspect.unwrap(s.check)).partition("\ndef ")[2] if s.check else ""
    yield from (Fraction(text) for text in re.findall(r"\d+\.\d+|\d+", said))
    yield from (Fraction(text) for text in re.findall(r"(?<![\w.])\d+\.\d+|\d+e-\d+", code))


def _numbers(form: Any) -> Iterator[Fraction]:
    if isinstance(form, tuple | dict):
        for part in form.values() if isinstance(form, dict) else form:
            yield from _numbers(part)
    elif isinstance(form, sympy.Basic):
        yield from (Fraction(int(q.p), int(q.q)) for q in form.atoms(sympy.Rational) if q.is_finite)
    elif isinstance(form, str) and re.fullmatch(r"-?\d+(\.\d+)?", form) or isinstance(form, int | float | Fraction):
        yield abs(Fraction(form))


# ---- Lancaster


@cache
def _against_13(alpha: str, epsilon: str, n: int) -> float:
    """|X_n| over the amplitude (13) at that turning point."""
    (point,) = turning_points(Law({alpha: epsilon}), 1, 15, start=n, times=True).points
    a = float(Fraction(alpha))
    bracket = 1 + (a - 1) * float(mean(sympy.Rational(alpha))) * float(epsilon) * float(point.tau or 0)
    return abs(float(point.x)) * bracket ** (1 / (a - 1))


def _worst(alpha: str, epsilon: str) -> float:
    return max(abs(_against_13(alpha, epsilon, n) - 1) for n in range(1, 6))


FIG_1 = 0.042 * pi / 2  # epsilon of Lancaster's Fig. 1
FIG_2 = 0.19 / float(mean(sympy.Rational(3, 2)))
CURVES_APART = max(abs(1.1**-s - 1 / (1 + 0.1 * s)) for s in (n / 1000 for n in range(1001)))


def _phase_lag() -> float:
    """The whole lag of the phase at alpha = 3/2: -Omega_2/((alpha-1) p_1) epsilon, first order in epsilon."""
    (last,) = turning_points(Law({"3/2": f"{FIG_2:.6f}"}), 1, 15, start=4000, times=True).points
    return float(last.tau or 0) - 4000 * pi


def _step() -> float:
    return 1e-3 * 1e-5 / import_module("paper_checks.lancaster2020.section_5_figures")._mean_speed(1e-3)


def _figure_3() -> tuple[float, float]:
    """The largest error of (21), and that of (22) at the start, for b = 1/10."""
    model = import_module("paper_checks.lancaster2020.model")
    section = import_module("paper_checks.lancaster2020.section_6_two_laws")
    always, late = (section.envelope(f) for f in (section.FRACTION, section.c * section.LAMBDA * section.DECAY))
    times = tuple(str(Fraction(n, 4)) for n in range(1, 81))
    states = model.exact_states((("1", "1/10"), ("2", "1/10")), times)
    taus = [float(Fraction(s)) for s in times]
    worst = max(abs(x - always(0.1, t) * cos(t)) for t, (x, _) in zip(taus, states))
    return worst, late(0.1, 0.0) / always(0.1, 0.0) - 1


# ---- Lelas


def _eps(mu: float) -> float:
    return mu * 1.5 * 9.81 / (30 * 0.2)


def _swings(mu: float) -> int:
    return next(n for n in range(100) if abs(1 - 2 * n * _eps(mu)) <= _eps(mu))


OMEGA = sqrt(30 / 1.5)
FAST = pi / (2 * sqrt(2))  # what the trick makes of the rate of friction
SLOW = 3 * pi / (8 * sqrt(2))  # and of air


def _tau(mu: float) -> float:
    return sqrt(2) / _eps(mu) / OMEGA


def _friction_error(mu: float, rate: float) -> float:
    """The largest error until tau of (1 - rate eps t) cos t against the exact motion, in x_0."""
    eps = _eps(mu)

    def exact(t: float) -> float:
        n = int(t / pi)
        return (1 - (2 * n + 1) * eps) * cos(t) + (-1) ** n * eps

    times = (n * sqrt(2) / eps / 40000 for n in range(40001))
    return max(abs((1 - rate * eps * t) * cos(t) - exact(t)) for t in times)


def _air_apart(drag: float) -> float:
    """How far (52) is from the exact amplitudes at the first twelve turning points, in x_0."""
    eps = drag * 0.2 / 1.5
    points = turning_points(Law({"2": str(Fraction(eps).limit_denominator(1000))}), 13, 15, times=True).points
    return max(abs(abs(float(p.x)) - 1 / (1 + 4 * eps / (3 * pi) * float(p.tau or 0))) for p in points[1:])


# ---- Smith


def _table(row: int) -> float:
    """S_n of Table I: S - S^-+(|u_n|, 0), at u_0 = 1."""
    u = abs(float(turning_points(Law({"2": "1"}), 1, 20, start=row).points[0].x))
    return _edge(1.0) - _edge(u)


def _edge(u: float) -> float:
    return -exp(-2 * u) * (u / 2 + 0.25)


def _three_cycles() -> float:
    (sixth,) = turning_points(Law({"2": "1"}), 1, 15, start=6, times=True).points
    return float(sixth.tau or 0) - 6 * pi


def _constants(printed: str, less: str) -> dict[str, Value]:
    """The printed S_n as a difference of two rounded constants: its own digits, and the two."""
    return {printed: lambda: float(printed), less: lambda: float(less)}


def _constant(module: str, name: str) -> tuple[float, ...]:
    """The numbers of a constant in the code of the checks."""
    values = getattr(import_module(f"paper_checks.{module}"), name)
    return tuple(float(v) for v in (values.values() if isinstance(values, dict) else values))


def _among(text: str, module: str, name: str) -> dict[str, Value]:
    """A number that the check uses: the one of a constant that is nearest to the text."""
    return {text: lambda: min(_constant(module, name), key=lambda value: abs(value - float(text)))}


def _slow_time() -> float:
    error = import_module("paper_checks.lelas2024.model").slow_error
    return float(inspect.signature(error).parameters["slow"].default)


_MASS, _LENGTH = (_among(text, "lelas2024.model", "FRICTION") for text in ("1.5", "0.2"))
_STARTS = {**_among("0.01", "smith2012.section_4_motion", "AMPLITUDES"),
           **_among("0.005", "smith2012.section_4_motion", "AMPLITUDES")}  # fmt: skip
_PANELS = {**_among("0.01", "lelas2024.section_5", "PANELS"), **_among("0.03", "lelas2024.section_5", "PANELS")}

COMPUTED: dict[str, dict[str, Value]] = {
    "lancaster2020:claim.slow-timescale": {"0.53": lambda: exp(-2 * pi / 10)},
    "lancaster2020:claim.fig1-short-times": {"0.066": lambda: FIG_1},
    "lancaster2020:claim.valid-for-any-b": {"20 %": lambda: 0.2, "6 %": lambda: 0.06},
    "lancaster2020:claim.large-b-agreement": {
        "0.2 %": lambda: max(_worst(a, "1") for a in ("3/2", "2", "3")),
        "87 %": lambda: _against_13("3/2", "5", 1) - 1, "17 %": lambda: _against_13("2", "5", 1) - 1,
        "4.3": lambda: _against_13("2", "100", 1), "1.4": lambda: _against_13("3", "100", 1),
    },
    "lancaster2020:17": {"2.75": lambda: 1 / (1 - 2 / pi), "64 %": lambda: 2 / pi},
    "lancaster2020:claim.fails-at-long-times": {"0.001": lambda: 0.001, "0.0011": lambda: 0.001 / (1 - 0.1)},
    "lancaster2020:claim.kappa-fig1": {"0.0652": lambda: 0.06519, "0.0667": lambda: 0.0667},
    "lancaster2020:claim.kappa-fig2": {"0.4577": lambda: float(mean(sympy.Rational(3, 2)))},
    "lancaster2020:fig1": {
        "0.056": lambda: 16 * FIG_1 - 1, "7.6": lambda: 1 / (2 * FIG_1), "0.0398": lambda: 1 / (8 * pi),
        "0.0660": lambda: FIG_1,
    },
    "lancaster2020:claim.gradual-breakdown": {
        "3.4": lambda: (18 * FIG_1 - 1) / (16 * FIG_1 - 1), "0.042": lambda: 2 * FIG_1 / pi,
    },
    "lancaster2020:fig2": {
        "0.02 %": lambda: max(abs(_against_13("3/2", f"{FIG_2:.6f}", n) - 1) for n in range(1, 10)),
        "0.28": _phase_lag, "0.19": lambda: 0.19, "0.4152": lambda: FIG_2,
    },
    "lancaster2020:claim.long-times-good": {"0.19": lambda: 0.19},
    "lancaster2020:claim.fn20-speed": {"0.0002": _step},
    "lancaster2020:22": {"46 %": lambda: _figure_3()[1]},
    "lancaster2020:claim.not-distinguishable": {"0.00108": lambda: CURVES_APART},
    "lancaster2020:fig3": {"8 %": lambda: _figure_3()[0], "46 %": lambda: _figure_3()[1]},
    "lelas2024:31": {"1.1107": lambda: FAST},
    "lelas2024:claim.stop-time-section-3": {"12.9": lambda: _tau(0.01)},
    "lelas2024:claim.stop-time-section-5": {"12.9": lambda: _tau(0.01)},
    "lelas2024:42": {"0.354": lambda: 2**-1.5, "0.424": lambda: 4 / (3 * pi)},
    "lelas2024:43": {"0.833": lambda: SLOW},
    "lelas2024:46": {"2.83": lambda: 2 * sqrt(2)},
    "lelas2024:47": {"0.0997": lambda: 1 - 2 * sqrt(2) / pi},
    "lelas2024:50": {"0.57664...": lambda: sqrt(2) * 30 * 0.2 / (1.5 * 9.81)},
    "lelas2024:value.tau-a": {"12.8941": lambda: _tau(0.01)},
    "lelas2024:value.tau-b": {"4.2980": lambda: _tau(0.03)},
    "lelas2024:value.tau-tilde-a": {
        "14.3217": lambda: FAST * _tau(0.01), "12.9": lambda: _tau(0.01), "1.11072": lambda: FAST,
        "14.328": lambda: 12.9 * FAST,
    },
    "lelas2024:value.tau-tilde-b": {
        "4.7739": lambda: FAST * _tau(0.03), "4.3": lambda: _tau(0.03), "1.11072": lambda: FAST,
        "4.776": lambda: 4.3 * FAST,
    },
    "lelas2024:value.tau-exact-a": {"14.0496": lambda: _swings(0.01) * pi / OMEGA},
    "lelas2024:value.tau-exact-b": {"4.9174": lambda: _swings(0.03) * pi / OMEGA},
    "lelas2024:value.rest-a": {"0.019": lambda: 1 - 2 * _swings(0.01) * _eps(0.01)},
    "lelas2024:value.rest-b": {
        "0.03005": lambda: 2 * _swings(0.03) * _eps(0.03) - 1, "0.117": lambda: 1 - 12 * _eps(0.03),
    },
    "lelas2024:claim.better-approximation": {
        "0.0997": lambda: _friction_error(0.01, 1 / sqrt(2)), "0.1141": lambda: _friction_error(0.03, 1 / sqrt(2)),
        "0.025": lambda: _friction_error(0.01, 2 / pi), "0.074": lambda: _friction_error(0.03, 2 / pi),
    },
    "lelas2024:claim.describes-well": {"11 %": lambda: FAST - 1},
    "lelas2024:claim.duration-estimate": {
        **_PANELS, "8.2 %": lambda: (1 - _tau(0.01) * OMEGA / (pi * _swings(0.01))),
        "12.6 %": lambda: (1 - _tau(0.03) * OMEGA / (pi * _swings(0.03))), "0.900": lambda: 1 / FAST,
    },
    "lelas2024:51": {"0.833": lambda: SLOW},
    "lelas2024:53": {"21.2132": lambda: 15 * sqrt(2)},
    "lelas2024:fig1": _MASS | _LENGTH | _among("9.81", "lelas2024.model", "FRICTION"),
    **{f"lelas2024:{number}": {"0.8": _slow_time} for number in (8, 9, 12, 13)},
    "smith2012:49": {"0.098765": lambda: _table(1)},
    "smith2012:69": _STARTS, "smith2012:70": _STARTS,
    "lelas2024:fig2": {
        **_MASS, "10^-6": lambda: _air_apart(0.2) / 2, "10^-4": lambda: _air_apart(2.0) / 2,
    },
    "lelas2024:claim.slower-decay": {"16.7 %": lambda: 1 - SLOW, "20 %": lambda: 1 / SLOW - 1},
    "lelas2024:claim.agrees-well": {"20 %": lambda: 1 / SLOW - 1},
    "smith2012:table1.u1": {"0.410720": lambda: float(turning_points(Law({"2": "1"}), 1, 15, start=1).points[0].x)},
    "smith2012:table1.S3": {"0.13383308...": lambda: _table(3), **_constants("0.235335", "0.101501")},
    "smith2012:table1.S5": {"0.14158827...": lambda: _table(5), **_constants("0.243090", "0.101501")},
    "smith2012:fig5": {"0.358": _three_cycles},
}  # fmt: skip
