"""The forces of the flow's tests: linear spring and others, each with what a bound may go wrong about."""

from dataclasses import dataclass
from fractions import Fraction

from flint import arb, ctx

from asymptotics.flow.damping import Damping
from asymptotics.flow.force import Force
from asymptotics.flow.wells.force import WellForce
from asymptotics.law import Law
from asymptotics.numbers.exact import ExactReal, parse_real
from tests.worlds import WORLDS

LINEAR = {  # short names of worlds
    "free": "next to no loss", "linear": "linear", "dry": "dry friction beside three halves", "sum": "a strong sum",
    "irrational": "a strong sum with a root of two", "root": "a strong root", "steep": "a steep power",
}  # fmt: skip
OTHERS = {
    "free pendulum": "a pendulum without loss", "pendulum": "a pendulum of three halves", "duffing": "a hard spring",
    "soft, sqrt(2)": "a soft spring", "place": "a kinked spring", "dry beside springs": "friction in a steep spring",
}  # fmt: skip


def beside_the_linear_spring(losses, bits: int = 250) -> Damping:
    """Powers of the velocity alone."""
    with ctx.workprec(bits):
        return Damping.of_law(Law(losses))


def in_a_well(losses, spring=None, bits: int = 250) -> WellForce:
    """Any losses, any springs: what is handled as a well also where the spring is linear."""
    with ctx.workprec(bits):
        return WellForce.of(Law(losses, spring=spring).terms)


def damping_of(*pairs):
    """From (exponent, strength) in texts, at 300 bits."""
    with ctx.workprec(300):
        return Damping.of([(parse_real(e, "e").ball(), parse_real(a, "a")) for a, e in pairs])


def by_strength(*terms):
    """From (strength, exponent) in texts, at the working precision."""
    return Damping.of([(ExactReal(Fraction(e)).ball(), ExactReal(Fraction(a))) for e, a in terms])


NOTHING = WORLDS["next to no loss"].pairs
FREE = in_a_well({2: 0})
WELLS = {name: in_a_well(WORLDS[world].law, WORLDS[world].spring) for name, world in OTHERS.items()}
FORCES: dict[str, Force] = {name: beside_the_linear_spring(WORLDS[world].law) for name, world in LINEAR.items()} | WELLS


@dataclass(frozen=True)
class Steep:
    """strongest = |u|^20 at the farthest place; rest = 0.3 - u."""

    def strongest(self, u, _w):
        return arb(abs(u).upper()) ** 20

    def restoring(self, u):
        return arb("0.3") - u
