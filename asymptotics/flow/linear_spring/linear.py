"""Linear damping, dry friction and nothing else: the half-swing in closed form, about the centre that friction shifts.

With epsilon < 2, omega^2 = 1 - epsilon^2/4 and y' = -w, w' = y - epsilon w,

    y = e^(-epsilon t/2) (y_0 cos omega t + (epsilon y_0/2 - w_0)/omega sin omega t),
    w = e^(-epsilon t/2) (w_0 cos omega t + (y_0 - epsilon w_0/2)/omega sin omega t).

From w_0 >= 0 (y_0 > 0 where w_0 = 0) the first t > 0 with w = 0 is omega t = arg(epsilon w_0/2 - y_0 + i omega w_0), or
pi where w_0 = 0.

>>> from flint import ctx
>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(60):
...     law = Damping.of([(arb(1) / 5, ExactReal(1)), (arb(1) / 50, ExactReal(0))])
...     orbit = LinearSolution.of(law, arb("0.75"), arb(0))
...     t, y = orbit.turning()
>>> t.str(12), y.str(12), orbit.state(t)[1].overlaps(arb(0))
('[3.15741941700 +/- ...]', '[-0.546935710716 +/- ...]', True)
"""

from dataclasses import dataclass

from flint import arb

from asymptotics.flow.damping import Damping

ROUTE = "closed form about the shifted centre"


def is_linear(damping: Damping) -> bool:
    """Whether N(w) is epsilon w with epsilon certainly below 2, or 0."""
    # Exponents are compared exactly; epsilon < 2 must hold for the whole ball, so that omega^2 is above 0.
    return all(not a < 1 and not a > 1 for a in damping.alphas) and bool(_total(damping) < 2)


def _total(damping: Damping) -> arb:
    return sum(damping.strengths, arb(0))


@dataclass(frozen=True)
class LinearSolution:
    """The orbit from (y, w) at t = 0; ``decay`` is epsilon/2, ``omega`` its frequency."""

    decay: arb
    omega: arb
    y: arb
    w: arb

    @classmethod
    def of(cls, damping: Damping, y: arb, w: arb) -> "LinearSolution":
        """The orbit from balls y and w >= 0 under a law that ``is_linear``, at the current precision."""
        decay = _total(damping) / 2
        # 1 - epsilon^2/4 as a product: next to critical damping the difference of two squares would cancel.
        return cls(decay, ((1 - decay) * (1 + decay)).sqrt(), y, w)

    def state(self, t: arb) -> tuple[arb, arb]:
        """(y, w) at the time t, as if the speed had no sign."""
        fall, sine, cosine = (-self.decay * t).exp(), *(self.omega * t).sin_cos()
        y = self.y * cosine + (self.decay * self.y - self.w) / self.omega * sine
        w = self.w * cosine + (self.y - self.decay * self.w) / self.omega * sine
        return fall * y, fall * w

    def turning(self) -> tuple[arb, arb]:
        """(t, y) at the first t > 0 with w = 0."""
        # w = 0 exactly is the start itself, and the next zero of w is half a turn away.  For w > 0 the angle is in (0,
        # pi), where atan2 has no cut.
        angle = arb.pi() if self.w == 0 else arb.atan2(self.omega * self.w, self.decay * self.w - self.y)
        t = angle / self.omega
        return t, self.state(t)[0]
