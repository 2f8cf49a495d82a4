"""The limit cycle at a number mu: its turning amplitude by interval Newton, with its period and multiplier, in balls.

From the turning point (A, 0) the orbit of x'' + f(x) + h(x, x') = 0, h = mu sum_i E_i x^m_i x'^alpha_i, f = x and any
springs c x^p x'^q that stand beside it (p odd, q even; not multiplied by mu), runs to the next one, (-q(A), 0), in the
time T(A).  All is odd, so a fixed point q(A) = A is a cycle of the period 2 T.  With J = int h_v d tau over the
half-swing, f at rest and derivation ``energy-contraction``, f(q) dq = f(A) dA e^(-J), hence

    F(A) = q(A) - A,    F'(A) = (f(A)/f(q)) e^(-J) - 1,

and for an interval I with centre a: if a - F(a)/F'(I) lies inside I, then I contains exactly one turning amplitude of a
limit cycle (interval Newton; F'(I) must not contain 0).  The multiplier of a whole period is e^(-2 J) at q = A.

*The orbit in balls.*  Taylor steps for (x, v, J): over a step of length eta, a box B with z + [0, eta] f(B) inside B
contains the orbit (Picard), and the remainder of the Taylor polynomial of degree n - 1 is the n-th coefficient of the
same recurrence started from B, times eta^n.  On the first box the acceleration is negative, on the last it is positive,
between them v is negative: v has no other zero on the way.  The last step ends at a time at which v is certainly small;
the turning point is then |v|/min|x + h| away in time, and less than |v| times that in x.  Nothing but the width of the
balls depends on the step, the degree and the precision, which floats choose.
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import prod
from operator import mul

from flint import arb, arb_poly

from asymptotics.budget import tick
from asymptotics.errors import InputError, UndecidedError
from asymptotics.law import Law
from asymptotics.limit_cycles.series import circle_mean, require_polynomial
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import TooWideError, at_growing_precision
from asymptotics.numbers.value import Coefficient, number_of
from asymptotics.present.shown import Page, Shown
from asymptotics.terms import Term

MAX_MU = 10
_STEPS_PER_TURN = 48
_DOUBLINGS = 2
_FLOAT_STEPS = 4000
_NEWTON = 12
_RELAXED = 3  # |mu| beyond which steps are halved and bits are spared


@dataclass(frozen=True)
class HalfTurn:
    """From (A, 0) to (-q, 0): q, the time T, and J = int h_v d tau."""

    q: arb
    T: arb
    J: arb


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
        """JSON-ready."""
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
    if mu.is_zero or size > MAX_MU:
        raise InputError("mu", f"{mu} is out of range", f"a number other than 0, at most {MAX_MU} in size")
    back = _repels(terms, float(mu.ball().mid()), near)
    toward = -mu if back else mu
    guess = _float_fixed_point(terms, float(toward.ball().mid()), near)

    def attempt(bits: int) -> CertifiedCycle:
        found = _interval_newton(terms, toward.ball(), guess, bits - 24)
        made = None if found is None else _rounded(str(mu), found, digits, back)
        if made is None:
            reason = f"no limit cycle was proved near A = {guess.str(8, radius=False)} at mu = {mu}"
            raise TooWideError(reason, lacking=bits // 2)
        return made

    bits = bits_for(digits, 64) + _lost(float(size.ball().mid()))
    return at_growing_precision(attempt, digits, bits, max_bits=bits << _DOUBLINGS)


def _rounded(mu: str, found: tuple[arb, arb, HalfTurn], digits: int, back: bool) -> CertifiedCycle | None:
    """The numbers of the cycle in an interval of this radius, ``back``: in reversed time; None where undecided."""
    amplitude, radius, turn = found
    multiplier = ((2 if back else -2) * turn.J).exp()
    values = (amplitude, 2 * turn.T, arb.pi() / turn.T, multiplier)
    a, period, frequency, shown = (decimal_of_ball(v, digits) for v in values)
    if a is None or period is None or frequency is None or shown is None or not radius > 0:
        return None
    stable = True if multiplier < 1 else False if multiplier > 1 else None
    return CertifiedCycle(mu, a, period, frequency, shown, stable, radius.str(3, radius=False))


def _lost(mu: float) -> int:
    """About how many bits the balls lose on a half-turn, where the cycle relaxes: a choice."""
    return int(6 * mu * mu) if abs(mu) > _RELAXED else 0


def _repels(terms: tuple[Term, ...], mu: float, near: float) -> bool:
    """Whether the cycle near A seems to repel: t -> -t, mu -> -mu makes it attract, and inverts the multiplier.

    By the mean of h_v on a circle, in doubles: a choice of the direction in which the orbit is followed.
    """
    losses = ((float(t.strength.ball().mid()), t.position, int(t.velocity.rational)) for t in terms if t.sign < 0)
    return mu * sum(e * a * near ** (m + a - 1) * float(circle_mean(m, a - 1)) for e, m, a in losses) < 0


def _interval_newton(terms: tuple[Term, ...], mu: arb, guess: arb, good: int) -> tuple[arb, arb, HalfTurn] | None:
    """(A, radius of the interval, half-turn over it) once a - F(a)/F'(I) lies inside I; None if it never does."""
    a, field = guess.mid(), _Field(terms, mu)
    for _ in range(_NEWTON):  # Newton's method on midpoints finds the centre
        turn = half_turn(terms, mu, a)
        if turn is None:
            return None
        step = (turn.q - a) / ((field.at_rest(a) / field.at_rest(turn.q)) * (-turn.J).exp() - 1)
        if abs(step.mid()) < arb(2) ** -good + 2 * step.rad():  # a multiplier near 1 magnifies what is not known
            break
        a = (a - step).mid()
    else:  # the half-turn is that of the place before
        return None
    radius = 8 * (abs(step).upper() + arb(2) ** -good)
    interval = arb(a, radius.upper())
    wide = half_turn(terms, mu, interval)
    if wide is None:
        return None
    slope = (field.at_rest(interval) / field.at_rest(wide.q)) * (-wide.J).exp() - 1
    if slope.contains(0):
        return None
    newton = a - (turn.q - a) / slope
    return (newton, radius, wide) if interval.contains_interior(newton) else None


