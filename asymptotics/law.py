"""Laws of damping and springs, and the oscillator they act in, with units in and out.

    m x'' + k x + sum_i b_i |x|^m_i x'|x'|^(alpha_i-1) + sum_j c_j x|x|^(p_j-1) |x'|^q_j = 0

Dimensionless, with omega_0^2 = k/m, X = x/x0 and tau = omega_0 t, the strength of a term of degree d (``terms``) is

    epsilon_i = b_i omega_0^alpha_i x0^(d_i-1)/k,   delta_i = epsilon_i A^(d_i-1),   kappa_i = M_(alpha_i+1) epsilon_i.

A strength b (SI) and an epsilon are different things: a ``Law`` holds epsilons, a ``PhysicalLaw`` holds b's, an
``Oscillator`` turns one into the other, and each is refused by name where the other is meant.

alpha = 0 is Coulomb friction: x'/|x'| is the sign of x', and any value in [-1, 1] at rest (so the mass can stick).
alpha = 1 is linear: delta = epsilon for all time; under-, critically or over-damped for epsilon below, at or above 2.

>>> law = Law({"3/2": "1/10", 2: 0.2})                          # exponent -> strength
>>> print(law, law.notes)
1/10 x'|x'|^(1/2) + 1/5 x'|x'| ('strength: the float 0.2 was read as 1/5',)
>>> oscillator = Oscillator(law, mass="3/2", stiffness=30, x0="1/5")     # the same numbers, read as b in SI
>>> print(oscillator)
3/2 x'' + 30 x + 1/10 x'|x'|^(1/2) + 1/5 x'|x'| = 0, x(0) = 1/5, x'(0) = 0
>>> [e.str(10, radius=False) for e in oscillator.epsilons()]
['0.01409828351', '0.02666666667']
>>> print(Law({1: "1/10"}, spring={3: "-1/6"}))                 # Duffing, softening
1/10 x' - 1/6 x^3
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Self

from flint import arb

from asymptotics.errors import InputError, shown
from asymptotics.expansions.moments.certified import moment
from asymptotics.numbers.context import cached_property, inside
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.latex import latex
from asymptotics.numbers.policy import Number, exact_number, float_notes
from asymptotics.present.shown import Page, Shown
from asymptotics.running.signature import named
from asymptotics.terms import Scaled, Term, Units, signed_sum
from asymptotics.terms_given import FORMS, losses_of, merged, notes_of_floats, springs_of, terms_of


@dataclass(frozen=True, init=False, repr=False)
class _Sum(Shown):
    """What both kinds of law share: distinct terms, losses first, in the order given; ``notes`` of what was changed."""

    terms: tuple[Term, ...]
    notes: tuple[str, ...] = field(compare=False)

    @named
    def __init__(self, law: "Mapping[Any, Any] | _Sum", spring: "Mapping[Any, Any] | str | None" = None) -> None:
        given = law.terms if isinstance(law, _Sum) else tuple(losses_of(law))
        terms, notes = merged([*given, *springs_of(spring)])
        if not terms:
            raise InputError("law", "there is no term", FORMS)
        # What was read from floats is told whichever way the law came, and told once.
        noted = law.notes if isinstance(law, _Sum) else notes_of_floats(law, "alpha")
        object.__setattr__(self, "terms", terms)
        object.__setattr__(self, "notes", tuple(dict.fromkeys([*noted, *notes_of_floats(spring, "spring"), *notes])))

    @classmethod
    def from_terms(cls, terms: Iterable[Term], notes: Iterable[str] = ()) -> Self:
        """A law from terms, which may repeat an exponent; InputError when there is none, or something else."""
        made, more = merged(terms_of(terms))
        if not made:
            raise InputError("law", "there is no term", FORMS)
        # Past ``__init__``, which reads mappings: these terms have been read already.
        law = object.__new__(cls)
        object.__setattr__(law, "terms", made)
        object.__setattr__(law, "notes", tuple(dict.fromkeys([*notes, *more])))
        return law

    @property
    def losses(self) -> tuple[Term, ...]:
        """The terms odd in the velocity."""
        return tuple(t for t in self.terms if t.sign < 0)

    @property
    def springs(self) -> tuple[Term, ...]:
        """The terms odd in the position."""
        return tuple(t for t in self.terms if t.sign > 0)

    @property
    def is_pure(self) -> bool:
        """Whether every term is b x'|x'|^(alpha-1): the spring is linear, and no loss depends on the position."""
        return all(t.is_power_of_velocity for t in self.terms)

    def require_pure(self, purpose: str) -> None:
        """InputError if a spring or a position-dependent loss stands in the law: ``purpose`` knows the linear spring.

        >>> Law({2: 1}, spring={3: 1}).require_pure("the exact solution")
        Traceback (most recent call last):
            ...
        asymptotics.errors.InputError: argument law: x^3 is not a power of the velocity, and the exact solution ...
        """
        for t in self.terms:
            if not t.is_power_of_velocity:
                reason = f"{t.shape()} is not a power of the velocity, and {purpose} knows nothing else"
                raise InputError("law", reason, "terms b x'|x'|^(alpha-1) and the linear spring")

    @property
    def alphas(self) -> tuple[ExactReal, ...]:
        """The exponents of a sum of powers of the velocity; InputError when the law has other terms."""
        self.require_pure("this method")
        return tuple(t.velocity for t in self.terms)

    @property
    def integer_alphas(self) -> tuple[int, ...] | None:
        """The exponents as integers, or None if one of them is not an integer: then there is no exact arithmetic."""
        if all(a.is_integer for a in self.alphas):
            return tuple(a.rational.numerator for a in self.alphas)
        return None

    @property
    def is_dissipative(self) -> bool:
        """Whether no strength of a loss is negative."""
        return not any(t.strength.sign < 0 for t in self.losses)

    def require_dissipative(self, purpose: str) -> None:
        """InputError by name if a loss is negative (anti-damping): the formal series exist, ``purpose`` does not.

        >>> Law({2: -1}).require_dissipative("sequence of turning points to rest")
        Traceback (most recent call last):
            ...
        asymptotics.errors.InputError: argument strength: -1 is negative: anti-damping has no ... (accepted: ...)
        """
        for t in self.losses:
            if t.strength.sign < 0:
                raise InputError(
                    "strength", f"{t.strength} is negative: anti-damping has no {purpose}", "strengths >= 0"
                )

    def to_dict(self) -> dict[str, object]:
        """JSON-ready: numbers are strings."""
        return {"terms": [t.to_dict() for t in self.terms], "notes": list(self.notes)}

    def __str__(self) -> str:
        return signed_sum(self.terms)

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self})"

    def _page(self) -> Page:
        rows = tuple((t.shape(), str(t.strength)) for t in self.terms)
        return Page(str(self), self.notes, ("force", "strength"), rows)

    def _formula(self) -> str:
        return str(signed_sum(self.terms, latex=True))


@dataclass(frozen=True, init=False, repr=False)
class Law(_Sum):
    """A dimensionless law: the strengths are epsilon (losses) and c (springs), in units m = k = x0 = 1.

    Parameters
    ----------
    law
        exponent -> strength, each an exact number (text such as "3/2" or "sqrt(2)"); a key (A, M) is |x|^M
        x'|x'|^(A-1); equal exponents are merged
    spring
        springs beside the linear one: a key P is c x|x|^(P-1), a key (P, Q) has the factor |x'|^Q; "pendulum" has sin x
        in the place of x (x0 = 1 rad)

    Raises
    ------
    InputError
        for no term, a negative exponent, and what is not an exact number

    Examples
    --------
    >>> print(Law({1: "1/50", ("3/2", 2): "1/10"}, spring={3: "-1/6"}))
    1/50 x' + 1/10 x^2 x'|x'|^(1/2) - 1/6 x^3
    """

    @classmethod
    def read(cls, value: "Law | Mapping[Any, Any]") -> "Law":
        """A law, or the mapping ``value`` (exponent -> strength) as one; InputError for strengths in SI."""
        if isinstance(value, Law):
            return value
        if isinstance(value, PhysicalLaw):
            raise InputError("law", "its strengths are b in SI, and epsilon is meant", "oscillator.dimensionless")
        return cls(value)


@dataclass(frozen=True, init=False, repr=False)
class PhysicalLaw(_Sum):
    """A law in SI: strengths b in N (s/m)^alpha (per m^M), c in N/m^P; it belongs to an ``Oscillator``."""


@dataclass(frozen=True, init=False, repr=False)
class Oscillator(Shown):
    """m x'' + k x + law = 0 with x(0) = x0, x'(0) = v0: exact numbers in SI, whose defaults make b = epsilon.

    The unit of length is |x0| when v0 = 0, else the radius sqrt(x0^2 + m v0^2/k) of the starting point.

    Parameters
    ----------
    law
        exponent -> b in N (s/m)^alpha, or a law, whose strengths are read as b, whatever they were before
    mass
        m in kg, or with its unit ("200 g"), > 0
    stiffness
        k in N/m, or with its unit ("20 N/cm"), > 0
    x0
        the place at the start in m, in rad for a pendulum, or with its unit: "5 cm", "20 deg"
    v0
        the speed at the start in m/s, in rad/s for a pendulum, or with its unit: "3 cm/s"
    spring
        springs beside the linear one, as of ``Law``, c in N/m^P

    Raises
    ------
    InputError
        for m <= 0, k <= 0, and a start at rest at 0

    Examples
    --------
    >>> oscillator = Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5")
    >>> oscillator.omega_0().str(8, radius=False), oscillator.unit
    ('4.4721360', 'm')
    """

    law: PhysicalLaw
    mass: ExactReal
    stiffness: ExactReal
    x0: ExactReal
    v0: ExactReal
    notes: tuple[str, ...] = field(compare=False)

    @named
    def __init__(
        self, law: Mapping[Any, Any] | _Sum, *, mass: Number = 1, stiffness: Number = 1, x0: Number = 1, v0: Number = 0,
        spring: Mapping[Any, Any] | str | None = None,
    ) -> None:  # fmt: skip
        # A Scaled strength has had the units of its oscillator taken off: read as b it would mean something else.
        if isinstance(law, _Sum) and any(isinstance(t.strength, Scaled) for t in law.terms):
            raise InputError("law", "its strengths belong to another oscillator", "strengths b as exact numbers")
        given: dict[str, Any] = {"mass": mass, "stiffness": stiffness, "x0": x0, "v0": v0}
        physical = PhysicalLaw(law, spring)
        units = {"x0": _unit(physical), "v0": f"{_unit(physical)}/s"}
        values = {name: exact_number(value, name, units.get(name, "")) for name, value in given.items()}
        for name in ("mass", "stiffness"):
            if not values[name] > 0:
                raise InputError(name, f"{values[name]} is not positive", "a positive number")
        # Exact numbers: whether the motion starts at all is decided, not estimated.
        if values["x0"].is_zero and values["v0"].is_zero:
            raise InputError("x0", "with x0 = 0 and v0 = 0 nothing moves", "a start away from rest at the origin")
        for name, value in {"law": physical, **values, "notes": physical.notes + float_notes(**given)}.items():
            object.__setattr__(self, name, value)

    def with_law(self, law: Mapping[Any, Any] | _Sum) -> "Oscillator":
        """The same mass, spring and start under another ``law``: a mapping exponent -> b in SI, or such a law."""
        return Oscillator(law, mass=self.mass, stiffness=self.stiffness, x0=self.x0, v0=self.v0)

    @property
    def units(self) -> Units:
        """The numbers that set the units of length and time."""
        return Units(self.mass, self.stiffness, self.x0, self.v0)

    @cached_property
    def dimensionless(self) -> Law:
        """The law in units m = k = x0 = 1: epsilon = b omega_0^velocity length^weight/k, exact where it can be."""
        # No two terms have one key, with units or without: nothing is merged here, and the order stays.
        return Law.from_terms([self.units.without(t) for t in self.law.terms], self.notes)

    @inside
    def omega_0(self) -> arb:
        """sqrt(k/m) in rad/s, as a ball."""
        return self.units.omega_0()

    @inside
    def length(self) -> arb:
        """The unit of length in m, as a ball."""
        return self.units.length()

    @inside
    def epsilons(self) -> tuple[arb, ...]:
        """The dimensionless strengths of the terms, as balls."""
        return tuple(t.strength.ball() for t in self.dimensionless.terms)

    @inside
    def deltas(self, amplitude: arb) -> tuple[arb, ...]:
        """delta_i = epsilon_i A^(d_i-1) at the slow ``amplitude`` A > 0, in units of ``length``; InputError else."""
        # Anything else would be refused by FLINT, in words that name no argument.
        _require_balls(amplitude=amplitude)
        if not amplitude > 0:
            raise InputError("amplitude", f"{amplitude.str(5)} is not certainly positive", "a positive number")
        return tuple(t.delta(amplitude) for t in self.dimensionless.terms)

    @inside
    def kappas(self) -> tuple[arb, ...]:
        """Lancaster's kappa_i = M_(alpha_i+1) epsilon_i (Lancaster 2020, below (8)), as balls."""
        return tuple(moment(a.ball() + 1) * e for a, e in zip(self.law.alphas, self.epsilons()))

    @inside
    def to_si(self, X: arb, tau: arb) -> tuple[arb, arb]:
        """Dimensionless displacement ``X`` and time ``tau`` -> (x in m, t in s)."""
        _require_balls(X=X, tau=tau)
        return X * self.length(), tau / self.omega_0()

    def to_dict(self) -> dict[str, object]:
        """JSON-ready: numbers are strings."""
        names = ("mass", "stiffness", "x0", "v0")
        return {"law": self.law.to_dict(), **{n: str(getattr(self, n)) for n in names}}

    def __str__(self) -> str:
        left = Term(self.mass, 0, 1, "position"), Term(self.stiffness, 0, 1, "position")
        force, start = signed_sum((left[1], *self._forces())), f"x(0) = {self.x0}, x'(0) = {self.v0}"
        return f"{left[0]}'' + {force} = 0, {start}"

    def _forces(self) -> tuple[Term, ...]:
        """The terms as they are written out: a named spring carries the stiffness."""
        return tuple(replace(t, strength=t.b * self.stiffness) if t.family else t for t in self.law.terms)

    def __repr__(self) -> str:
        return f"Oscillator({self})"

    def _page(self) -> Page:
        rows = (("mass", f"{self.mass} kg"), ("stiffness", f"{self.stiffness} N/m"), ("omega_0", self._omega()),
                ("x(0)", f"{self.x0} {self.unit}"), ("x'(0)", f"{self.v0} {self.unit}/s"))  # fmt: skip
        return Page(str(self), self.notes, ("", "value"), rows)

    def _omega(self) -> str:
        return f"{float(self.omega_0().mid()):.6g} rad/s"

    @property
    def unit(self) -> str:
        """The unit of x, "m", or "rad" for a pendulum, whose restoring force is the sine of x."""
        return _unit(self.law)

    def _letters(self) -> dict[str, str]:
        return {"x": f"displacement in {self.unit}"}

    def _formula(self) -> str:
        mass = {"1": ""}.get(str(self.mass), latex(self.mass) + r"\,")
        force = signed_sum((Term(self.stiffness, 0, 1, "position"), *self._forces()), latex=True)
        return rf"{mass}\ddot x + {force} = 0"


