"""The limit cycle at a number mu: its turning amplitude by interval Newton, with its period and multiplier, in balls.

From the turning point (A, 0) the orbit of x'' + f(x) + h(x, x') = 0, h = mu sum_i E_i x^m_i x'^alpha_i, f = x and any
springs c x^p x'^q that stand beside it (p odd, q even; not multiplied by mu), runs to the next one, (-q(A), 0), in the
time T(A).  All is odd, so a fixed point q(A) = A is a cycle of the period 2 T.  With J = int h_v d tau over the
half-swing, f at rest and derivation ``energy-contraction``, f(q) dq = f(A) dA e^(-J), hence

    F(A) = q(A) - A,    F'(A) = (f(A)/f(q)) e^(-J) - 1,

and for an interval I with centre a: if a - F(a)/F'(I) lies inside I, then I contains exactly one turning amplitude of a
limit cycle (the interval Newton method, Moore 1966; F'(I) must not contain 0).  q is the Poincare return map of the
section v = 0, reflected (Guckenheimer and Holmes 1983, section 1.5).  The multiplier of a whole period is e^(-2 J) at
q = A.

The half-swing in balls is that of ``half_cycle``.
"""

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from flint import arb

from asymptotics.errors import InputError, UndecidedError
from asymptotics.law import Law
from asymptotics.limit_cycles.force import PolynomialForce
from asymptotics.limit_cycles.half_cycle import HalfCycle, half_cycle
from asymptotics.limit_cycles.series import circle_mean, require_polynomial
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import TooWideError, at_growing_precision
from asymptotics.numbers.value import Coefficient, number_of
from asymptotics.present.shown import Page, Shown
from asymptotics.terms import Term

# Beyond it the jumps of a relaxation oscillation take more and more steps and digits (``half_cycle.MAX_STEPS``); a
# limit of work, not of the theorem.
MAX_MU = 20
MIN_MU = ExactReal(Fraction(1, 10**100))  # below it the multiplier is told from 1 by more bits than a minute pays for
# Doublings of the precision; Newton steps, each of which doubles the bits of the centre, from the 36 of the guess;
# secants, each of which makes them 1.6 times as many.
_DOUBLINGS = 3
_NEWTON = 12
_GUESSED = (80, 160, 320, 640)  # bits in which a half-turn of the guess is tried
_SECANTS = 30


@dataclass(frozen=True, repr=False)
class CertifiedCycle(Shown):
    """Turning amplitude, period, frequency 2 pi/period and multiplier as correctly rounded decimals, all proved.

    ``stable``: whether the multiplier is below 1, None if undecided; ``radius``: of the interval with one cycle.
    """

    mu: str
    amplitude: str
    period: str
    frequency: str
    multiplier: str
    stable: bool | None
    radius: str

    @property
    def certified(self) -> bool:
        """True: what is not proved is refused."""
        return True

    def number(self, name: str = "amplitude") -> Coefficient:
        """``amplitude``, ``period``, ``frequency`` or ``multiplier`` as a number: mpf, interval, ball."""
        return number_of(self, name)

    def _page(self) -> Page:
        names = ("mu", "amplitude", "period", "frequency", "multiplier", "stable", "radius")
        stable = {True: "stable", False: "unstable", None: "stability undecided"}[self.stable]
        title = f"limit cycle at mu = {self.mu}: A = {self.amplitude}, period {self.period}, {stable}"
        return Page(title, ("certified: every digit is proved",), ("", "value"),
                    tuple((n, getattr(self, n)) for n in names))  # fmt: skip

    def _formula(self) -> str:
        return rf"A = {self.amplitude},\quad \omega = {self.frequency},\quad \mu = {self.mu}"

    def to_dict(self) -> dict[str, str | bool | None]:
        """The numbers as a JSON-ready mapping: decimals are strings."""
        return {**self.__dict__, "certified": True}


