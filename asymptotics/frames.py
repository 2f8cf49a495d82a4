"""The frame in which places and times are told: their units, or none.

A law alone is the oscillator with m = k = x0 = 1: its places are in units of x0, its time is tau = omega_0 t.

>>> BARE.time, BARE.named("x"), frame_of(Oscillator({2: 1}, mass=2)).named("t")
('tau', 'x', 't [s]')
"""

from dataclasses import dataclass

from asymptotics.law import Oscillator
from asymptotics.present.shown import Page, Shown


@dataclass(frozen=True, repr=False)
class Frame(Shown):
    """The units of x and of t; both empty: x in units of x0 (or of the strengths), and tau = omega_0 t."""

    x: str = ""
    t: str = ""

    def _page(self) -> Page:
        return Page(f"x in {self.x or 'units of x0'}, {self.time} in {self.t or '1/omega_0'}")

    @property
    def time(self) -> str:
        """What the time is called."""
        return "t" if self.t else "tau"

    def unit(self, name: str) -> str:
        """The unit of x, t or tau."""
        return self.x if name == "x" else self.t

    def named(self, name: str) -> str:
        """A column with its unit."""
        return f"{name} [{unit}]" if (unit := self.unit(name)) else name

    def told(self, name: str, value: str) -> str:
        """A value with its unit."""
        return f"{value} {unit}" if (unit := self.unit(name)) else value

    def latex(self, name: str, value: str) -> str:
        """The same as LaTeX."""
        return rf"{value}\,\mathrm{{{unit}}}" if (unit := self.unit(name)) else value


BARE = Frame()


def frame_of(oscillator: Oscillator | None) -> Frame:
    """m and s (rad of a pendulum) of an oscillator, ``BARE`` of a law alone."""
    return BARE if oscillator is None else Frame(oscillator.unit, "s")
