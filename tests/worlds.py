"""One list of laws, starts and units: what a property is asked of, each with what it may break.

``EVERYDAY`` is for what holds of every answer, the other groups for a room of the engine; ``worlds_of`` picks by name.

>>> WORLDS["a start in motion"].words
'--law 2:1/10 --mass 1 --v0 1/3'
>>> WORLDS["SI"].oscillator.x0
ExactReal('1/5')
>>> worlds_of("dry friction", "a sum of powers")["a sum of powers"].pairs
(('1', '1/20'), ('2', '1/10'))
"""

import shlex
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import pytest

from asymptotics.law import Law, Oscillator

Exponent = int | str | tuple[int, int]


@dataclass(frozen=True)
class World:
    """A law with its springs, its start and its units; ``breaks``: what fails in it first when something is wrong."""

    law: dict[Exponent, str]
    breaks: str
    spring: dict[int, str] | str | None = None
    units: dict[str, Any] = field(default_factory=dict)

    @cached_property
    def oscillator(self) -> Oscillator:
        """The same as an oscillator."""
        return Oscillator(self.law, spring=self.spring, **self.units)

    @cached_property
    def dimensionless(self) -> Law:
        """The law alone, with its springs; of units there are none."""
        return Law(self.law, spring=self.spring)

    @property
    def pairs(self) -> tuple[tuple[str, str], ...]:
        """(exponent, strength) of losses in the speed alone, as texts."""
        return tuple((str(a), e) for a, e in self.law.items())

    @property
    def words(self) -> str:
        """The same in words of the shell."""
        shapes = {",".join(map(str, a)) if isinstance(a, tuple) else str(a): e for a, e in self.law.items()}
        words = [f"--law {shlex.quote(f'{a}:{e}')}" for a, e in shapes.items()]
        springs = {"pendulum": ""} if self.spring == "pendulum" else self.spring or {}
        words += [f"--spring {p}:{c}" if c else f"--spring {p}" for p, c in springs.items()]
        return " ".join([*words, *(f"--{name} {value}" for name, value in self.units.items())])