def _unit(law: _Sum) -> str:
    return "rad" if any(t.family for t in law.springs) else "m"


def _require_balls(**values: Any) -> None:
    for name, value in values.items():
        if not isinstance(value, arb):
            raise InputError(name, f"{shown(value)} is no ball", "an arb")


LawLike = Law | Oscillator | Mapping[Any, Any] | Sequence[Any] | Number
"""A law, an oscillator, a mapping exponent -> strength; an exponent or several where no strength is needed."""
SpringLike = Mapping[Any, Any] | str
"""A mapping power -> strength, or "pendulum"."""


def of_unit_start(law: Law, *, x0: Number = 1, v0: Number = 0) -> Oscillator:
    """With m = k = 1, from the circle x0^2 + v0^2 = 1: in these units b is epsilon, whatever that is made of.

    >>> heavy = Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5")
    >>> of_unit_start(heavy.dimensionless).epsilons()[0].str(10, radius=False)
    '0.01409828351'
    """
    # Past ``__init__``, which refuses strengths whose units have been taken off: here they mean what they say.
    found, physical = Oscillator({0: 1}, x0=x0, v0=v0), PhysicalLaw.from_terms(law.terms, law.notes)
    object.__setattr__(found, "law", physical)
    object.__setattr__(found, "notes", physical.notes)
    return found
