"""The strengths of an oscillator in SI under the names of other tools, each with its definition.

    ITTC, Himeno    phi'' + 2 alpha phi' + beta phi'|phi'| + gamma phi'^3 + omega_0^2 phi = 0
    extinction      phi_n - phi_(n+1) = a phi_m + b phi_m^2 + c phi_m^3 a half-swing (rad), first order at phi_m
    IMO, Bertin     N(phi_m) = (phi_n - phi_(n+1))/phi_m^2 in 1/deg: N10 at 10 degrees, N20 at 20
    OpenFAST        AddBLin, AddBQuad: force -AddBLin v - AddBQuad v|v|      (OrcaFlex: linear and quadratic damping)
    dampers         C, alpha: force C v|v|^(alpha-1)

Beside the linear spring a half-swing takes pi zeta phi_m (derivation ``equivalent-damping``): a = pi alpha/omega_0,
b = 4 beta/3, c = 3 pi omega_0 gamma/8.

>>> from asymptotics.law import Oscillator
>>> found = conversions(Oscillator({1: "1/5", 2: "1/2"}, mass=2, stiffness=8), 6)
>>> [(c.name, c.value, c.unit) for c in found][:5]
[('alpha', '0.0500000', '1/s'), ('beta', '0.250000', '1/rad'), ('a', '0.0785398', ''), ('b', '0.333333', '1/rad'), ...]
>>> found[4].name, found[4].value, found[4].unit
('N10', '0.0136717', '1/deg')
"""

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb

from asymptotics.frames import frame_of
from asymptotics.law import Oscillator
from asymptotics.numbers.decimals import certified_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.present.shown import Page, Shown
from asymptotics.terms import Term

_ROLL = {1: ("alpha", "1/s", "B_1/(2 m)"), 2: ("beta", "1/rad", "B_2/m"), 3: ("gamma", "s/rad^2", "B_3/m")}
_EXTINCTION = {
    1: ("a", "", "pi alpha/omega_0"),
    2: ("b", "1/rad", "4 beta/3"),
    3: ("c", "1/rad^2", "3 pi omega_0 gamma/8"),
}
_ADDED = {1: ("AddBLin", "N m s or N s/m"), 2: ("AddBQuad", "N m s^2 or N s^2/m^2")}


@dataclass(frozen=True, repr=False)
class Conversion(Shown):
    """One coefficient: its name in ``source``, certified digits, unit and definition."""

    source: str
    name: str
    value: str
    unit: str
    definition: str

    def to_dict(self) -> dict[str, str]:
        """JSON-ready."""
        return {name: getattr(self, name) for name in ("source", "name", "value", "unit", "definition")}

    def __str__(self) -> str:
        return f"{self.name} = {self.value} {self.unit}".rstrip() + f"  ({self.source}: {self.definition}; certified)"

    def _page(self) -> Page:
        return Page(str(self))


def conversions(oscillator: Oscillator, digits: int) -> tuple[Conversion, ...]:
    """What its losses are called elsewhere; roll coefficients where all exponents are 1, 2 or 3 beside any spring."""
    losses = [t for t in oscillator.law.losses if t.is_power_of_velocity and not t.b.is_zero]
    found: list[Conversion] = []
    # Equal exponents were merged when the law was made: one term for each.
    orders = {int(t.velocity.rational): t for t in losses if t.velocity.is_integer and 1 <= t.velocity <= 3}
    if len(orders) == len(losses) == len([t for t in oscillator.law.losses if not t.b.is_zero]) and orders:
        found += _roll(oscillator, orders, digits)
    found += [
        Conversion("OpenFAST, OrcaFlex", *_ADDED[n][:1], _exact(t.b, digits), _ADDED[n][1], f"b of {t.shape()}")
        for n, t in sorted(orders.items())
        if n in _ADDED
    ]
    frame = frame_of(oscillator)
    for t in losses:
        definition = f"{'torque' if frame.x == 'rad' else 'force'} C v|v|^(alpha-1), alpha = {t.velocity}"
        unit = frame.unit_of_loss(t.velocity)
        found.append(Conversion("power-law damper", "C", _exact(t.b, digits), unit, definition))
    return tuple(found)


def _exact(b: ExactReal, digits: int) -> str:
    return certified_decimal(lambda: b, digits)


def _roll(oscillator: Oscillator, orders: dict[int, Term], digits: int) -> list[Conversion]:
    def rate(n: int) -> arb:
        """The coefficients alpha, beta, gamma of the moment by its power of the rate."""
        return orders[n].b.ball() / oscillator.mass.ball() / (2 if n == 1 else 1)

    def share(n: int) -> arb:
        """The coefficients a, b, c of the extinction curve by its power of the angle."""
        omega = oscillator.omega_0()
        factor = {1: arb.pi() / omega, 2: arb(4) / 3, 3: 3 * arb.pi() * omega / 8}[n]
        return rate(n) * factor

    def bertin(degrees: int) -> arb:
        degree = arb.pi() / 180
        # a phi + b phi^2 + c phi^3 over phi^2: in 1/rad, and by ``degree`` once more in 1/deg.
        angle = degrees * degree
        return sum((share(n) * angle ** (n - 2) for n in orders), arb(0)) * degree

    def made(source: str, row: tuple[str, str, str], value: Callable[[], arb]) -> Conversion:
        return Conversion(source, row[0], certified_decimal(value, digits), row[1], row[2])

    roll = [made("ITTC", _ROLL[n], lambda n=n: rate(n)) for n in sorted(orders)]  # type: ignore[misc]
    lost = [made("extinction curve", _EXTINCTION[n], lambda n=n: share(n)) for n in sorted(orders)]  # type: ignore[misc]
    if any(not t.b.is_zero for t in oscillator.law.springs):
        return roll  # the extinction curve is that of the linear spring
    told = "(a phi + b phi^2 + c phi^3)/phi^2 in degrees at {} deg"
    imo = [made("IMO", (f"N{d}", "1/deg", told.format(d)), lambda d=d: bertin(d)) for d in (10, 20)]  # type: ignore[misc]
    return [*roll, *lost, *imo]
