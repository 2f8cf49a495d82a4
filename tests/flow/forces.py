"""The forces of the flow's tests: linear spring and others, each with what a bound may go wrong about."""

from dataclasses import dataclass
from fractions import Fraction

from flint import arb, ctx

from asymptotics.flow.damping import Damping
from asymptotics.flow.force import Force
from asymptotics.flow.wells.force import WellForce
from asymptotics.law import Law
from asymptotics.numbers.exact import ExactReal, parse_real

LINEAR = {
    "free": {2: "1e-300"},
    "linear": {1: "1/5"},
    "dry": {0: "1/20", "3/2": "1/10"},
    "sum": {"5/2": 3, 1: "1/2"},
    "irrational": {"sqrt(2)": "1/3", 2: "1/2"},
    "root": {"1/2": "1/2"},
    "steep": {40: "1/10"},
}
OTHERS = {
    "free pendulum": ({2: 0}, "pendulum"),
    "pendulum": ({"3/2": "1/10"}, "pendulum"),
    "duffing": ({2: "1/3"}, {3: "1/2"}),
    "soft, sqrt(2)": ({"sqrt(2)": "1/10"}, {3: "-1/4"}),
    "place": ({(1, 1): "1/3", "1/2": "1/9"}, {2: "1/4"}),
    "dry beside springs": ({0: "1/20", (0, 2): "1/30", 3: "1/5"}, {5: 2}),
}


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


NOTHING = (("3", "1e-300"),)
FREE = in_a_well({2: 0})
WELLS = {name: in_a_well(*given) for name, given in OTHERS.items()}
FORCES: dict[str, Force] = {name: beside_the_linear_spring(losses) for name, losses in LINEAR.items()} | WELLS


@dataclass(frozen=True)
class Steep:
    """strongest = |u|^20 at the farthest place; rest = 0.3 - u."""

    def strongest(self, u, _w):
        return arb(abs(u).upper()) ** 20

    def restoring(self, u):
        return arb("0.3") - u
