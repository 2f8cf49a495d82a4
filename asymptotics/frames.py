"""The frame in which places, speeds and times are told: their units, or none.

A law alone is the oscillator with m = k = x0 = 1: its places are in units of x0, its time is tau = omega_0 t.

>>> BARE.time, BARE.named("x"), frame_of(Oscillator({2: 1}, mass=2)).named("t")
('tau', 'x', 't [s]')
"""

from dataclasses import dataclass

from asymptotics.errors import InputError, shown
from asymptotics.law import Oscillator
from asymptotics.present.shown import Page, Shown

_TIMES = ("t", "time", "period", "extinction")
STRENGTHS = "units of the strengths"
"""What x counts where the start is no unit, and the strengths have a length of their own."""


@dataclass(frozen=True, repr=False)
class Frame(Shown):
    """The units of x and of t; both empty: x in units of x0 (or of the strengths), and tau = omega_0 t.

    Without that of t there are no units, but x is told in ``x``: the radian, or the length of the strengths.
    """

    x: str = ""
    t: str = ""

    def _page(self) -> Page:
        return Page(f"x in {self.x or 'units of x0'}, {self.time} in {self.t or '1/omega_0'}")

    def __bool__(self) -> bool:
        """Whether there are units."""
        return bool(self.t)

    @property
    def time(self) -> str:
        """What the time is called."""
        return "t" if self.t else "tau"

    @property
    def units(self) -> str | None:
        """What JSON says of them: SI, or nothing."""
        return "SI" if self.t else None

    def unit(self, name: str) -> str:
        """The unit of a quantity by its name: times, v, the phase; every other one is a place.

        >>> frame = Frame("m", "s")
        >>> [frame.unit(name) for name in ("t", "v", "phase", "amplitude")]
        ['s', 'm/s', 'rad', 'm']
        >>> [Frame("rad").unit(name) for name in ("tau", "v", "amplitude")]
        ['', '', 'rad']
        """
        if not self.t:
            return self.x if name in ("x", "amplitude") else ""
        return self.t if name in _TIMES else {"v": f"{self.x}/{self.t}", "phase": "rad"}.get(name, self.x)

    def unit_of_loss(self, alpha: object) -> str:
        """The unit of b in b v|v|^(alpha-1), a force or, of angles, a torque; none of a law alone.

        >>> Frame("m", "s").unit_of_loss("3/2"), Frame("rad", "s").unit_of_loss("1"), BARE.unit_of_loss("1")
        ('N (s/m)^3/2', 'N m s', '')
        """
        if not self.t:
            return ""
        turning = self.x != "m"
        force, plain = ("N m", "N m s") if turning else ("N", f"N {self.t}/m")
        power = f"{force} ({self.t}/{'rad' if turning else 'm'})^{alpha}"
        return {"0": force, "1": plain}.get(str(alpha), power)

    def named(self, name: str) -> str:
        """A column with its unit; the time by the name that it has here."""
        name = self.time if name == "t" else name
        return f"{name} [{unit}]" if (unit := self.unit(name)) else name

    def axis(self, name: str) -> str:
        """An axis with its unit."""
        if name == "t" and not self.t:
            return r"$\tau = \omega_0 t$"
        return f"{name} ({unit})" if (unit := self.unit(name)) else name

    def with_unit(self, name: str, value: object) -> str:
        """A value with its unit."""
        return f"{value} {unit}" if (unit := self.unit(name)) else f"{value}"

    def time_text(self, value: object) -> str:
        """A time in a sentence.

        >>> Frame("m", "s").time_text(2), BARE.time_text(2)
        ('2 s', 'tau = 2')
        """
        return f"{value} {self.t}" if self.t else f"tau = {value}"

    def latex(self, name: str, value: str) -> str:
        """The same as LaTeX."""
        if self.unit(name) == STRENGTHS:
            return rf"{value}\ \text{{{STRENGTHS}}}"
        return rf"{value}\,\mathrm{{{unit}}}" if (unit := self.unit(name)) else value

    @property
    def in_words(self) -> str:
        """The units in a line."""
        return f"SI: x in {self.x}, t in {self.t}" if self.t else "no units: m = k = x0 = 1"


BARE = Frame()


def require_frame(value: object) -> Frame:
    """``value`` if it is a frame; InputError otherwise."""
    if not isinstance(value, Frame):
        raise InputError("frame", f"{shown(value)} is no frame", "a Frame")
    return value


def frame_of(oscillator: Oscillator | None) -> Frame:
    """m and s (rad of a pendulum) of an oscillator, ``BARE`` of a law alone."""
    return BARE if oscillator is None else Frame(oscillator.unit, "s")


def started_frame(x_unit: str) -> Frame:
    """The frame of places in ``x_unit``: m or rad beside s, or x0, rad, strengths without units.

    >>> started_frame("rad").named("x"), started_frame("rad").named("t"), started_frame("x0") == BARE
    ('x [rad]', 'tau', True)
    """
    return Frame({"rad": "rad", "strengths": STRENGTHS}.get(x_unit, ""))