def certified_limit_cycle(law: Law, mu: ExactReal, digits: int, near: float) -> CertifiedCycle:
    """The limit cycle whose turning amplitude is near ``near`` (a float, only a guess), at the number ``mu``.

    Raises InputError for laws that are no polynomials or a mu that is 0 or too large, UndecidedError when the interval
    Newton step does not close (no cycle near the guess, or a multiplier too near 1).

    >>> van_der_pol = Law({1: -1, (1, 2): 1})
    >>> certified_limit_cycle(van_der_pol, ExactReal(1), 20, 2.0).amplitude
    '2.0086198608748431365'
    """
    terms = require_polynomial(law, springs=True)
    size = abs(mu)
    if mu.is_zero or size < MIN_MU or size > MAX_MU:
        raise InputError("mu", f"{mu} is out of range", f"a number from 1e-100 to {MAX_MU} in size, of either sign")
    # A cycle that repels is followed backwards in time, where it attracts: errors then shrink along the orbit.  A wrong
    # guess of the direction costs digits, or is refused.
    back = _repels(terms, float(mu.ball().mid()), near)
    toward = -mu if back else mu
    guess = _fixed_point(terms, toward, near)

    def attempt(bits: int) -> CertifiedCycle:
        # 24 bits less than the working precision: what a half-turn of some hundred steps may lose.  A larger loss is
        # seen by the interval step, which fails, and the precision grows.
        found = _interval_newton(terms, toward.ball(), guess, bits - 24)
        made = None if found is None else _rounded(str(mu), found, digits, back)
        if made is None:
            reason = f"no limit cycle was proved near A = {guess.str(8, radius=False)} at mu = {mu}"
            raise TooWideError(reason, lacking=bits // 2)
        return made

    bits = bits_for(digits, 64)
    return at_growing_precision(attempt, digits, bits, max_bits=bits << _DOUBLINGS)


def _rounded(mu: str, found: tuple[arb, arb, HalfCycle], digits: int, back: bool) -> CertifiedCycle | None:
    """The numbers of the cycle in an interval of this radius, ``back``: in reversed time; None where undecided."""
    amplitude, radius, turn = found
    # A whole period is two half-turns; backwards in time the multiplier is the inverse.
    multiplier = ((2 if back else -2) * turn.J).exp()
    values = (amplitude, 2 * turn.T, arb.pi() / turn.T, multiplier)
    a, period, frequency, shown = (decimal_of_ball(v, digits) for v in values)
    if a is None or period is None or frequency is None or shown is None or not radius > 0:
        return None
    stable = True if multiplier < 1 else False if multiplier > 1 else None
    return CertifiedCycle(mu, a, period, frequency, shown, stable, radius.str(3, radius=False))


def _repels(terms: tuple[Term, ...], mu: float, near: float) -> bool:
    """Whether the cycle near A seems to repel: t -> -t, mu -> -mu makes it attract, and inverts the multiplier.

    By the mean of h_v on a circle, in doubles: a choice of the direction in which the orbit is followed.
    """
    losses = ((float(t.strength.ball().mid()), t.position, int(t.velocity.rational)) for t in terms if t.sign < 0)
    return mu * sum(e * a * near ** (m + a - 1) * float(circle_mean(m, a - 1)) for e, m, a in losses) < 0


def _interval_newton(terms: tuple[Term, ...], mu: arb, guess: arb, good: int) -> tuple[arb, arb, HalfCycle] | None:
    """(A, radius of the interval, half-turn over it) once a - F(a)/F'(I) lies inside I; None if it never does."""
    a, rest = guess.mid(), _at_rest(terms, mu)
    for _ in range(_NEWTON):  # Newton's method on midpoints finds the centre
        turn = half_cycle(terms, mu, a)
        if turn is None:
            return None
        # F/F', with the derivative by Liouville's formula (derivation ``energy-contraction``): no second orbit is
        # needed.
        step = (turn.q - a) / ((rest(a) / rest(turn.q)) * (-turn.J).exp() - 1)
        if not step.is_finite():  # a multiplier that is not told from 1
            return None
        if abs(step.mid()) < arb(2) ** -good + 2 * step.rad():  # a multiplier near 1 magnifies what is not known
            break
        a = (a - step).mid()
    else:  # the half-turn is that of the place before
        return None
    # Eight times what the last step moved: wide enough to hold the fixed point although a is not it, and narrow enough
    # for F' to keep away from 0.  A choice; the next lines prove.
    radius = 8 * (abs(step).upper() + arb(2) ** -good)
    interval = arb(a, radius.upper())
    # q and J for every A of the interval: its radius is an error of the start, carried through the steps.
    wide = half_cycle(terms, mu, interval)
    if wide is None:
        return None
    slope = (rest(interval) / rest(wide.q)) * (-wide.J).exp() - 1
    if slope.contains(0):
        return None
    # The interval Newton operator about the exact centre: if it maps into the interior, the interval holds exactly one
    # fixed point, and so does the image.
    newton = a - (turn.q - a) / slope
    return (newton, radius, wide) if interval.contains_interior(newton) else None


def _at_rest(terms: tuple[Term, ...], mu: arb) -> Callable[[arb], arb]:
    """The force f(x) of the springs at v = 0."""
    force = PolynomialForce.of(terms, mu)
    return lambda x: force.at(x, arb(0))


def _fixed_point(terms: tuple[Term, ...], mu: ExactReal, near: float) -> arb:
    """A fixed point of q by the secant method on midpoints: a guess.

    ``excess`` raises the precision by itself, not by ``at_growing_precision``: that loop would try an UndecidedError of
    a step again, which ends the guess here, and its own refusal counts digits, of which a guess has none to promise.
    """

    def excess(a: float) -> float:
        for bits in _GUESSED:
            with ctx.workprec(bits):
                turn = half_cycle(terms, mu.ball(), arb(a))
            if turn is not None:
                return float(turn.q.mid()) - a
        raise UndecidedError(f"from A = {a:.6g} no next turning point was found")

    # One per cent apart: the slope is of a function that a relaxation oscillation bends strongly.
    a, b = near, near * 1.01
    fa, fb = excess(a), excess(b)
    for _ in range(_SECANTS):
        # Doubles can tell no more; Newton's method in balls goes on from there.
        if abs(b - a) < 1e-11 * abs(b) or fb == fa:
            break
        a, fa, b = b, fb, b - fb * (b - a) / (fb - fa)
        if not 0 < b < 1e6:
            raise UndecidedError(f"no limit cycle was found near A = {near:.6g}")
        fb = excess(b)
    return arb(b)
