"""The first-order envelope and phase: formula, certified numbers, curve."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Annotated, Any, cast

import sympy

from asymptotics.ask.answers import Again, Offers, Request, read_points
from asymptotics.ask.kinds import FLAG, REAL, SECONDS, digits, whole
from asymptotics.ask.laws import MOVES
from asymptotics.ask.moving import OVERLAY, TIME, overlaid, require_stretch
from asymptotics.ask.pairs import excludes
from asymptotics.ask.question import question
from asymptotics.ask.registry import loaded
from asymptotics.ask.typed import typed_options
from asymptotics.curves.envelope_compared import compared_envelope
from asymptotics.curves.envelope_order import acting_term, amplitude_and_phase
from asymptotics.curves.envelope_table import Curve, envelope_table, table_times
from asymptotics.curves.large import SpringEnvelope
from asymptotics.curves.slow import MAX_DIGITS, envelope
from asymptotics.curves.slow_series import MAX_ORDER, EnvelopeSeries
from asymptotics.curves.slowness import SlowPart
from asymptotics.decays.comparison.run import Comparison
from asymptotics.envelopes.symbolic import MEAN, SQUARING
from asymptotics.errors import InputError
from asymptotics.law import LawLike, Oscillator
from asymptotics.law_given import Given
from asymptotics.numbers.double_error import DoubleError
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number

_ENDS = {  # what is told beside A and tau(A)
    "phase_formula": "phi = {}",
    "total_lag": "phi -> -{} at long times",
    "long_time_formula": "A/A(0) -> {} at long times",
    "extinction_formula": "A = 0 from tau = {} on",
}
_TOLD = ("period", "extinction", "time", "amplitude", "phase")


@dataclass(frozen=True)
class EnvelopeAtTime:
    """The envelope: its formulas by name, its rates, and what was asked for of a time, the slow part and an order.

    ``period``: at the start, without loss, where the spring makes it depend on the amplitude.
    """

    curve: Curve
    formulas: dict[str, str | None]
    kappas: tuple[str, ...]
    period: str | None = None
    extinction: str | None = None
    time: str | None = None
    amplitude: str | None = None
    phase: str | None = None
    slow: SlowPart | None = None
    series: EnvelopeSeries | None = None

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready."""
        numbers = {"kappas": list(self.kappas)} | {name: getattr(self, name) for name in _TOLD}
        data: dict[str, Any] = {"averaging": self.curve.averaging, **self.formulas, **numbers}
        data["certified"] = self.series is None
        data |= {} if self.series is None else {"order": self.series.order}
        parts = {"slow": self.slow, "series": self.series}
        return data | {name: None if part is None else part.to_dict() for name, part in parts.items()}


def _data(found: EnvelopeAtTime, request: Request) -> dict[str, Any]:
    return found.to_dict() | {"units": _given(request).frame.units, "files": [], "notes": list(found.curve.notes)}


def _given(request: Request) -> Given:
    return cast("Given", request["law"])


def _text(found: EnvelopeAtTime, request: Request) -> str:
    given, formulas = _given(request), found.formulas
    head = "A/A(0) has no elementary form" if formulas["formula"] is None else f"A/A(0) = {formulas['formula']}"
    if found.period is not None:
        head = "A/A(0) by 2F1, exact in the spring"
    lines = [f"{head}, tau = omega_0 t" if given.frame else head]
    lines += [] if formulas["time_formula"] is None else [f"tau(A) = {formulas['time_formula']}, A in units of A(0)"]
    lines += [told.format(formulas[name]) for name, told in _ENDS.items() if formulas[name] is not None]
    lines += [f"kappa_{i}    {kappa}" for i, kappa in enumerate(found.kappas, start=1)]
    values = {name: getattr(found, name) for name in _TOLD}
    lines += [f"{n:10} {given.frame.with_unit(n, text)}" for n, text in values.items() if text is not None]
    claim = "certified: true (for the averaged law)"
    if found.series is not None:
        lines.append(f"epsilon    {acting_term(given.oscillator).strength}")
        N = found.series.order
        claim = f"certified: false (order {N}, explicit in the slow time, error O(epsilon**{N}))"
    return "\n".join([*lines, claim, *found.curve.notes])


def _besides(found: EnvelopeAtTime, request: Request) -> str:
    """The slow part and the series, which stand below everything, but not below LaTeX."""
    if request.typed("latex"):
        return ""
    slow, series = found.slow, found.series
    return "\n".join([*([] if slow is None else [str(slow)]), *([] if series is None else [str(series)])])


