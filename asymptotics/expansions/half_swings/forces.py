"""The forces of a series: which monomial of the local strengths stands before which homogeneous function of (x, v).

On the half-swing 0 <= theta <= pi (X = r c, X' = -r s, c = cos(theta), s = sin(theta) >= 0) the sum of all forces
divided by -r is

    N = sum rho^key ratio |c|^m s^alpha  (losses)  -  sum rho^key ratio c|c|^(p-1) s^q  (springs),

one *member* for each term of that sum.  A plain force is one member whose key is a unit vector.  A named spring is a
graded family in the square of the amplitude: the pendulum, sin x in place of x, has the one variable g = A^2 of weight
2, and its members -g/6 c^3, +g^2/120 c^5, ... have the keys 1, 2, ...

On the first quarter c >= 0, so |c|^m = c^m and c|c|^(p-1) = c^p for every m and p: only the second quarter tells x|x|
from x^2, and the reversal identity does not look at it.

>>> drag, pendulum = Term(1, 2), Term(1, 0, 3, "position", "pendulum")
>>> forces = Forces.of([drag, pendulum], 3)
>>> forces.signs, [(m.key, m.ratio, m.position) for m in forces.members]
((-1, 1), [((1, 0), 1, 0), ((0, 1), -1/6, 3), ((0, 2), 1/120, 5), ((0, 3), -1/5040, 7)])
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import factorial

from flint import fmpq

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.grading import Grading, loss_degree
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.rationals import to_fmpq
from asymptotics.series import Key, Series, unit_key
from asymptotics.terms import Term


@dataclass(frozen=True)
class Member:
    """rho^key * ratio * |x|^position v|v|^(velocity-1), or x|x|^(position-1) |v|^velocity for the sign +1."""

    key: Key
    ratio: fmpq
    velocity: ExactReal
    position: int
    sign: int

    @property
    def degree(self) -> ExactReal:
        """velocity + position: how the function scales with the amplitude."""
        return self.velocity + self.position

    @property
    def shape(self) -> tuple[ExactReal, int, int]:
        """What function it is: powers of v and x, and sign."""
        return self.velocity, self.position, self.sign

    @property
    def order(self) -> int:
        """The total degree of the key."""
        return sum(self.key)

    @property
    def side(self) -> int:
        """The sign with which the function enters N: +1 for a loss, -1 for a spring."""
        return -self.sign

    @property
    def integer_velocity(self) -> int:
        """The power of the velocity as an integer; InputError if it is none."""
        if not self.velocity.is_integer:
            raise InputError("alpha", f"{self.velocity} has no exact half-swing", "integers >= 0; certified: any real")
        return int(self.velocity.rational)

    @property
    def is_polynomial(self) -> bool:
        """Whether it is a polynomial in x and v: a loss of odd v and even x, or a spring of odd x and even v."""
        return self.is_closed and self.integer_velocity % 2 == (self.sign < 0)

    @property
    def is_closed(self) -> bool:
        """Whether it is a polynomial in x and |v| where v has one sign: |x| may not stand in it."""
        return self.velocity.is_integer and self.position % 2 == (self.sign > 0)


@dataclass(frozen=True)
class Forces:
    """Weights d_i - 1, signs and powers of the velocity of the variables, and the members they multiply.

    A member with a key n has the weight sum_i n_i weight_i, and likewise its sign and its power of the velocity.
    """

    weights: tuple[ExactReal, ...]
    signs: tuple[int, ...]
    velocities: tuple[ExactReal, ...]
    members: tuple[Member, ...]

    @classmethod
    def of(cls, terms: Sequence[Term], order: int) -> "Forces":
        """The forces of some terms, whose strengths do not matter; families are written out through ``order``.

        Raises InputError for no term.
        """
        if not terms:
            raise InputError("law", "there is no term", "at least one loss or spring")
        members: list[Member] = []
        for i, t in enumerate(terms):
            unit = unit_key(i, len(terms))
            # A family is written out as far as the order sees it: one member for each power of its strength.
            members += _family(unit, order) if t.family else [Member(unit, fmpq(1), t.velocity, t.position, t.sign)]
        velocities = tuple(ExactReal(0) if t.family else t.velocity for t in terms)
        return cls(tuple(t.weight for t in terms), tuple(t.sign for t in terms), velocities, tuple(members))

    @classmethod
    def losses(cls, alphas: Sequence[int | ExactReal]) -> "Forces":
        """The plain losses v|v|^(alpha_i - 1); InputError for a negative exponent."""
        return cls.read(alphas, 0)

    @classmethod
    def read(cls, given: "Given", order: int) -> "Forces":
        """Forces as they are; terms, families through ``order``; or the exponents of plain losses."""
        if isinstance(given, Forces):
            return given
        return cls.of([t if isinstance(t, Term) else Term(1, t) for t in given], order)

    @property
    def variables(self) -> int:
        """The number of local strengths."""
        return len(self.weights)

    @property
    def is_pure(self) -> bool:
        """Whether all forces are v|v|^(alpha-1): a linear spring, and losses that do not see the position."""
        return all(m.sign < 0 and not m.position and m.order == 1 for m in self.members)

    @property
    def is_integer(self) -> bool:
        """Whether all powers are integers, so that there is exact arithmetic."""
        return all(m.velocity.is_integer for m in self.members)

    @property
    def is_closed(self) -> bool:
        """Whether all forces are polynomials in x and |v| where v has one sign."""
        return all(m.is_closed for m in self.members)

    @property
    def is_even(self) -> bool:
        """Whether all forces are polynomials in cos(theta) on a whole half-swing: even powers of v besides."""
        return all(m.is_closed and m.integer_velocity % 2 == 0 for m in self.members)

    @property
    def is_smooth(self) -> bool:
        """Whether all forces are polynomials in x and v."""
        return all(m.is_polynomial for m in self.members)

    def only(self, places: Sequence[int], order: int) -> "Forces":
        """The forces that some of the variables make by themselves."""
        members = [
            replace(m, key=tuple(m.key[i] for i in places))
            for m in self.through(order)
            if all(i in places for i, n in enumerate(m.key) if n)
        ]
        rows = (tuple(row[i] for i in places) for row in (self.weights, self.signs, self.velocities))
        weights, signs, velocities = rows
        return Forces(weights, signs, velocities, tuple(members))  # type: ignore[arg-type]

    def embedded(self, key: Key, places: Sequence[int]) -> Key:
        """A monomial of some of the variables as one of all."""
        powers = dict(zip(places, key))
        return tuple(powers.get(i, 0) for i in range(self.variables))

    def loss_degree(self, key: Key) -> int:
        """How many losses a monomial contains."""
        return loss_degree(self.signs, key)

    def exact_grading(self) -> Grading:
        """The grading with rational weights."""
        return Grading(tuple(to_fmpq(w.rational) for w in self.weights), self.signs)

    def ball_grading(self) -> Grading:
        """The grading with balls at the current precision as weights."""
        return Grading(tuple(w.ball() for w in self.weights), self.signs)

    def potential(self, order: int) -> Series:
        """V(A)/(A^2/2) = 1 + sum of 2 gamma/(p+1): the energy at a turning point, as a series in the strengths.

        Raises InputError for a spring that depends on the velocity: its motion has no such energy.
        """
        zero = (0,) * self.variables
        found: dict[Key, fmpq] = {zero: fmpq(1)}
        for m in self.through(order):
            if m.sign > 0 and not m.velocity.is_zero:
                raise InputError("spring", "it depends on the velocity: no potential", "springs c x|x|^(P-1)")
            if m.sign > 0:
                found[m.key] = found.get(m.key, fmpq(0)) + 2 * m.ratio / (m.position + 1)
        return Series(found, self.variables, order)

    def through(self, order: int) -> tuple[Member, ...]:
        """The members that a series through ``order`` can see."""
        return tuple(m for m in self.members if m.order <= order)


Given = Forces | Sequence[int | ExactReal | Term]
"""What the engines take: forces, or terms, or the exponents of plain losses."""


def _family(unit: Key, order: int) -> list[Member]:
    """sin x - x = -x^3/6 + x^5/120 - ...: the coefficients of A^2, A^4, ..., as many as ``order``."""
    zero = ExactReal(0)
    return [
        Member(tuple(j * n for n in unit), fmpq((-1) ** j, factorial(2 * j + 1)), zero, 2 * j + 1, 1)
        for j in range(1, order + 1)
    ]
