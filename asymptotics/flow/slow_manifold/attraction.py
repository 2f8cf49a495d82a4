"""How a creep begins while its speed is still lost in the errors: its attraction to the slow curve takes a short time.

The attraction of a slow manifold (Fenichel 1979), proved here by two differential inequalities and a region that is
positively invariant.

For an exponent near 0 the speed of the creep, about (y/epsilon)^(1/alpha), is far below every error, and beside a
second exponent near the first the slow curve is no short sum of powers (``slow_curve``).  But where w is small,
so is

    sigma = w^2/n^2,     n = w N'(w) = sum alpha_i epsilon_i w^alpha_i,

and the slow curve is N itself up to a share sigma of n.  With rho = w n'(w)/n < 1 and sigma <= 1/16 at a largest speed
W > N^(-1)(y), for all lower ones N - 2 w^2/n <= y <= N is a region that the motion does not leave; from any w <= W it
comes there soon, m being a lower bound of the slow speed N^(-1)(y) (derivation ``settling``):

    from above in 8 W/n(m) + (8/3) (W/n(W)) ln(1/(16 sigma(m))),
    from below in m_1/n(m_1) + (W/n(W)) ln(1 + n(W) y/(W m_1)),   m_1 = m/e.

So what is known of y then says what w is: errors of y count 1/alpha times in ln w, and no digit of w is needed before.

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
>>> law = Damping.of([(arb(1) / 5, ExactReal(Fraction(k, 1000))) for k in (1, 2)])
>>> with ctx.workprec(80):
...     found = attracted(law, arb("0.3"), arb(0), arb("1e-20"))
...     found.wait < 1e-12, found.strip.state(arb(10) ** 9)[1].str(5)
(True, '[2.1588e-85 +/- ...]')
"""

from dataclasses import dataclass

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.flow.damping import Damping
from asymptotics.flow.slow_manifold.slow_curve import FencedStrip, solve
from asymptotics.numbers.context import ctx

# The hypothesis of the derivation ``settling``: kappa between 2 sigma and 1/8 must be a range.
_SMALL = arb(1) / 16


@dataclass(frozen=True)
class ForceCurve:
    """y = N(w) - h w^2/n(w), h = 0 or 2, as functions of ln w; ``least``: the least exponent."""

    damping: Damping
    h: int
    least: arb

    def sums(self, log_w: arb) -> tuple[arb, arb, arb]:
        """N, n and w n'."""
        terms = [e * (a * log_w).exp() for e, a in zip(self.damping.strengths, self.damping.exponents)]
        once = [a * t for a, t in zip(self.damping.exponents, terms)]
        twice = [a * t for a, t in zip(self.damping.exponents, once)]
        return sum(terms, arb(0)), sum(once, arb(0)), sum(twice, arb(0))

    def place(self, log_w: arb) -> tuple[arb, arb]:
        """y and dy/d ln w."""
        N, n, more = self.sums(log_w)
        lacking = self.h * (2 * log_w).exp() / n
        return N - lacking, n - lacking * (2 - more / n)

    def clock(self, log_w: arb) -> tuple[arb, arb]:
        """The antiderivative of dy/w, and its derivative by ln w.

        That of w/n by ln w, which vanishes at w = 0, lies between w/n over 1 - alpha_min and over 1 - rho.
        """
        _, n, more = self.sums(log_w)
        w, rho = log_w.exp(), more / n
        whole = arb(0)
        for e, a in zip(self.damping.strengths, self.damping.exponents):
            # For dy = N'(w) dw: the antiderivative of epsilon alpha w^(alpha-2); alpha = 1 exactly, or as a ball that
            # is 1.
            whole += e * log_w if a == 1 else e * a * ((a - 1) * log_w).exp() / (a - 1)
        if self.h:
            # Both ends of the bounds, as one ball: rho grows with w, from the least exponent at w = 0 on.
            tail = (1 / (1 - self.least)).union(1 / (1 - rho))
            whole -= self.h * w / n * (1 + tail)
        return whole, self.place(log_w)[1] / w


