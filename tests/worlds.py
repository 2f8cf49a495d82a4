"""One list of laws, starts and units: what a property of answers is asked of, each with what it may break.

>>> WORLDS["a start in motion"].words
'--law 2:1/10 --mass 1 --v0 1/3'
>>> WORLDS["SI"].oscillator.x0
ExactReal('1/5')
"""

import shlex
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

from asymptotics.law import Oscillator

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

    @property
    def words(self) -> str:
        """The same in words of the shell."""
        shapes = {",".join(map(str, a)) if isinstance(a, tuple) else str(a): e for a, e in self.law.items()}
        words = [f"--law {shlex.quote(f'{a}:{e}')}" for a, e in shapes.items()]
        springs = {"pendulum": ""} if self.spring == "pendulum" else self.spring or {}
        words += [f"--spring {p}:{c}" if c else f"--spring {p}" for p, c in springs.items()]
        return " ".join([*words, *(f"--{name} {value}" for name, value in self.units.items())])


WORLDS = {
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
DECAYING = [name for name in WORLDS if not name.startswith("gains")]
OSCILLATOR = WORLDS["SI"].oscillator
"""The one that is taken where one with units is enough."""
