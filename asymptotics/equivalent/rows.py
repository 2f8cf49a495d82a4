"""One amplitude: equivalent damping of first order, of the motion itself, and of order N, as proved decimals.

The oscillator is taken with its start at rest at that amplitude, so that its dimensionless strengths are the local ones
and the amplitude is 1; units come back at the end: Delta E in k A^2, c_eq in sqrt(k m), times in 1/omega_0.

>>> from fractions import Fraction
>>> drag = Oscillator({2: "1/10"}, mass="3/2", stiffness=30)
>>> row = row_at(drag, ExactReal(Fraction(1, 5)), 8, 3)
>>> row.first.zeta, row.motion.zeta_log, row.expanded.zeta_log, row.expanded.bounds["zeta_log"]
('0.0056588424', '0.0055606444', '0.00556065', '2.3e-8')
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from flint import arb

from asymptotics.envelopes.first_order import FirstOrderEnvelope
from asymptotics.envelopes.large import SlowFlow
from asymptotics.equivalent.conservative_cycle import ConservativeCycle
from asymptotics.equivalent.cycle import FullSwing, expanded_swing, full_swing, swing_bits
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.expansions.straightening.wells import Loss, Well
from asymptotics.flow.wells.force import WellForce
from asymptotics.flow.wells.trapping_regions import require_inside
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for, certified_decimal, decimal_of_ball, directed_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.numbers.rationals import bounds, decimal_fraction
from asymptotics.present.shown import Page, Shown
from asymptotics.terms import Term

QUANTITIES = ("zeta", "zeta_log", "Q", "decrement", "energy_loss", "c_eq", "half_life", "period", "omega")
# The half-life is a time of first order only: there is no curve of the motion beside it.
DRAWN = ("zeta", "Q", "decrement", "energy_loss", "c_eq", "period", "omega")
OF_MOTION = {"zeta": "zeta_log"}
"""What stands of the motion itself beside a quantity of first order, where it has a definition of its own."""
# The first precision and the last: digits that are not decided by then are refused, never guessed.
_GUARD, _DOUBLINGS = 24, 4
_NO_HALF_LIFE = "half-life: known beside the linear spring, one x^3 or the pendulum, for losses >= 0"


@dataclass(frozen=True, repr=False)
class Measure(Shown):
    """The quantities at one amplitude as decimals, None for what is not there, and how they were found.

    ``zeta`` = Delta E/(4 pi E) is of first order; of the motion and its series ``zeta_log`` =
    decrement/sqrt(4 pi^2 + decrement^2), which is b/(2 sqrt(k m)) exactly for viscous damping.  ``period`` and
    ``omega`` = 2 pi/period are those of the cycle without loss, and of the motion those of its full swing.
    ``bounds``: of order N, how far each may be from the motion's, rounded up; ``reason``: why there is nothing.
    ``certified``: the digits are proved (with ``bounds``: proved within them).
    """

    zeta: str | None = None
    Q: str | None = None
    decrement: str | None = None
    energy_loss: str | None = None
    c_eq: str | None = None
    half_life: str | None = None
    zeta_log: str | None = None
    period: str | None = None
    omega: str | None = None
    route: str = ""
    reason: str = ""
    bounds: dict[str, str] = field(default_factory=dict)
    certified: bool = field(default=False, compare=False)

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: numbers are strings."""
        found: dict[str, Any] = {name: getattr(self, name) for name in QUANTITIES}
        found |= {"route": self.route, "certified": self.certified}
        found |= {"bounds": dict(self.bounds)} if self.bounds else {}
        return found | ({"reason": self.reason} if self.reason else {})

    @property
    def guarantee(self) -> str:
        """What the numbers are worth, in words."""
        kind = "certified" if self.certified else "not certified"
        return f"{kind}: {self.route}" + (", each with its bound" if self.bounds else "") if self.route else kind

    def _page(self) -> Page:
        told = [(name, value) for name in QUANTITIES if (value := getattr(self, name)) is not None]
        rows = tuple((name, f"{value} +- {self.bounds[name]}" if self.bounds else value) for name, value in told)
        title = ", ".join(f"{name} = {value}" for name, value in rows[:3]) or self.reason
        return Page(title, (self.guarantee, *([self.reason] if told and self.reason else [])), ("", "value"), rows)