def _csv(found: EnvelopeAtTime, request: Request) -> str:
    return envelope_table(found.curve, request["time"], request.points, request["order"])


def _drawn(found: EnvelopeAtTime, request: Request) -> list[Any]:
    squaring = request["squaring"]
    given = _given(request)
    return overlaid(
        request.options, found.curve, given, lambda other: curve_of(replace(given, oscillator=other), squaring)
    )


def _style(_: EnvelopeAtTime, request: Request) -> dict[str, Any]:
    order = request["order"]
    return {"until": request["time"]} | ({} if order is None else {"order": order})


def _typed(request: Request) -> None:
    require_stretch(request)
    # Refused before the numbers are computed, as all that can be known beforehand is.
    asked = request.typed("latex") and request["order"] is None
    if asked and curve_of(_given(request), request["squaring"]).formula is None:
        raise InputError("--latex", "no elementary form is known for this law", "the command without --latex")


def _again(
    request: dict[str, str],
    header: list[str],
    rows: list[tuple[int, list[str]]],
    digits: int,
    doubles: Mapping[str, DoubleError],
) -> Comparison:
    """A and phi of the request at its own times; InputError for an order above the first, which is formal."""
    if "order" in request:
        raise InputError("FILE", "no route certifies an envelope of higher order: formal series", "the first order")
    options = typed_options("envelope", request)
    options.csv = "envelope.csv"  # what the header says was asked of a table
    asked = loaded("envelope").of_options(options)
    require_stretch(Request(asked, options))
    times = table_times(asked["time"], read_points(options)).tolist()
    return compared_envelope(curve_of(asked["law"], asked["squaring"]), times, header, rows, digits, doubles)


