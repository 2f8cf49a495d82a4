"""How far two laws lie apart for data never measured: the noiseless motion of one, and the best fit of the other."""

import numpy as np
import pytest

from asymptotics.decays.identification.fitting.model import Noise
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.judging.laws import UNTRIED
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.synthetic import exact, observed
from asymptotics.decays.identification.telling import verdicts
from asymptotics.decays.identification.telling.verdicts import UNDECIDED, separation, undecided
from tests.decays.identification.small_laws import law

SEEN = observed("2", [0.1], 20, 1e-3, seed=5, x0=2.0)


def of(text, seen):
    return law(text, fit_law(read(text), seen).fit)


@pytest.mark.parametrize("last", [20, 30])
def test_the_separation_is_that_of_the_best_other_law_for_exact_data(last):
    """By the exact turning points of 2 and a fit of 1 to them, in units of the noise."""
    one, other = of("2", SEEN), of("1", SEEN)
    found = separation(one, other, SEEN, last, Noise(x=0.01))
    size, strength = np.exp(one.fit.theta[0]), one.fit.theta[1]  # of the reference, which is near 2
    n = np.arange(last + 1)
    run = exact("2", [strength * size], last)
    x = SEEN.reference * size * np.exp(run.a) * (-1.0) ** n + one.fit.theta[2]
    again = fit_law(read("1"), type(SEEN).of(n, x), Noise(x=0.01)).fit
    assert found == pytest.approx(again.chi2, rel=1e-3) and found > 50
    quarter = separation(one, other, SEEN, last, Noise(x=0.02))
    assert quarter == pytest.approx(found / 4, rel=1e-3)


def test_times_count_where_they_were_measured():
    timed = observed("1+s3", [0.02, 0.2], 20, 1e-3, 1e-3, seed=5)
    one, other = of("1+s3", timed), of("1", timed)
    with_times = separation(one, other, timed, 20, Noise(x=1e-3, t=1e-3))
    assert with_times > 1000  # the spring is seen by the clock alone
    assert separation(one, one, timed, 20, Noise(x=1e-3, t=1e-3)) < 1e-3


def test_a_motion_that_ends_too_soon_separates_nothing():
    dry = observed("0", [0.02], 15, 1e-3, seed=5)  # 25 half-swings in all
    assert separation(of("0", dry), of("1", dry), dry, 40, Noise(x=1e-3)) is None
    assert separation(of("0", dry), of("1", dry), dry, 18, Noise(x=1e-3)) > 10


def test_where_the_other_law_has_no_fit_nothing_is_told(monkeypatch):
    monkeypatch.setattr(verdicts, "fit_law", lambda *_: law("1", None).fitted)
    assert separation(of("2", SEEN), of("1", SEEN), SEEN, 20, Noise(x=0.01)) is None


def test_an_undecided_verdict_names_six_laws_that_stand(monkeypatch):
    standing = [law(text, object()) for text in ("0", "1", "2", "3", "1/2", "3/2", "5/2")]
    monkeypatch.setattr(verdicts, "rivals", lambda laws: (standing, []))
    found = undecided([law("0+1", None, missed=UNTRIED), *standing])
    assert found.kind == UNDECIDED and found.text.endswith(
        "before 1 of 8 laws were judged; consistent so far: 0; 1; 2; 3; 1/2; 3/2"
    )
    assert undecided(standing) is None
