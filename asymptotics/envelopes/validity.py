"""Where the envelope is slow: |dA/dt| <= eta omega_0 A, the condition under which Lancaster's (5) becomes (6).

For one law |dA/dt|/(omega_0 A) = kappa/(1 + (alpha-1) kappa tau) (Lancaster (14)), monotone in tau:

    alpha > 1:  slow from tau = (1/eta - 1/kappa)/(alpha-1) on (from the start if kappa <= eta): slow sooner or later
                for every strength, (15);
    alpha = 1:  always or never, as kappa <= eta or not;
    alpha < 1:  slow up to tau = (1/kappa - 1/eta)/(1-alpha), and never if kappa > eta, (17).

For a sum the rate sum_i kappa_i e^(-(alpha_i-1)s), s = -ln A, is convex in s, so that the slow amplitudes form one
interval: with laws on both sides of 1 it is slow in the middle only, between the fast drag and the final friction.

>>> slow_interval(2.0, kappa=2.0, eta=0.1), slow_interval(0.5, kappa=0.05, eta=0.1)
(SlowInterval(start=9.5, end=inf), SlowInterval(start=0.0, end=20.0))
>>> slow_interval(1.0, kappa=0.2, eta=0.1) is None
True
>>> interval = slow_amplitudes(NumericEnvelope.of([(0.0, 0.001), (2.0, 0.5)]), 0.1)
>>> round(interval.start, 6), round(interval.end, 6)
(0.010557, 0.189443)
"""

from dataclasses import dataclass
from math import exp, inf, log

from asymptotics.envelopes.numeric import NumericEnvelope
from asymptotics.errors import InputError

# e^-300 of the start stands for "down to rest"; doubles would go to e^-745.
LAST_S = 300.0


@dataclass(frozen=True)
class SlowInterval:
    """A closed interval of tau (``slow_interval``) or of amplitudes (``slow_amplitudes``)."""

    start: float
    end: float


def slow_interval(alpha: float, *, kappa: float, eta: float) -> SlowInterval | None:
    """The times tau >= 0 with |dA/dt| <= eta omega_0 A for one law, or None if there are none; double precision."""
    _require_positive(kappa=kappa, eta=eta)
    exponent = alpha - 1
    if exponent == 0:
        return SlowInterval(0.0, inf) if kappa <= eta else None
    if exponent > 0:
        return SlowInterval(max((1 / eta - 1 / kappa) / exponent, 0.0), inf)
    return SlowInterval(0.0, (1 / kappa - 1 / eta) / -exponent) if kappa <= eta else None


def slow_amplitudes(envelope: NumericEnvelope, eta: float) -> SlowInterval | None:
    """The amplitudes A in (0, 1] with |dA/dt| <= eta omega_0 A for any sum, or None; 0 stands for "down to rest".

    Heuristic: a convex function of s in [0, 300] is minimised and its two crossings of eta are found in doubles.
    """
    from scipy.optimize import brentq, minimize_scalar  # noqa: PLC0415 (slow to load, seldom asked for)

    _require_positive(eta=eta)

    def excess(s: float) -> float:
        # exp leaves the doubles at 709, and a rate of e^700 is above every eta as it is.
        total = sum(exp(min(log(k) - w * s, 700.0)) for w, k in zip(envelope.weights, envelope.kappas))
        return log(total) - log(eta)

    # The function is convex, so a bounded search finds its only minimum; it never looks at the ends, which come after.
    lowest = float(minimize_scalar(excess, bounds=(0.0, LAST_S), method="bounded", options={"xatol": 1e-12}).x)
    lowest = min((0.0, lowest, LAST_S), key=excess)
    if excess(lowest) > 0:
        return None
    first = 0.0 if excess(0.0) <= 0 else brentq(excess, 0.0, lowest, xtol=1e-13)
    last = None if excess(LAST_S) <= 0 else brentq(excess, lowest, LAST_S, xtol=1e-13)
    return SlowInterval(0.0 if last is None else exp(-last), exp(-first))


def _require_positive(**values: float) -> None:
    for name, value in values.items():
        if not 0 < value < inf:
            raise InputError(name, f"{value} is not positive and finite", "a positive number")
