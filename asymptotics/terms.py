"""One force of the oscillator, homogeneous and odd under (x, v) -> (-x, -v): a loss or a spring.

    loss      b |x|^m v|v|^(alpha-1)      odd in v,   degree m + alpha
    spring    c x|x|^(p-1) |v|^q          even in v,  degree p + q

The weight degree - 1 is the power of the amplitude in the local strength delta = epsilon A^weight, and the sign (-1 for
a loss, +1 for a spring) is what reversal of time does to the strength.

A strength is an exact number (``ExactReal``) or, where units were taken off, ``Scaled``: both have ``ball()`` (an
enclosure at the working precision), ``sign``, ``is_zero`` and a text.

>>> air, stiffer = Term("1/10", 2), Term("1/3", 0, 3, "position")
>>> print(air, "and", stiffer)
1/10 x'|x'| and 1/3 x^3
>>> (str(air.weight), air.sign), (str(stiffer.weight), stiffer.sign)
(('1', -1), ('2', 1))
"""

import re
from dataclasses import dataclass, replace
from typing import Literal

from flint import arb

from asymptotics.errors import InputError, shown
from asymptotics.numbers.context import inside
from asymptotics.numbers.exact import REAL_FORMS, ExactReal
from asymptotics.numbers.latex import latex
from asymptotics.numbers.policy import Number, exact_integer, exact_number
from asymptotics.numbers.powers import exact_power
from asymptotics.present.shown import Page, Shown

# A limit of size, for exact algebras and integrals grow with the powers; no bound rests on it.
MAX_POSITION = 100


def terms_of(text: str, argument: str) -> list[str]:
    """The terms of a law without strengths, joined by +: exponents, and A,M: for |x|^M v|v|^(A-1) as ``--law A,M:E``.

    InputError, with the new spelling, for the old one: sums joined by commas, AxM.

    >>> terms_of("0+1,2:", "laws")
    ['0', '1,2:']
    >>> terms_of("1,2", "laws")
    Traceback (most recent call last):
        ...
    asymptotics.errors.InputError: argument laws: '1,2' is the old spelling of a sum (accepted: 1+2, or 1,2: for ...
    """
    parts = [part.strip() for part in text.split("+")]
    # What is not the old spelling goes on unread: the caller parses exponents.
    for part in parts:
        # The old spelling had commas between terms and an x before
        # the power of the place: both are translated for the message.
        new = "+".join(re.sub(r"^(.+)x(\d+)$", r"\1,\2:", piece.strip()) for piece in part.split(","))
        if "," in part and ":" not in part:
            accepted = f"{new}, or {part}: for |x|^M v|v|^(A-1) with A,M as in --law A,M:E"
            raise InputError(argument, f"{part[:40]!r} is the old spelling of a sum", accepted)
        if new != part and ":" not in part:
            raise InputError(argument, f"{part[:40]!r} is the old spelling of |x|^M v|v|^(A-1)", new)
    return parts


@dataclass(frozen=True)
class Units:
    """The numbers that set the units of length and time: m, k and the start (x0, v0)."""

    mass: ExactReal
    stiffness: ExactReal
    x0: ExactReal
    v0: ExactReal

    def omega_0(self) -> arb:
        """sqrt(k/m) in rad/s, as a ball."""
        return (self.stiffness.ball() / self.mass.ball()).sqrt()

    def length(self) -> arb:
        """|x0| when v0 = 0, else the radius sqrt(x0^2 + m v0^2/k) of the start, in m, as a ball."""
        # Exact where it can be: the root of a square would be a ball around x0.
        if self.v0.is_zero:
            return abs(self.x0.ball())
        return (self.x0.ball() ** 2 + (self.v0.ball() / self.omega_0()) ** 2).sqrt()

    def without(self, term: "Term") -> "Term":
        """A term in SI in the units of this start: its strength made dimensionless.

        The strength of a named spring counts the square of the unit of length, so k and m do not enter it.
        """
        # Made dimensionless already: of ``law.of_unit_start``, where b is epsilon.
        if isinstance(term.strength, Scaled):
            return term
        b = term.b * self.stiffness if term.family else term.b
        return replace(term, strength=self.scale(b, term.velocity, term.weight))

    def scale(self, b: ExactReal, velocity: ExactReal, weight: ExactReal) -> "ExactReal | Scaled":
        """epsilon = b omega_0^velocity length^weight / k, as an exact number when it is one."""
        scaled = Scaled(b, velocity, weight, self)
        # omega_0^velocity = (k/m)^(velocity/2): exact where that is a rational times one root.
        time = exact_power(self.stiffness / self.mass, velocity / 2)
        try:
            area = self.x0**2 + self.mass * self.v0**2 / self.stiffness
        except InputError:  # a sum of two different roots
            return scaled
        size = exact_power(abs(self.x0), weight) if self.v0.is_zero else exact_power(area, weight / 2)
        return scaled if time is None or size is None else b * time * size / self.stiffness


