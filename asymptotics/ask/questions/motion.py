"""x(t) and v(t) at a chosen order, or exact and high-precision reference motion."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Annotated, Any, cast

from asymptotics.ask.answers import Again, Offers, Request
from asymptotics.ask.kinds import FLAG, REAL, SECONDS, choice, digits, whole
from asymptotics.ask.laws import MOVES_OR_RESTS
from asymptotics.ask.moving import OVERLAY, TIME, overlaid
from asymptotics.ask.pairs import excludes, needs
from asymptotics.ask.question import question
from asymptotics.bounds.motion import proved_bound
from asymptotics.bounds.uniform import UniformBound, uniform_bound
from asymptotics.certificates.of_results import of_states
from asymptotics.curves.double_errors import of_motion
from asymptotics.curves.motion_table import motion_table, reference_is_near
from asymptotics.curves.motions import Motion, Reference
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.expansions.divergence.truncation import BestOrder
from asymptotics.expansions.equations.build import expand
from asymptotics.gauges import GAUGES, TURNING_POINT
from asymptotics.law import LawLike, Oscillator
from asymptotics.law_given import Given
from asymptotics.motions.asymptotic import MAX_DIGITS as MAX_ASYMPTOTIC_DIGITS
from asymptotics.motions.asymptotic import MAX_ORDER
from asymptotics.motions.point import MotionPoint
from asymptotics.motions.reference import MAX_DIGITS, reference_motion
from asymptotics.motions.result import MotionSamples
from asymptotics.numbers.double_words import with_errors
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number

DEFAULT_ORDER = 3


@dataclass(frozen=True)
class MotionAtTime:
    """x and v at one time, what is proved of x, and where the expansion is best stopped, as far as it was asked for.

    ``curve`` is the motion itself; None of one that rests.
    """

    point: MotionPoint
    curve: Motion | Reference | None = None
    bound: str | None = None
    uniform_bound: UniformBound | None = None
    best_order: BestOrder | None = None


_TOLD = ("x", "v", "amplitude", "phase", "error")


def _data(found: MotionAtTime, request: Request) -> dict[str, Any]:
    data: dict[str, Any] = {**found.point.to_dict(), "units": _given(request).frame.units, "files": []}
    if found.bound is not None:
        always = found.uniform_bound
        data |= {"bound": found.bound, "uniform_bound": None if always is None else always.to_dict()}
    return data if found.best_order is None else data | {"best_order": found.best_order.to_dict()}


def _text(found: MotionAtTime, request: Request) -> str:
    frame, point = _given(request).frame, found.point
    values = {name: getattr(point, name) for name in _TOLD}
    lines = [f"{name:9}  {frame.with_unit(name, value)}" for name, value in values.items() if value is not None]
    if found.bound is not None:
        lines.append(f"bound      {frame.with_unit('bound', found.bound)} (proved: |x - x_N| is at most this)")
    lines += [f"proved for x_N before rounding: {found.uniform_bound}"] if found.uniform_bound is not None else []
    lines += [str(found.best_order)] if found.best_order is not None else []
    order = "" if point.order is None or request["reference"] else f", order {point.order}, gauge {point.gauge}"
    certified = f"certified: {str(point.certified).lower()}"
    return "\n".join([*lines, f"{certified} ({point.method}{order})", *point.notes])


def _given(request: Request) -> Given:
    return cast("Given", request["law"])


def _csv(found: MotionAtTime, request: Request) -> str:
    assert found.curve is not None  # of what rests there is no table: refused before
    rows = motion_table(found.curve, request["time"], request.points)
    return with_errors(rows.to_csv(), of_motion(found.curve, rows))


def _rows_done(rows: Any, request: Request) -> tuple[str, int, str] | None:
    """The rows that were done when the time was over; None of anything else that was under way."""
    if not isinstance(rows, MotionSamples):
        return None
    frame = _given(request).frame
    errors = of_motion(Reference(_given(request).oscillator, frame=frame), rows)
    return (
        with_errors(rows.to_csv(), errors),
        len(rows.t),
        f"{frame.time} > {frame.with_unit('t', repr(float(rows.t[-1])))}",
    )


def _drawn(found: MotionAtTime, request: Request) -> list[Any]:
    return overlaid(request.options, cast("Any", found.curve), _given(request), lambda other: _curve(found, other))


def _curve(found: MotionAtTime, oscillator: Oscillator) -> Motion | Reference:
    """The same of another law."""
    like = found.curve
    if isinstance(like, Reference):
        return Reference(oscillator, like.static, frame=like.frame)
    like = cast("Motion", like)
    return Motion(oscillator, like.order, like.gauge, frame=like.frame)


def _style(found: MotionAtTime, request: Request) -> dict[str, Any]:
    # Errors and velocities have axes below, for one law: several would lie over one another.
    alone, reference = request.typed("overlay") is None, isinstance(found.curve, Reference)
    shows = alone and (reference or reference_is_near(_given(request).oscillator, request["time"]))
    return {"until": request["time"], **({"velocity" if reference else "errors": True} if shows else {})}


def _typed(request: Request) -> None:
    if not request.has_files:
        return
    if _given(request).rests:
        raise InputError("--x0", "with x0 = 0 and v0 = 0 nothing moves: nothing to draw", "a start that moves")
    if not request["time"] > 0:
        raise InputError("--time", "0 leaves nothing to draw or to tabulate", "a time > 0 with --plot or --csv")


def _certificate(found: MotionAtTime, request: Request) -> Any:
    """Of x and v at the time, with as many digits as were asked for."""
    digits = 30 if request["digits"] is None else request["digits"]
    return of_states(_given(request).oscillator, [(request["time"], found.point)], digits)


def _as_reference(point: Mapping[str, str], digits: int) -> dict[str, str]:
    """A row of order N is an expansion, of a gauge: x and v are held against the certified motion, the rest is not."""
    kept = {name: value for name, value in point.items() if name not in ("order", "gauge", "best-order")}
    return {**kept, "reference": "", "digits": str(digits)}


@question(
    Offers(
        picture="waveform, envelope and error curve from 0 to T",
        table="t, x, v, amplitude, phase from 0 to T",
        curve=True,
        overlay=OVERLAY,
        oscillator_alone=True,
        always_files=True,
        data=_data,
        text=_text,
        as_csv=_csv,
        formula=lambda found, _: found.point._formula(),
        drawn=_drawn,
        style=_style,
        typed=_typed,
        again=Again(at=_as_reference, judged=("x", "v"), route="the certified motion at each row"),
        certificate=_certificate,
        rows_done=_rows_done,
        lacks={
            "latex": "the answer is numbers at one time; `expand --latex` has the equations",
            "force": "here the oscillator is left to itself after its start; `asymptotics response` has the driven one",
        },
    ),
    pairs=(
        excludes(
            "reference", "order gauge", "it has neither order nor gauge", "--reference alone, or --order and --gauge"
        ),
        excludes("bound", "reference", "the reference motion is certified by itself", "--bound with --order N"),
        excludes("best-order", "reference", "the reference motion has no order", "--best-order with --order N"),
        needs("static", "reference", "the expansion knows no static friction", "--static with --reference"),
        needs("certificate", "reference", "an expansion has an estimate", "--certificate with --reference alone"),
        excludes(
            "certificate", "static", "static friction is another equation", "--certificate with --reference alone"
        ),
    ),
    name="motion",
    swept=True,
    example="--alpha 2 --epsilon 1/10 --time 1 --order 1 --digits 5",
    rests="a series that diverges: its error is measured, unless `--bound` proves one (`uniform-bound`,"
    " `explicit-bound`)",
)
def motion_at(
    law: Annotated[LawLike | Oscillator, MOVES_OR_RESTS],
    time: Annotated[Number, TIME],
    *,
    order: Annotated[int | None, whole(1, MAX_ORDER).called(default=f"{DEFAULT_ORDER}")] = None,
    bound: Annotated[bool, FLAG] = False,
    best_order: Annotated[Number | None, REAL.called(letter="D", feeds={"delta": ("best_order",)})] = None,
    reference: Annotated[bool, FLAG] = False,
    gauge: Annotated[str | None, choice(*GAUGES, letter="G", of="gauge").called(default="the first")] = None,
    static: Annotated[Number | None, REAL.called(letter="F", group="the law")] = None,
    digits: Annotated[int | None, digits(MAX_DIGITS, "30 with --reference, else what the error leaves")] = None,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> MotionAtTime:
    """Displacement and velocity at one time, for m x'' + k x + sum_i b_i x'|x'|^(alpha_i-1) = 0:

      asymptotics motion --alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5 --time 7
      asymptotics motion --alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5 --time 7 --reference --digits 40
      asymptotics motion --alpha 2 --damping 0.1 --spring 3:0.5 --x0 1 --time 7
      asymptotics motion --alpha 2 --epsilon 1/10 --time 7
      asymptotics motion --law 0:0.01 --law 2:0.3 --x0 1/5 --v0 -1 --time 10 --order 2 --plot a.svg --csv a.csv

    The start is x(0) = x0, x'(0) = v0.  Units are SI when --damping, --mass or --stiffness is given; otherwise m = k =
    x0 = 1 and there are none.  --order N: p_k and Omega_k for k <= N and the waveform through delta^(N-1); order 1 is
    x0 A(t) cos(omega_0 t).  `phase` is psi - omega_0 t, and `error` an estimate from the orders N + 1 and N + 2; with
    --bound, `bound` is a proved bound of |x - x_N| at that time, rounded up, and `uniform_bound` one for every t >= 0
    (exponents below 1: up to that time), for powers of the velocity in the first gauge.  --reference: every digit
    proved, for any powers of the velocity, whole powers of the place in springs and losses, the pendulum, from any
    start (springs with |x'|^Q are for expand); closed forms where there are any, and for alpha = 1 a note whether the
    motion is under-, critically or overdamped.

    --best-order D says for one law where to stop at the local strength delta = D, and what is left, in half-swings.

    --spring P:C adds C x|x|^(P-1) (C in N/m^P), pendulum has K sin x in place of K x (rad).

    In Python ``asy.motion(law, order=N, gauge=G).at(T)``, ``.bound(T)`` and ``.uniform_bound()``;
    ``asy.reference(law, static=F).at(T)``; ``asy.expand(law).best_order(D)``.

    Parameters
    ----------
    law
        a law or mapping exponent -> strength (epsilon) from rest, or an oscillator
    time
        the time in s (or tau), >= 0
    order
        order of the expansion
    bound
        a proved bound of the error of x at that time
    best_order
        for one law at the local strength D: the best order and the smallest error, in half-swings
    reference
        exact or high-precision motion instead
    gauge
        the gauge of the expansion
    static
        beside alpha = 0: static friction force in N, >= b
    digits
        significant digits, correctly rounded
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for anti-damping, values out of range, and what has no effect beside ``reference``
    LimitError
        with the estimate
    UndecidedError
        where balls cannot tell how it goes on

    Examples
    --------
    >>> found = motion_at(Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5"), 7, bound=True)
    >>> found.point.x, found.bound
    ('0.16385309', '6.6e-9')
    >>> motion_at({2: "1/10"}, 7, reference=True, digits=12).point.x
    '0.600474773860'
    """
    given = cast("Given", law)
    if not reference and digits is not None and digits > MAX_ASYMPTOTIC_DIGITS:
        raise InputError("digits", f"{digits} is too large", f"at most {MAX_ASYMPTOTIC_DIGITS} for an expansion")
    oscillator, moment, seconds = given.oscillator, cast("ExactReal", time), cast("float", max_seconds)
    N, G = order or DEFAULT_ORDER, gauge or TURNING_POINT
    if given.rests:
        if static is not None:
            reference_motion(oscillator, 0, static=static)
        best = _best_order(oscillator, best_order, seconds)
        return MotionAtTime(_rest(reference, N, G), None, "0" if bound else None, None, best)
    frame = given.frame
    curve = Reference(oscillator, static, frame=frame) if reference else Motion(oscillator, N, G, frame=frame)
    point = curve.at(moment, digits=30 if reference and digits is None else digits)  # type: ignore[arg-type]
    # Of the x that is printed, rounded as it is: the two stand side by side.
    proved = proved_bound(oscillator, point.x, moment, max_seconds=seconds) if bound else None
    always = _uniform(oscillator, point, moment) if bound else None
    always = None if always is None else replace(always, frame=frame)
    return MotionAtTime(point, curve, proved, always, _best_order(oscillator, best_order, seconds))


def _best_order(oscillator: Oscillator, delta: Number | None, seconds: float) -> BestOrder | None:
    """Where the expansion of this law is best stopped, if that is asked for."""
    return None if delta is None else expand(oscillator, order=1).best_order(delta, max_seconds=seconds)


def _uniform(oscillator: Oscillator, point: MotionPoint, time: ExactReal) -> UniformBound | None:
    """The bound for all times, or, for an exponent below 1, up to the time that is asked for, if there is one."""
    if point.gauge != TURNING_POINT or not oscillator.law.is_pure or point.order is None:
        return None
    # Below 1 the local strength grows and leaves the range of the theorem: a bound up to the time that is asked for may
    # exist where none for all times does.
    growing = any(term.velocity < 1 for term in oscillator.law.terms)
    try:
        return uniform_bound(oscillator, point.order, until=time if growing and time > 0 else None)
    except (LimitError, UndecidedError):  # x and its bound at this time are there all the same
        return None


def _rest(reference: bool, order: int, gauge: str) -> MotionPoint:
    """x0 = 0 and v0 = 0: nothing moves, whatever the law."""
    method = "rest: x0 = 0 and v0 = 0"
    if reference:
        return MotionPoint("0", "0", None, None, None, None, method, "0", True)
    return MotionPoint("0", "0", "0", None, order, gauge, method, "0", True)
