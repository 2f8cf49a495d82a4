"""The quarter-swing in doubles, from which that in balls begins."""

import numpy as np
import pytest
from flint import ctx

from asymptotics.errors import UndecidedError
from asymptotics.return_map.quarters_in_doubles import QuarterInDoubles, corrected
from asymptotics.return_map.spectral import analysis, integrals


def test_corrections_in_doubles_solve_their_equation():
    """e = r + integral of (slope e) for random slopes, the integral by the matrices in balls."""
    rng = np.random.default_rng(5)
    slope, residual = rng.uniform(-0.5, 0.5, (30, 4)), rng.normal(size=(30, 4))
    with ctx.workprec(60):
        whole = np.array([[float(x.mid()) for x in row] for row in (integrals(30, 60) * analysis(30, 60)).table()[:-1]])
    e = corrected(slope, residual, 12)
    assert np.max(np.abs(residual + whole @ (slope * e) - e)) < 1e-10


def test_the_quarter_in_doubles_refuses_what_blows_up():
    strong = QuarterInDoubles(np.array([3.0]), np.array([[-9.0]]), np.array([1.5]), np.array([0.0]))
    with pytest.raises(UndecidedError):
        strong.planned(60)
