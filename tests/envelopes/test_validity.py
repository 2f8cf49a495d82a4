"""Where an envelope is slow: against the rate, at each time and amplitude."""

import numpy as np
import pytest

from asymptotics.envelopes.numeric import NumericEnvelope
from asymptotics.envelopes.validity import slow_amplitudes, slow_interval
from asymptotics.errors import InputError

SETS = [
    ((0, "0.1"),), ((1, "0.1"),), ((1.5, "0.3"),), ((0.5, "0.2"),), ((0, "0.1"), (2, "0.3")), ((1, "0.1"), (2, "5")),
    ((0, "0.01"), (1, "0.2"), (3, "2")), ((0.5, "0.1"), (0.75, "0.1")), ((1.25, "0.5"), (7, "3")),
]  # fmt: skip


@pytest.mark.parametrize("alpha", [0.0, 0.5, 1.0, 1.5, 3.0])
@pytest.mark.parametrize("kappa", [0.02, 0.5])
def test_slow_interval_against_the_rate(alpha, kappa):
    eta = 0.1
    interval = slow_interval(alpha, kappa=kappa, eta=eta)
    envelope = NumericEnvelope.of([(float(alpha), kappa)])
    end = envelope.extinction_time or 200.0
    tau = np.linspace(0, end * 0.999, 2001)
    slow = kappa * envelope.amplitude(tau) ** (alpha - 1) <= eta
    claimed = np.zeros_like(slow) if interval is None else (tau >= interval.start) & (tau <= interval.end)
    assert np.array_equal(slow, claimed)


def test_slow_amplitudes_of_sums():
    for laws in SETS:
        envelope = NumericEnvelope.of([(a, float(k)) for a, k in laws])
        interval = slow_amplitudes(envelope, 0.25)
        A = np.geomspace(1e-6, 1, 4001)
        slow = sum(float(k) * A ** (float(a) - 1) for a, k in laws) <= 0.25 * (1 + 1e-12)
        if interval is None:
            assert not slow.any()
        else:
            first, last = interval.start * (1 - 1e-9), interval.end * (1 + 1e-9)
            assert np.array_equal(slow, (first <= A) & (last >= A))
    with pytest.raises(InputError, match="eta"):
        slow_interval(2.0, kappa=0.1, eta=0.0)
    with pytest.raises(InputError, match="kappa"):
        slow_interval(2.0, kappa=-0.1, eta=0.1)
