"""How the errors of an expansion add up along the sequence of turning points, for any exponents, alpha < 1 included.

Lady Windermere's fan (Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I, section I.7) for the
return map of a nonexpansive flow, step by step.

For alpha < 1 the local strength grows and no bound holds for ever: this one is followed half-swing by half-swing and
ends where |delta| leaves the range of ``local``, at a stated turning point.  Units of x0 and 1/omega_0; A_n, tau_n
belong to the motion, A_hat_n, tau_hat_n to the truncated equations of order N, psi = n pi, both from A = 1 at rest.

* The truncated orbit itself is enclosed: ln(A_hat_(n+1)/A_hat_n) = L_N(delta_hat_n) and tau_hat_(n+1) - tau_hat_n =
  T_N(delta_hat_n) are their series with Cauchy's inequality for the rest (``local``).
* Two motions never part (derivation ``motions-never-part``): amplitudes that differ by D at one turning point differ by
  at most D at the next.  With |L - L_N| <= C_A |delta|^a,

      |A_(n+1) - A_hat_(n+1)| <= |A_n - A_hat_n| + A_hat_(n+1) (exp(C_A |delta_hat_n|^a) - 1).

* With h_n = -ln(1 - |A_n - A_hat_n|/A_hat_n) >= |ln(A_n/A_hat_n)| and w = max |alpha_i - 1|, as in ``turning``,

      |tau_(n+1) - tau_hat_(n+1)| <= |tau_n - tau_hat_n| + C_T |delta_hat_n|^b + B w h_n (|delta_hat_n| exp(w h_n))^2.

Both orbits turn again: |delta_n| <= |delta_hat_n| exp(w h_n) <= delta_max, inside the polydisc of ``local``, on which
the angle of the motion runs through the whole half-swing.

>>> from asymptotics.numbers.exact import parse_real
>>> root = [parse_real("1/2", "--alpha")]
>>> steps = list(turning_sequence_bounds(root, 3, [arb(1) / 20]))
>>> len(steps) - 1, steps[10].amplitude.str(2, radius=False), steps[10].time.str(2, radius=False)
(15, '1.3e-7', '1.0e-5')
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import prod

from flint import arb

from asymptotics.bounds.local import BITS, LocalBounds, Remainder, local_bounds
from asymptotics.bounds.turning import largest, sensitivity
from asymptotics.errors import LimitError
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.extremes import greatest
from asymptotics.running.budget import tick
from asymptotics.series import Series


@dataclass(frozen=True)
class TurningPointBound:
    """At turning point n: A_hat_n and tau_hat_n as enclosures, and bounds of |A_n - A_hat_n|, |tau_n - tau_hat_n| and
    of the phase error |psi_hat(tau_n) - n pi|."""

    n: int
    A: arb
    tau: arb
    amplitude: arb
    time: arb
    phase: arb


def turning_sequence_bounds(
    alphas: Sequence[ExactReal], order: int, epsilons: Sequence[arb]
) -> Iterator[TurningPointBound]:
    """The bounds at n = 0, 1, ..., as long as the local strengths stay in the range of ``local_bounds``.

    LimitError if not even the first half-swing does.
    """
    steps = _Steps(local_bounds(alphas, order), epsilons)
    here: TurningPointBound | None = TurningPointBound(0, arb(1), *[arb(0)] * 4)
    while here is not None:
        tick(f"turning point {here.n}")
        yield here
        with ctx.workprec(BITS):
            here = steps.after(here)


class _Steps:
    """What one half-swing needs: the map of the truncated equations, its error, and how durations depend on delta."""

    def __init__(self, local: LocalBounds, epsilons: Sequence[arb]) -> None:
        with ctx.workprec(BITS):
            self.local, self.epsilons = local, epsilons
            self.map = local.flow.half_swing(arb.pi())
            self.weights = [a.ball() - 1 for a in local.alphas]
            self.w = greatest(abs(weight) for weight in self.weights)
            self.B = sensitivity(local, local.limit)
            self.Omega = largest(local.flow.Omega.truncate(local.order), local.limit)
            if not sum(epsilons, arb(0)) <= local.limit:
                reason = f"sum epsilon_i = {sum(epsilons, arb(0)).str(3, radius=False)} is out of range"
                raise LimitError("epsilon", reason, f"at most {float(local.delta_max):g} at order {local.order}")

    def after(self, here: TurningPointBound) -> TurningPointBound | None:
        """The next turning point, None where the local strengths of one of the two orbits leave the range."""
        deltas = [e * here.A**w for e, w in zip(self.epsilons, self.weights)]
        delta = arb(sum(deltas, arb(0)).upper())
        # |A_n - A_hat_n|/A_hat_n < 1: otherwise the true amplitude is not known to be above 0.
        rest = here.amplitude / here.A
        if not rest < 1:
            return None
        wh = self.w * -(1 - rest).log()
        # |delta| of the motion itself, which must lie in the range as well: all suprema were taken there.
        widest = (delta * wh.exp()).upper()
        if not widest <= self.local.limit:
            return None
        A = here.A * self._value(self.map.L, self.local.amplitude, deltas, delta).exp()
        tau = here.tau + self._value(self.map.T, self.local.duration, deltas, delta)
        # Two motions never part: the error before does not grow, and the map's own error is added at the size of the
        # new amplitude.
        amplitude = here.amplitude + A * self.local.amplitude(delta).expm1()
        time = here.time + self.local.duration(delta) + self.B * wh * widest**2
        bounds = (arb(b.upper()) for b in (amplitude, time, time * (1 + self.Omega)))
        return TurningPointBound(here.n + 1, A, tau, *bounds)

    def _value(self, f: Series, remainder: Remainder, deltas: Sequence[arb], delta: arb) -> arb:
        """L_N or T_N at these strengths: the coefficients that are known, and Cauchy's inequality beyond."""
        known = sum(
            (arb(c) * prod((d**k for d, k in zip(deltas, n)), start=arb(1)) for n, c in f.coefficients.items()), arb(0)
        )
        return known + arb(0, remainder.beyond(delta, f.order + 1).upper())