EVERYDAY = {
    "dry friction": World({0: "3/100"}, "it stops; the force jumps; no series in the strength, no period"),
    "linear": World({1: "1/10"}, "no amplitude in the answer: a power of 0, a division by alpha - 1"),
    "quadratic": World({2: "1/10"}, "closed forms and Lambert's W take the place of the general route"),
    "another rational power": World({"3/2": "1/10"}, "no Taylor series at rest: powers of roots, no closed form"),
    "an irrational power": World({"sqrt(2)": "1/10"}, "no exact exponent: whatever rounds it, or asks for a fraction"),
    "below the linear one": World({"1/2": "1/10"}, "extinct in finite time; an infinite slope at rest"),
    "cubic": World({3: "1/10"}, "exact rational coefficients; the slowest decay"),
    "strong": World({2: "3"}, "overshoots nothing: the first half-swing is most of the motion"),
    "a sum of powers": World({1: "1/20", 2: "1/10"}, "cross terms: what treats the laws one by one is wrong by them"),
    "a sum with dry friction": World({0: "1/50", 2: "1/10"}, "both routes' ends: a stop, and a start where air rules"),
    "a start in motion": World({2: "1/10"}, "a phase at the start; turning point 0 is not the start",
                               units={"mass": "1", "v0": "1/3"}),
    "SI": World({"3/2": "1/10"}, "three units and a strength of roots: what forgets a factor, or rounds one",
                units={"mass": "3/2", "stiffness": "30", "x0": "1/5"}),
    "air and a spring x^3": World({2: "1/10"}, "no closed energy; the period depends on the amplitude", {3: "1/10"}),
    "a pendulum in air": World({2: "1/10"}, "all powers of the spring at once, and radians", "pendulum"),
    "a loss that knows the place": World({(1, 2): "1/10"}, "a loss is no function of the speed alone"),
    "gains": World({2: "-1/10"}, "it grows: refused where a decay is what is promised"),
    "gains and losses": World({1: "-1", (1, 2): "1"}, "it tends to a cycle, and to rest from nowhere"),
}  # fmt: skip
POWERS = {  # losses in the speed alone, for the local expansions, the steps and the return map
    "next to no loss": World({3: "1e-300"}, "nothing draws motions together: a division by the loss, or its logarithm"),
    "as strong as the spring": World({2: "1"}, "no strength that is small: each bound is used to its end"),
    "a strong power between": World({"3/2": "5"}, "most of the half-swing is spent near rest: powers of roots there"),
    "a strong root": World({"1/2": "1/2"}, "the force rises at once: the piece at rest is short"),
    "a weak root": World({"1/2": "1/100"}, "delta grows as the amplitude falls: no map from 0"),
    "a root beside a cube": World({"1/2": "1/20", 3: "1/5"}, "one law rules near rest, the other where it is fast"),
    "a strong cube": World({3: "2"}, "steep where it is fast, nothing where it is slow"),
    "a steep power": World({40: "1/10"}, "a radius of convergence that the speed alone decides"),
    "next to dry friction": World({"1/100": "1/3"}, "nearly a jump of the force at rest; exponents by hundredths"),
    "weak dry friction": World({0: "1/1000"}, "hundreds of half-swings, each the same: errors that add"),
    "a loss next to the critical one": World({1: "3/2"}, "one half-swing takes nearly everything"),
    "dry friction beside a cube": World({0: "1/30", 3: "1"}, "a stop, and a loss that is nothing where it stops"),
    "dry friction beside a root": World({0: "1/50", "1/2": "1/10"}, "two forces that both are there at rest"),
    "dry friction beside the linear loss": World({0: "1/20", 1: "1/10"}, "a closed motion that ends"),
    "dry friction and nearly critical": World({0: "1/50", 1: "3/2"}, "it stops before it would turn again"),
    "dry friction beside three halves": World({0: "1/20", "3/2": "1/10"}, "a jump of the force beside powers of roots"),
    "three weak powers": World({0: "1/500", 1: "1/50", 2: "1/10"}, "each rules at an amplitude of its own"),
    "two powers above one": World({2: "1/10", 3: "1/30"}, "two strengths that fall at different rates"),
    "a strong sum": World({"5/2": "3", 1: "1/2"}, "the larger strength at the larger power, in halves"),
    "a sum with an irrational power": World({"sqrt(2)": "1/20", 2: "1/20"}, "two exponents that no fraction joins"),
    "a strong sum with a root of two": World({"sqrt(2)": "1/3", 2: "1/2"}, "the same where strengths are not small"),
    "three powers without a common one": World({"1/2": "1/10", "sqrt(3)": "1/10", "7/3": "1/3"}, "many monomials"),
}
CREEPING = {  # from a start of size 1 they come to rest on a slow curve, without a turning point
    "a root": World({"1/2": "1"}, "the slow curve in whole powers: logarithms beside them"),
    "a tenth": World({"1/10": "3"}, "so stiff that an explicit step has no length"),
    "an irrational root": World({"sqrt(1/2)": "2"}, "no common denominator of the powers of the slow curve"),
    "a hundredth": World({"1/100": "1"}, "the curve is left and met within one part in e^100"),
    "four fifths": World({"4/5": "5"}, "so near the linear law that the curve is met late"),
    "a tenth beside three halves": World({"1/10": "3", "3/2": "1/5"}, "a law that rules far away alone"),
    "a root beside the linear one": World({"1/2": "1", 1: "1"}, "the second law changes the curve at every order"),
    "friction beside two powers": World({0: "1/5", "1/3": "1", "sqrt(5)": "2"}, "it stops on the way down the curve"),
}
NEAR_EQUAL = {  # two exponents of which the difference is no number to divide by
    "a root twice": World({"1/2": "1", "0.5000000000000000001": "1"}, "1e-19 taken for 0, or divided by"),
    "a root and a little more": World({"1/2": "1", "0.51": "1"}, "a difference neither small nor large"),
    "a third twice beside a square": World({"1/3": "1", "0.34": "2", 2: "1/4"}, "a third law that takes no part"),
    "irrational and nearly equal": World({"sqrt(1/2)": "1", "sqrt(0.501)": "2"}, "a difference that is no fraction"),
    "a root and a larger one": World({"1/2": "2", "0.55": "1"}, "the barriers far apart: the widest that is served"),
    "on both sides of 1": World({"0.9999999999": "2", "1.0000000001": "2"}, "a creep on one side, none on the other"),
    "1 and a little less": World({1: "2", "0.99999999999999999999": "3"}, "the linear law within 1e-20"),
    "a root twice beside 1": World({"1/2": "3", "0.500000001": "2", 1: "1"}, "a third law that changes the curve"),
}
WELLS = {  # springs that are not linear: no closed energy, a period that depends on the amplitude
    "a pendulum without loss": World({2: "0"}, "nothing draws motions together; an edge of the well", "pendulum"),
    "a pendulum of three halves": World({"3/2": "1/10"}, "powers of roots beside a sine", "pendulum"),
    "a hard spring": World({2: "1/3"}, "the force grows faster than the place", {3: "1/2"}),
    "a soft spring": World({"sqrt(2)": "1/10"}, "an edge of the well, and no fraction", {3: "-1/4"}),
    "a kinked spring": World({(1, 1): "1/3", "1/2": "1/9"}, "x|x|, and a loss that knows the place", {2: "1/4"}),
    "friction in a steep spring": World({0: "1/20", (0, 2): "1/30", 3: "1/5"}, "a jump that knows the place", {5: "2"}),
    "air and friction in a hard spring": World({2: "1/10", 0: "1/50"}, "both losses that have a primitive", {3: "1/2"}),
    "friction in a soft spring": World({0: "1/20"}, "it stops off centre, in a well with an edge", {3: "-1/2"}),
    "a loss in a soft kinked spring": World({1: "1/10"}, "x|x| that softens", {2: "-1/4"}),
    "air in a kinked spring": World({2: "1/3"}, "x|x|: two pieces that meet at 0", {2: "1/4"}),
}
WORLDS = EVERYDAY | POWERS | CREEPING | NEAR_EQUAL | WELLS
DECAYING = [name for name in EVERYDAY if not name.startswith("gains")]
STARTS = {  # (x, v), each with what it may break
    "from rest": ("1", "0"),  # a turning point at once
    "outwards": ("0.75", "0.25"),  # a turning point after the start
    "beyond the middle": ("-0.25", "0.5"),  # a place of the other sign
    "from the middle": ("0", "1"),  # no place to divide by
    "nearly at rest": ("0.5", "0.001"),  # a speed that a bound takes for none
}
RIVALS = ["1", "2", "1+2", "0+1"]
"""The laws that ``identify`` chooses from where four are enough: three true ones and a sum that contains one."""
OSCILLATOR = WORLDS["SI"].oscillator
"""The one that is taken where one with units is enough."""


def worlds_of(*names: str) -> dict[str, World]:
    """These worlds, by name, in this order."""
    return {name: WORLDS[name] for name in names}


def pairs_of(*names: str) -> list[Any]:
    """Their losses as pairs, for ``parametrize``, each under its name."""
    return [pytest.param(WORLDS[name].pairs, id=name) for name in names]
