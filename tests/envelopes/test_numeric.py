"""NumPy evaluation against the certified balls; NaN, extinction, negative times."""

from fractions import Fraction
from math import inf

import numpy as np
import pytest
from flint import arb, ctx

from asymptotics.envelopes import certified
from asymptotics.envelopes.numeric import NumericEnvelope
from asymptotics.errors import InputError
from asymptotics.numbers.exact import ExactReal

SETS = [
    ((0, "0.1"),), ((1, "0.1"),), ((1.5, "0.3"),), ((0.5, "0.2"),), ((0, "0.1"), (2, "0.3")), ((1, "0.1"), (2, "5")),
    ((0, "0.01"), (1, "0.2"), (3, "2")), ((0.5, "0.1"), (0.75, "0.1")), ((1.25, "0.5"), (7, "3")),
]  # fmt: skip


def exact(laws):
    return [(ExactReal(Fraction(a)), arb(k)) for a, k in laws]


@pytest.mark.parametrize("laws", SETS)
def test_against_balls(laws):
    envelope = NumericEnvelope.of([(a, float(k)) for a, k in laws])
    tau = np.array([0.0, 0.3, 2.0, 4.0])
    A = envelope.amplitude(tau)
    with ctx.workprec(120):
        for t, a in zip(tau, A):
            assert abs(certified.amplitude(exact(laws), arb(t)) - float(a)) < 4e-15
    assert np.allclose(envelope.time(A), tau, rtol=1e-12, atol=1e-12)
    end = certified.extinction_time(exact(laws))
    if end is None:
        assert envelope.extinction_time is None
        late = certified.amplitude(exact(laws), arb(500))
        assert abs(late - float(envelope.amplitude(500.0))) < 1e-11 * abs(late)
    else:
        assert abs(end - envelope.extinction_time) < 1e-11 * end
        assert envelope.amplitude(envelope.extinction_time * 1.0001) == 0
        assert envelope.amplitude(envelope.extinction_time * 0.99) > 0


@pytest.mark.parametrize("laws", [[(0.5, 0.1), (2, 0.2)], [(3, 1.0), (5, 1.0)]], ids=str)
def test_a_table_ends_where_doubles_do(laws):
    """At an extinction the times fall together, for strong laws they overflow: neither is in the table."""
    made = NumericEnvelope.of(laws)
    assert np.all(np.isfinite(made.times)) and np.all(np.diff(made.times) > 0)
    assert 20 < len(made.times) == len(made.edges) < 2800 * max(a for a, _ in laws)


def test_arrays_keep_nan_and_shape():
    envelope = NumericEnvelope.of([(0.0, 0.1), (2.0, 0.1)])
    A = envelope.amplitude(np.array([[0.0, np.nan], [1.0, 1e6]]))
    assert A.shape == (2, 2)
    assert A[0, 0] == 1
    assert np.isnan(A[0, 1])
    assert A[1, 1] == 0
    assert np.isnan(NumericEnvelope.of([(2.0, 0.1)]).amplitude(np.nan))
    assert NumericEnvelope.of([(0.0, 0.1)]).amplitude(10.0) == 0
    assert NumericEnvelope.of([(1.0, 0.1), (2.0, 0.1)]).amplitude(1e9) == 0


@pytest.mark.parametrize("laws", [((2.0, 0.1),), ((1.0, 0.1), (2.0, 0.1))])
def test_refusals(laws):
    envelope = NumericEnvelope.of(laws)
    with pytest.raises(InputError, match="time"):
        envelope.amplitude([-1.0])
    for bad in (0.0, 1.5, -1.0):
        with pytest.raises(InputError, match="amplitude"):
            envelope.time([bad])
    for bad_laws in ([(1.0, -1.0)], [(1.0, inf)], [(1.0, float("nan"))], [(1.0, 0.0)], []):
        with pytest.raises(InputError):
            NumericEnvelope.of(bad_laws)


def test_a_million_evaluations_agree_with_a_few():
    tau = np.linspace(0, 50, 10**6)
    for laws in ([(1.5, 0.1)], [(1.0, 0.1), (2.0, 0.1)]):
        envelope = NumericEnvelope.of(laws)
        assert np.allclose(envelope.amplitude(tau)[::250_000], envelope.amplitude(tau[::250_000]), rtol=1e-12)