@dataclass(frozen=True, repr=False)
class DampingRow(Shown):
    """The amplitude as it was given, and what the losses are there: ``first`` order, ``motion``, ``expanded``."""

    amplitude: str
    first: Measure
    motion: Measure | None
    expanded: Measure | None

    @property
    def parts(self) -> dict[str, Measure]:
        """The measures that there are, by name."""
        named = {"first": self.first, "motion": self.motion, "expanded": self.expanded}
        return {name: found for name, found in named.items() if found is not None}

    def _page(self) -> Page:
        rows = tuple((part, name, value) for part, m in self.parts.items() for name, value in m._page().rows)
        lines = tuple(dict.fromkeys(m.guarantee for m in self.parts.values()))
        return Page(f"A = {self.amplitude}: {self.first._page().title}", lines, ("part", "", "value"), rows)


def row_at(
    oscillator: Oscillator, amplitude: ExactReal, digits: int, order: int | None, motion: bool = True
) -> DampingRow:
    """The row of one amplitude > 0; InputError outside the well."""
    local = Oscillator(oscillator.law, mass=oscillator.mass, stiffness=oscillator.stiffness, x0=amplitude)
    springs = [t for t in local.dimensionless.springs if not t.strength.is_zero]
    if springs:
        for t in springs:
            if not t.velocity.is_zero:
                raise InputError("spring", f"{t.shape()} depends on the velocity: no potential", "springs c x|x|^(P-1)")
        # In the local units the amplitude is 1: asked before any integral, which would not end outside the well.
        require_inside(WellForce.of(springs), arb(1), f"the amplitude {amplitude}")
    expanded = None if order is None else _expanded(local, digits, order)
    return DampingRow(str(amplitude), _first(local, digits), _motion(local, digits) if motion else None, expanded)


def cycle_of(local: Oscillator) -> ConservativeCycle:
    """The cycle without loss at the current precision."""
    terms = local.dimensionless.terms
    return ConservativeCycle.of(terms, [t.strength.ball() for t in terms])


def _units(local: Oscillator) -> tuple[arb, arb, arb]:
    """(k A^2, sqrt(k m), omega_0)."""
    k = local.stiffness.ball()
    return k * local.length() ** 2, (k * local.mass.ball()).sqrt(), local.omega_0()


def _first(local: Oscillator, digits: int) -> Measure:
    made: dict[int, ConservativeCycle] = {}  # one at each precision, for all numbers

    def cycle() -> ConservativeCycle:
        if ctx.prec not in made:
            made[ctx.prec] = cycle_of(local)
        return made[ctx.prec]

    def number(value: Callable[[ConservativeCycle], arb]) -> str:
        return certified_decimal(lambda: value(cycle()), digits)

    half = _half_life(local, digits)
    return Measure(
        number(lambda o: o.zeta),
        number(lambda o: o.quality),
        number(lambda o: o.decrement),
        number(lambda o: o.lost * _units(local)[0]),
        number(lambda o: o.coefficient * _units(local)[1]),
        half,
        period=number(lambda o: o.period / _units(local)[2]),
        omega=number(lambda o: 2 * arb.pi() * _units(local)[2] / o.period),
        route="one cycle without loss",
        reason="" if half is not None else _NO_HALF_LIFE,
        certified=True,
    )


def _half_life(local: Oscillator, digits: int) -> str | None:
    """The time of the first-order envelope from A to A/2, or None where it is not known."""
    law = local.dimensionless
    springs = [t for t in law.springs if not t.strength.is_zero]
    # The envelopes know losses >= 0 that do not see the place; one loss that does has a formula of its own.
    if not law.is_dissipative or (not springs and not law.is_pure and any(t.position for t in law.losses)):
        return _placed(local, digits)
    if not springs:
        return FirstOrderEnvelope(local.with_law({t.velocity: t.b for t in local.law.losses})).time(
            abs(local.x0) / 2, digits
        )
    # The wells of ``straightening``: the pendulum, and one x^3.
    known = len(springs) == 1 and (springs[0].family or springs[0].position == 3)
    if not known or (springs[0].family and any(t.position for t in law.losses)):
        return None
    return certified_decimal(lambda: _slow_time(local, springs[0]), digits)