@dataclass(frozen=True)
class Scaled:
    """The dimensionless strength epsilon = b omega_0^velocity length^weight / k of a physical strength b."""

    b: ExactReal
    velocity: ExactReal
    weight: ExactReal
    units: Units

    @property
    def sign(self) -> int:
        """-1, 0 or 1."""
        return self.b.sign

    @property
    def is_zero(self) -> bool:
        """Whether the strength is 0."""
        return self.b.is_zero

    @property
    def is_rational(self) -> bool:
        """False: what is known to be rational is an ExactReal."""
        return False

    def ball(self) -> arb:
        """An enclosure at the current working precision."""
        time = _power(self.units.omega_0(), self.velocity)
        # Nothing is kept: each factor is made at the precision in force.
        return self.b.ball() * time * _power(self.units.length(), self.weight) / self.units.stiffness.ball()

    def __str__(self) -> str:
        u, (velocity, weight) = self.units, (_atom(self.velocity / 2), _atom(self.weight))
        length = str(abs(u.x0)) if u.v0.is_zero else f"sqrt(({u.x0})**2 + ({u.mass})*({u.v0})**2/({u.stiffness}))"
        return f"{_atom(self.b)}*{_atom(u.stiffness / u.mass)}**{velocity}*({length})**{weight}/{_atom(u.stiffness)}"


Strength = ExactReal | Scaled
MAX_EXPONENT = 1000