@question(
    Offers(
        latex="print the formula as LaTeX",
        picture="A(t) and x = A cos(omega_0 t + phi) from 0 to T",
        table="t, amplitude, phase from 0 to T",
        curve=True,
        overlay=OVERLAY,
        own_latex=True,
        data=_data,
        text=_text,
        as_latex=lambda found, _: str(found.formulas["latex"]),
        formula=lambda found, _: found.formulas["latex"] or "",
        letters=lambda found, _: found.curve._letters(),
        as_csv=_csv,
        drawn=_drawn,
        style=_style,
        besides=_besides,
        typed=_typed,
        again=Again(compared=_again),
        lacks={"gauge": "the first order is the same in every gauge; `--order` is in the turning-point gauge"},
    ),
    pairs=(excludes("order", "squaring", "the squaring trick has no higher orders", "--squaring left out"),),
    name="envelope",
    swept=True,
    example="--alpha 2 --epsilon 1/10 --time 2 --digits 5",
    rests="the averaged law in balls (`lancaster-average`, `two-laws-average`): certified for it, and it"
    " approximates the motion",
)
def envelope_at(
    law: Annotated[LawLike | Oscillator, MOVES],
    time: Annotated[Number | None, TIME] = None,
    *,
    order: Annotated[int | None, whole(1, MAX_ORDER)] = None,
    squaring: Annotated[bool, FLAG] = False,
    slow: Annotated[Number | None, REAL.called(letter="ETA", feeds={"eta": ("slow",)}, in_header=False)] = None,
    digits: Annotated[int, digits(MAX_DIGITS).called(in_header=False)] = 30,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> EnvelopeAtTime:
    """The first-order envelope A(t) and phase phi(t): the formula where one is known, certified numbers, and the curve.

      asymptotics envelope --alpha 3/2 --epsilon 1/10
      asymptotics envelope --alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5 --time 7 --digits 20
      asymptotics envelope --law 2:1/20 --spring pendulum --x0 3 --time 40
      asymptotics envelope --law 0:0.01 --law 2:0.3 --time 40 --plot envelope.svg --csv envelope.csv

    dA/dtau = -sum_i kappa_i A^alpha_i with kappa_i = M_(alpha_i+1) epsilon_i, tau = omega_0 t.  Every digit is proved
    for this averaged law; how far it is from the motion, `motion` tells.  --squaring averages by the squaring trick.
    With --spring 3:C or --spring pendulum the law is exact in the spring, for any amplitude inside the well (phase
    against omega_0 t), and the period at the start, without loss, is told too.
    Units are SI when --damping, --mass or --stiffness is given; otherwise there are none, and x0, v0 are those of X.

    In Python ``asy.envelope(law, averaging="squaring")``, then ``.amplitude(T)``, ``.phase(T)``, ``.slow(ETA)``;
    ``.series(N)`` and ``.at_order(T, N)``.

    Parameters
    ----------
    law
        a law or mapping exponent -> strength (epsilon) from rest, or an oscillator
    time
        the time in s (or tau) at which A and phi are wanted
    order
        one law from rest: A and phi of order N, explicit in the slow time, and their series in delta; formal
    squaring
        average by the squaring trick of Lelas 2024
    slow
        tell where |dA/dt| <= ETA omega_0 A, in doubles
    digits
        significant digits, correctly rounded
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for anti-damping, other springs, losses that depend on the place (but beside x^3), and an ``order`` or a
        ``slow`` part that is not known
    LimitError
        after ``max_seconds``

    Examples
    --------
    >>> found = envelope_at({"3/2": "1/10"}, 7, digits=12)
    >>> found.formulas["formula"], found.amplitude, found.phase
    ('(kappa_1*tau/2 + 1)**(-2)', '0.742932894111', '-0.00921858360000')
    """
    given, moment = cast("Given", law), cast("ExactReal | None", time)
    found = curve_of(given, squaring)
    part = None if slow is None else _slow(found, slow)
    series = None if order is None else _series(found, order, digits)
    made = EnvelopeAtTime(found, _formulas(found, series), found.kappas(digits=digits), slow=part, series=series)
    if isinstance(found, SpringEnvelope):
        made = replace(made, period=found.period(abs(found.oscillator.x0), digits=digits))
    if series is None:
        made = replace(made, extinction=found.extinction_time(digits=digits))
    if moment is None:
        return made
    at_order = None if series is None else amplitude_and_phase(series, found.oscillator, moment, digits)
    amplitude, phase = at_order or _first_order(found, moment, digits)
    return replace(made, time=str(moment), amplitude=amplitude, phase=phase)


def curve_of(given: Given, squaring: bool) -> Curve:
    """The envelope of what is given."""
    return replace(envelope(given.oscillator, averaging=SQUARING if squaring else MEAN), frame=given.frame)


def _slow(found: Curve, eta: Number) -> SlowPart:
    """The slow part, for the linear spring."""
    if isinstance(found, SpringEnvelope):
        raise InputError("slow", "it is not known beside a spring", "a law alone")
    return found.slow(eta)


def _series(found: Curve, order: int, digits: int) -> EnvelopeSeries:
    """The series of an order, for the linear spring."""
    if isinstance(found, SpringEnvelope):
        raise InputError("order", "it is not known beside a spring", "one law alone")
    if not found.oscillator.v0.is_zero:
        raise InputError("order", "it starts at rest", "a start at rest; other starts: the motion of that order")
    return found.series(order, digits=digits)


def _first_order(found: Curve, time: ExactReal, digits: int) -> tuple[str, str | None]:
    """A, and phi where the trick and the law have one: there is no phase without an amplitude."""
    amplitude = found.amplitude(time, digits=digits)
    # "0" is exact here: from the extinction time on.
    alone = found.averaging == SQUARING or amplitude == "0"
    return amplitude, None if alone else found.phase(time, digits=digits)


def _formulas(found: Curve, series: EnvelopeSeries | None) -> dict[str, str | None]:
    """A/A(0), tau(A) and what is told beside them, as text; None where nothing elementary is known."""
    if series is not None:
        A, phi = series.explicit
        latex = rf"\frac{{A}}{{A(0)}} = {sympy.latex(A)},\quad \phi = {sympy.latex(phi)}"
        known = {"family": "power", "formula": str(A), "latex": latex, "phase_formula": str(phi)}
        return {name: known.get(name) for name in ("family", "formula", "latex", "time_formula", *_ENDS)}
    formula = found.formula
    parts: tuple[str | None, ...] = (None, None, None)
    if formula is not None:
        parts = formula.family, str(formula.expression), rf"\frac{{A}}{{A(0)}} = {sympy.latex(formula.expression)}"
    made = dict(zip(("family", "formula", "latex"), parts))
    rest = {name: getattr(found, name, None) for name in ("time_formula", *_ENDS)}
    return made | {name: None if one is None else str(one) for name, one in rest.items()}