def half_turn(terms: tuple[Term, ...], mu: arb, A: arb) -> HalfTurn | None:
    """The half-swing from (A, 0) in balls; None if an enclosure fails."""
    field, size = _Field(terms, mu), _size(terms, float(mu.mid()), float(A.mid()))
    T = _float_map(terms, float(mu.mid()), float(A.mid()))[1]
    z, degree = (A.mid() + arb(0, A.rad()), arb(0), arb(0)), max(16, int(ctx.prec * 0.22))
    steps, time = int(_STEPS_PER_TURN * (1 + size) * (2 if _lost(float(mu.mid())) else 1)), arb(0)
    for k in range(steps):
        tick(f"step {k} of {steps} around the cycle")
        eta = arb(T / steps) if k < steps - 1 else _last_step(field, z, T / steps, degree)
        box = _picard_box(field, z, eta)
        if box is None or not _goes_on(field, box, k, steps):
            return None
        z, time = _step(field, z, box, eta, degree), time + eta
    return _to_the_turn(field, *z, time)


def _size(terms: tuple[Term, ...], mu: float, A: float) -> float:
    """How far the field is from that of the linear oscillator, which chooses the steps."""
    parts = (abs(float(t.strength.ball().mid())) * A ** float(t.weight.ball().mid()) for t in terms)
    return float(max(abs(mu), abs(mu) * sum(parts) / 5))


def _last_step(field: "_Field", z: tuple[arb, arb, arb], eta: float, degree: int) -> arb:
    """Where the Taylor polynomial of v vanishes, by Newton's method on midpoints: a choice, not a claim."""
    v = field.taylor((z[0].mid(), z[1].mid(), z[2].mid()), degree)[1]
    slope, end = v.derivative(), arb(eta)
    for _ in range(12):
        end = (end - v(end) / slope(end)).mid()
    return end


def _to_the_turn(field: "_Field", x: arb, v: arb, J: arb, T: arb) -> HalfTurn | None:
    """What is missing to v = 0: with |v| <= w and an acceleration >= g near the end, |dt| <= w/g."""
    w = abs(v).upper()
    box_v, box_x = arb(0, 2 * w), x + arb(0, 4 * w)
    acceleration, divergence = field.at(box_x, box_v)
    g = abs(acceleration).lower()
    if not (g > 4 * w and g > 0):  # then |dt| < 1/4 and the orbit stays in the box
        return None
    dt = (w / g).upper()
    more = arb(0, (abs(divergence).upper() * dt).upper())
    return HalfTurn(-(x + arb(0, (2 * w * dt).upper())), T + arb(0, dt), J + more)


class _Field:
    """The right side (v, -x - h, h_v), springs among h, and its Taylor recurrence."""

    def __init__(self, terms: tuple[Term, ...], mu: arb) -> None:
        self.parts = [
            (t.strength.ball() * (mu if t.sign < 0 else 1), t.position, int(t.velocity.rational)) for t in terms
        ]

    def at(self, x: arb, v: arb) -> tuple[arb, arb]:
        """(acceleration, h_v) at balls."""
        h, divergence = arb(0), arb(0)
        for e, m, a in self.parts:
            h += e * prod([x] * m + [v] * a, start=arb(1))
            if a:
                divergence += e * a * prod([x] * m + [v] * (a - 1), start=arb(1))
        return -x - h, divergence

    def at_rest(self, x: arb) -> arb:
        """The force f(x) of the springs at v = 0."""
        return -self.at(x, arb(0))[0]

    def taylor(self, z: tuple[arb, arb, arb], degree: int) -> tuple[arb_poly, arb_poly, arb_poly]:
        """The Taylor polynomials of x, v, J in time through ``degree``, coefficient by coefficient."""
        x, v, J = [z[0]], [z[1]], [z[2]]
        products = [_Product(x, m, v, max(a - 1, 0)) for _, m, a in self.parts]
        for n in range(degree):
            pull, divergence = x[n], arb(0)
            for (e, _, a), product in zip(self.parts, products):
                low = product.following()
                pull += e * (sum(map(mul, product.known, reversed(v)), arb(0)) if a else low)
                divergence += e * a * low
            x.append(v[n] / (n + 1))
            v.append(-pull / (n + 1))
            J.append(divergence / (n + 1))
        return arb_poly(x), arb_poly(v), arb_poly(J)