def _placed(local: Oscillator, digits: int) -> str | None:
    """Beside the linear spring with one loss that depends on the place: (2^w - 1)/(w zeta), and ln 2/zeta at w = 0."""
    losses = [t for t in local.dimensionless.losses if not t.strength.is_zero]
    if len(losses) != 1 or not local.dimensionless.is_dissipative:
        return None

    def seconds() -> arb:
        w, rate = losses[0].weight, cycle_of(local).zeta * local.omega_0()
        return arb(2).log() / rate if w.is_zero else ((arb(2).log() * w.ball()).expm1()) / (w.ball() * rate)

    return certified_decimal(seconds, digits)


def _slow_time(local: Oscillator, spring: Term) -> arb:
    strength = spring.strength.ball()
    well = Well.pendulum(strength) if spring.family else Well.duffing(strength)
    losses = [t for t in local.dimensionless.losses if not t.strength.is_zero]
    flow = SlowFlow(well, tuple(Loss(t.strength.ball(), t.velocity.ball(), t.position) for t in losses), arb(1))
    return flow.time(well.xi(arb(1) / 2)) / local.omega_0()


def _values(swing: FullSwing, local: Oscillator) -> dict[str, arb]:
    """The quantities of a full swing; c_eq beside the linear spring alone."""
    energy, viscous, _ = _units(local)
    start = cycle_of(local).energy
    found = {"zeta_log": swing.zeta_log, "Q": swing.quality, "decrement": swing.decrement}
    found["energy_loss"] = swing.share * start * energy
    if not any(not t.strength.is_zero for t in local.law.springs):
        found["c_eq"] = 2 * swing.zeta_log * viscous
    if swing.period is not None:
        omega_0 = local.omega_0()
        found |= {"period": swing.period / omega_0, "omega": 2 * arb.pi() * omega_0 / swing.period}
    return found


def _motion(local: Oscillator, digits: int) -> Measure:
    law = local.dimensionless
    if not law.is_dissipative:
        return Measure(reason="anti-damping: no certified full swing")

    def attempt(bits: int) -> Measure | None:
        swing = full_swing(law, swing_bits(bits))
        # No full swing (it sticks, creeps or stops at the centre): an answer in words, which no precision changes.
        if isinstance(swing, str):
            return Measure(reason=swing)
        texts = {name: decimal_of_ball(value, digits) for name, value in _values(swing, local).items()}
        if None in texts.values():
            return None
        return Measure(**texts, route="certified turning points", certified=True)  # type: ignore[arg-type]

    bits = bits_for(digits, _GUARD)
    try:
        return at_growing_precision(attempt, digits, bits, max_bits=bits << _DOUBLINGS)
    except (UndecidedError, LimitError) as error:
        # The time of the whole request is over, which is no property of this amplitude.
        if isinstance(error, LimitError) and error.argument == "max_seconds":
            raise
        return Measure(reason=error.reason if isinstance(error, LimitError) else str(error))


def _expanded(local: Oscillator, digits: int, order: int) -> Measure:
    terms = [t for t in local.dimensionless.terms if not t.strength.is_zero]
    if not local.dimensionless.is_dissipative:
        return Measure(reason="anti-damping: no bound is proved")
    # Once is enough: the width is that of the bound, not of the rounding.
    with ctx.workprec(bits_for(digits, 64)):
        swing = expanded_swing(terms, [t.strength.ball() for t in terms], order)
        if isinstance(swing, str):
            return Measure(reason=swing)
        pairs = {name: _within(value, digits) for name, value in _values(swing, local).items()}
    values = {name: value for name, (value, _) in pairs.items()}
    return Measure(
        **values, route=f"series of order {order}", bounds={n: b for n, (_, b) in pairs.items()}, certified=True
    )


def _within(ball: arb, digits: int) -> tuple[str, str]:
    """(a decimal, how far at most every number of the ball is from it), as many digits as that leaves."""
    low, high = bounds(ball)
    # As many digits as the bound leaves, one more so that the printed decimal adds little, and the distance from that
    # decimal to the farther end, rounded up.
    middle, radius = (low + high) / 2, (high - low) / 2
    known = next((d for d in range(1, digits) if radius * 10 ** (d + 1) >= abs(middle)), digits)
    text = directed_decimal(middle, known + 1, -1)
    far = max(abs(high - decimal_fraction(text)), abs(decimal_fraction(text) - low))
    return text, directed_decimal(far, 2, 1)