@dataclass(frozen=True, init=False, repr=False)
class Term(Shown):
    """One force: strength |x|^position v|v|^(velocity-1), or strength x|x|^(position-1) |v|^velocity (a spring).

    ``velocity`` is alpha >= 0 of a loss or q >= 0 of a spring, ``position`` the integer m >= 0 or p >= 1.  The strength
    is b in SI (N (s/m)^alpha / m^m) or epsilon where m = k = x0 = 1.  ``family`` names a spring that is a series in the
    square of its strength's unit: "pendulum" is sin x in place of x, whose first term -x^3/6 gives the weight 2.
    InputError for a number that is not exact, a negative exponent, or a position that is not such an integer.
    """

    strength: Strength
    velocity: ExactReal
    position: int
    odd_in: Literal["velocity", "position"]
    family: Literal["", "pendulum"]

    def __init__(
        self, strength: Number | Scaled, velocity: Number, position: Number = 0,
        odd_in: Literal["velocity", "position"] = "velocity", family: Literal["", "pendulum"] = "",
    ) -> None:  # fmt: skip
        if odd_in not in ("velocity", "position"):
            raise InputError("odd_in", f"{odd_in!r:.40} is neither", "velocity (a loss) or position (a spring)")
        loss = odd_in == "velocity"
        name = "alpha" if loss else "spring"
        exponent = exact_number(velocity, name)
        if exponent < 0:
            raise InputError(name, f"{exponent} is negative", f"an exponent >= 0: {REAL_FORMS}")
        if exponent > MAX_EXPONENT:
            raise InputError(name, f"{exponent} is out of range", f"an exponent from 0 to {MAX_EXPONENT}: {REAL_FORMS}")
        place = exact_integer(position, "position" if loss else "spring", 0 if loss else 1, MAX_POSITION)
        made = strength if isinstance(strength, Scaled) else exact_number(strength, "strength")
        fields = {"strength": made, "velocity": exponent, "position": place, "odd_in": odd_in, "family": family}
        for field, value in fields.items():
            object.__setattr__(self, field, value)

    @property
    def b(self) -> ExactReal:
        """The strength of a term in SI, an exact number; InputError when units were taken off."""
        if isinstance(self.strength, Scaled):
            raise InputError("law", f"{self.strength} is a dimensionless strength", "b in SI")
        return self.strength

    @property
    def degree(self) -> ExactReal:
        """velocity + position: how the force scales with the amplitude."""
        return self.velocity + self.position

    @property
    def weight(self) -> ExactReal:
        """degree - 1: delta = strength A^weight."""
        return self.degree - 1

    @property
    def sign(self) -> int:
        """-1 for a loss, +1 for a spring: what t -> -t does to the strength."""
        return -1 if self.odd_in == "velocity" else 1

    @property
    def key(self) -> tuple[ExactReal, int, str, str]:
        """What distinguishes two terms of a law."""
        return self.velocity, self.position, self.odd_in, self.family

    @property
    def is_power_of_velocity(self) -> bool:
        """Whether the term is b v|v|^(alpha-1), with no other factor."""
        return self.sign < 0 and self.position == 0

    def __str__(self) -> str:
        text = str(self.strength)
        return {"1": "", "-1": "-"}.get(text, f"{text} ") + self.shape()

    def shape(self) -> str:
        """The force without its strength, as text."""
        if self.family:
            return "(sin x - x)"
        v, p = self.velocity, self.position
        if self.sign < 0:
            place = {0: "", 1: "|x| "}.get(p, f"x^{p} " if p % 2 == 0 else f"|x|^{p} ")
            known = {"0": "sign(x')", "1": "x'", "2": "x'|x'|", "3": "x'^3"}
            return place + known.get(str(v), f"x'|x'|^({v - 1})")
        place = {1: "x", 2: "x|x|"}.get(p, f"x^{p}" if p % 2 else f"x|x|^{p - 1}")
        return place + ("" if v.is_zero else f" x'^{v}" if _is_even(v) else f" |x'|^({v})")

    def _page(self) -> Page:
        return Page(str(self), ("a spring" if self.sign > 0 else "a loss",))

    def _formula(self) -> str:
        return self.latex()

    def latex(self) -> str:
        """The term in LaTeX."""
        text = str(self.strength) if isinstance(self.strength, Scaled) else latex(self.strength)
        return {"1": "", "-1": "-"}.get(text, rf"{text}\,") + self.latex_shape()

    def latex_shape(self) -> str:
        """The force without its strength, in LaTeX."""
        if self.family:
            return r"(\sin x - x)"
        v, p = self.velocity, self.position
        if self.sign < 0:
            place = "" if not p else f"x^{{{p}}}" if p % 2 == 0 else "|x|" if p == 1 else f"|x|^{{{p}}}"
            known = {"0": r"\operatorname{sgn}\dot x", "1": r"\dot x", "2": r"\dot x|\dot x|", "3": r"\dot x^{3}"}
            other = rf"\dot x|\dot x|^{{{latex(v - 1)}}}"
            return (place + r"\," if place else "") + known.get(str(v), other)
        place = "x" if p == 1 else f"x^{{{p}}}" if p % 2 else "x|x|" if p == 2 else f"x|x|^{{{p - 1}}}"
        power = f"^{{{latex(v)}}}"
        return place + ("" if v.is_zero else rf"\,\dot x{power}" if _is_even(v) else rf"\,|\dot x|{power}")

    def plus(self, other: "Term") -> "Term":
        """The sum with ``other``, which differs in the strength; InputError when it is not one exact number."""
        if not isinstance(other, Term):
            raise InputError("other", f"{shown(other)} is no term", "a Term")
        a, b = self.strength, other.strength
        # Scaled strengths could be added as balls alone, and two pendulums are no pendulum: neither sum is one term.
        if self.family or isinstance(a, Scaled) or isinstance(b, Scaled):
            raise InputError("law", f"{self.shape()} stands in it twice", "each force once")
        try:
            return replace(self, strength=b + a)
        except InputError as error:
            raise InputError("strength", f"for equal exponents {error.reason}", "strengths that add up") from None

    @inside
    def delta(self, amplitude: arb) -> arb:
        """The local strength at ``amplitude``: strength * amplitude^weight, as a ball."""
        return self.strength.ball() * _power(amplitude, self.weight)

    def to_dict(self) -> dict[str, str | int]:
        """JSON-ready: kind, velocity, position, strength, weight (and family)."""
        names: dict[str, str | int] = {"kind": "loss" if self.sign < 0 else "spring", "velocity": str(self.velocity)}
        names |= {"position": self.position, "strength": str(self.strength), "weight": str(self.weight)}
        return names | ({"family": self.family} if self.family else {})


def signed_sum(terms: "tuple[Term, ...]", latex: bool = False) -> str:
    """The terms with their signs: ``1/10 x' - 1/6 x^3``."""
    texts = [t.latex() if latex else str(t) for t in terms]
    return texts[0] + "".join(f" - {t[1:].lstrip()}" if t.startswith("-") else f" + {t}" for t in texts[1:])


def _is_even(v: ExactReal) -> bool:
    return v.is_integer and v.rational.numerator % 2 == 0


def _power(base: arb, exponent: ExactReal) -> arb:
    """base^exponent; an integer exponent stays one, so that exact powers stay exact."""
    if exponent.is_integer:
        return base ** int(exponent.rational)
    return (base.log() * exponent.ball()).exp()


def _atom(x: ExactReal) -> str:
    """The number as a factor: in brackets unless it is a positive integer."""
    return str(x) if x.is_integer and x.sign >= 0 else f"({x})"