class _Product:
    """x^m v^a coefficient by coefficient, beside growing x and v: by partial products."""

    def __init__(self, x: list[arb], m: int, v: list[arb], a: int) -> None:
        self.factors = [x] * m + [v] * a
        self.partial: list[list[arb]] = [[] for _ in self.factors]
        self.known: list[arb] = []

    def following(self) -> arb:
        """The next coefficient."""
        n = len(self.known)
        before: list[arb] | None = None
        for factor, row in zip(self.factors, self.partial):
            row.append(factor[n] if before is None else sum(map(mul, before, reversed(factor[: n + 1])), arb(0)))
            before = row
        self.known.append(arb(int(n == 0)) if before is None else before[n])
        return self.known[n]


def _goes_on(field: _Field, box: tuple[arb, arb, arb], k: int, steps: int) -> bool:
    """Whether step k of the half-swing certainly has no turning point but its two ends."""
    if 0 < k < steps - 1:
        return bool(box[1] < 0)
    acceleration = field.at(box[0], box[1])[0]
    return bool(acceleration < 0 if k == 0 else acceleration > 0)


def _step(
    field: _Field, z: tuple[arb, arb, arb], box: tuple[arb, arb, arb], eta: arb, degree: int
) -> tuple[arb, arb, arb]:
    """One Taylor step of length ``eta`` with its remainder, ``box`` containing the orbit."""
    near = field.taylor(z, degree - 1)
    far = field.taylor(box, degree)
    return tuple(p(eta) + r[degree] * eta**degree for p, r in zip(near, far))  # type: ignore[return-value]


def _picard_box(field: _Field, z: tuple[arb, arb, arb], eta: arb) -> tuple[arb, arb, arb] | None:
    """A box B with z + [0, eta] f(B) inside B: it contains the orbit over the step."""
    span = arb(eta / 2, (eta / 2).upper())  # [0, eta]
    x, v, J = z
    box = (x, v, J)
    for _ in range(20):
        acceleration, divergence = field.at(box[0], box[1])
        image = (x + span * box[1], v + span * acceleration, J + span * divergence)
        if all(b.contains_interior(i) for b, i in zip(box, image)):
            return image
        box = tuple(arb(i.mid(), (i.rad() * 1.1 + arb(2) ** -30).upper()) for i in image)  # type: ignore[assignment]
    return None


def _rk4(f: Callable[[float, float], float], x: float, v: float, h: float) -> tuple[float, float]:
    k1, l1 = v, f(x, v)
    k2, l2 = v + h / 2 * l1, f(x + h / 2 * k1, v + h / 2 * l1)
    k3, l3 = v + h / 2 * l2, f(x + h / 2 * k2, v + h / 2 * l2)
    k4, l4 = v + h * l3, f(x + h * k3, v + h * l3)
    return x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4), v + h / 6 * (l1 + 2 * l2 + 2 * l3 + l4)


def _float_map(terms: tuple[Term, ...], mu: float, A: float) -> tuple[float, float]:
    """(q, T) in doubles: a guess."""
    parts = [
        (float(t.strength.ball().mid()) * (mu if t.sign < 0 else 1), t.position, int(t.velocity.rational))
        for t in terms
    ]

    def f(x: float, v: float) -> float:
        return -x - sum(e * x**m * v**a for e, m, a in parts)

    x, v, h, t = A, 0.0, 3.2 / _FLOAT_STEPS, 0.0
    for k in range(40 * _FLOAT_STEPS):
        before = (x, v)
        x, v = _rk4(f, x, v, h)
        t += h
        if k and v >= 0:
            share = before[1] / (before[1] - v)
            return -(before[0] + share * (x - before[0])), t - h * (1 - share)
        if abs(x) > 1e6:
            break
    raise UndecidedError(f"from A = {A:.6g} no next turning point was found")


def _float_fixed_point(terms: tuple[Term, ...], mu: float, near: float) -> arb:
    """A fixed point in doubles by the secant method: a guess."""
    a, b = near, near * 1.01
    fa, fb = (_float_map(terms, mu, s)[0] - s for s in (a, b))
    for _ in range(30):
        if abs(b - a) < 1e-11 * abs(b) or fb == fa:
            break
        a, fa, b = b, fb, b - fb * (b - a) / (fb - fa)
        if not 0 < b < 1e6:
            raise UndecidedError(f"no limit cycle was found near A = {near:.6g}")
        fb = _float_map(terms, mu, b)[0] - b
    return arb(b)