@dataclass(frozen=True)
class Attracted:
    """After the time ``wait``, in which the state stays in the balls ``y`` and ``w``, it lies in ``strip``."""

    wait: arb
    y: arb
    w: arb
    strip: FencedStrip


def attracted(damping: Damping, y: arb, w: arb, error: arb) -> Attracted | None:
    """How all states within ``error`` of the exact (y, w) settle in a strip beside N; None where it is not narrow."""
    if not damping.sublinear or not y > 2 * error:
        return None
    least = damping.exponents[damping.leading]
    above, below = (ForceCurve(damping, h, least) for h in (0, 2))
    # A strip no wider than the last bit, and a place that falls by no more than its error and the last bit while the
    # motion settles: choices that keep the digits; all conditions of the theorem are checked beside them.
    fine = arb(2) ** -ctx.prec
    allowed = upper(error + y * fine)
    # y falls by less than ``allowed`` in the time to come, which is verified by fastest times wait.
    lowest = (y - error - allowed).lower()
    try:
        most = _most(above, (y + error).upper(), (w + error).upper())
        fastest, N, _, rho, sigma = _at(above, most)
        # At the largest speed W, and so at all lower ones (rho and sigma grow with w): the hypotheses, with W above the
        # slow speed of the highest place.
        if not (rho < 1 and sigma < fine and sigma < _SMALL and y + error < N):
            return None
        # ln of the slow speed at the lowest place: m of the docstring, a lower bound at every place in between.
        slow = solve(above.place, lowest, most)
        wait = _wait(above, slow.lower(), most, y + error)
        if not fastest * wait < allowed:
            return None
        # The fastest and the slowest state when the wait is over lie between the two curves at these heights.
        starts = solve(above.place, y + error, most), solve(below.place, lowest, most)
    except UndecidedError:  # too few bits here: a later state may do
        return None
    if not all(start < most for start in starts):
        return None
    strip = FencedStrip(above, below, starts, most, spread(sigma), arb(0))
    return Attracted(wait, lowest.union(y + error), arb(0).union(fastest), strip)


def spread(sigma: arb) -> arb:
    """How far apart the two curves are in ln w at one height, at most, with sigma at the higher speed."""
    # Derivation ``settling``; sigma at the higher speed is the larger one.
    return upper(2 * sigma / (1 - 4 * sigma))


def _most(curve: ForceCurve, y: arb, w: arb) -> arb:
    """ln W: at least ln w, and above ln of the slow speed at y, which is sought from that of the strongest term on."""
    alone = [(y / e).log() / a for e, a in zip(curve.damping.strengths, curve.damping.exponents)]
    # Newton's method from below: each term alone needs more speed for y than all together.
    slow = solve(curve.place, y, min(alone, key=lambda u: float(u.mid())))
    # A factor e above the slow speed, so that states from below have room to overshoot to; the speed itself if that is
    # larger.
    highest = (slow + 1).upper()
    return highest if w == 0 else highest.max(w.log()).upper()


def _at(curve: ForceCurve, log_w: arb) -> tuple[arb, arb, arb, arb, arb]:
    """w, N, n, rho and sigma."""
    N, n, more = curve.sums(log_w)
    w = log_w.exp()
    return w, N, n, more / n, (w / n) ** 2


def _wait(curve: ForceCurve, slow: arb, most: arb, y: arb) -> arb:
    """The two times of the module's docstring together; ``slow``, ``most``: ln m, ln W."""
    _, _, n_slow, _, sigma = _at(curve, slow)
    m, _, n_m, _, _ = _at(curve, slow - 1)
    W, _, n, _, _ = _at(curve, most)
    above = 8 * W / n_slow + arb(8) / 3 * W / n * abs((16 * sigma).log())
    return upper(above + m / n_m + W / n * (n * y / (W * m)).log1p())
