"""Extremes and passages of a sampled record, step by step: windows, lobes, numbers across gaps, and what is fitted."""

import numpy as np
import pytest

from asymptotics.decays.identification.measuring import extraction
from asymptotics.decays.identification.measuring.extraction import _assembled
from asymptotics.decays.identification.measuring.extraction import observations_of_record as observed
from asymptotics.decays.identification.measuring.extremes import Extremes, extremes_of, half_width
from asymptotics.errors import InputError


@pytest.mark.parametrize(
    ("step", "half"),
    [(0.01, 0.11), (0.0239, 0.11), (0.03, 0.138), (0.05, 0.23), (0.06, 0.26), (0.2, 0.26)],
)
def test_a_window_is_a_share_of_the_period_or_as_wide_as_nine_samples(step, half):
    """0.11 of it; 4.6 samples where that is more; 0.26 at most."""
    assert half_width(np.arange(50) * step, 1.0) == pytest.approx(half, rel=1e-2)
    assert half_width(np.arange(50) * step * 7, 7.0) == pytest.approx(7 * half, rel=1e-2)


PERIOD = 2 * np.pi
T = np.arange(0.0, 40.0, 0.05)


def test_extremes_and_passages_of_a_cosine_are_where_they_are():
    random = 1e-4 * np.random.default_rng(7).standard_normal(len(T))
    found = extremes_of(T, 2 * np.cos(T) + random, PERIOD)
    k, m = np.arange(1, 13), np.arange(0, len(found.passage_t))
    assert len(found.t) == 12 and found.t == pytest.approx(k * np.pi, abs=5e-4)  # 13 pi is 40.8
    assert found.x == pytest.approx(2 * (-1.0) ** k, abs=3e-4)
    assert len(m) >= 12 and found.passage_t == pytest.approx((m + 0.5) * np.pi, abs=3e-4)
    assert found.noise == pytest.approx(1e-4, rel=0.15)
    # The errors: of 29 samples in a window a value is known to a fraction of the noise; a passage is sharper in time.
    assert (found.sigma_x > 2e-5).all() and (found.sigma_x < 2e-4).all()
    assert np.median(found.sigma_passage) < np.median(found.sigma_t) / 2


def test_the_extreme_before_the_first_passage_counts_where_a_window_fits_about_it():
    half = half_width(T, PERIOD)
    late = lambda shift: extremes_of(T, np.cos(T - shift), PERIOD).t[0]  # noqa: E731
    assert late(half + 0.15) == pytest.approx(half + 0.15, abs=1e-3)
    assert late(half - 0.15) == pytest.approx(half - 0.15 + np.pi, abs=1e-3)
    assert late(0.0) == pytest.approx(np.pi, abs=1e-3)


def test_a_lobe_with_a_gap_in_it_has_no_extreme():
    keep = (T < 20.6) | (T > 24.2)  # from 6.56 pi to 7.7 pi: the passage at 7.5 pi is gone, and the extreme at 7 pi
    found = extremes_of(T[keep], np.cos(T[keep]), PERIOD)
    numbers = np.round(found.t / np.pi).astype(int).tolist()
    assert 7 not in numbers and {5, 9, 10} <= set(numbers)
    assert found.t == pytest.approx(np.round(found.t / np.pi) * np.pi, abs=1e-3)


def test_many_crossings_of_noise_are_one_passage():
    noise = 0.15 * np.random.default_rng(3).standard_normal(len(T))
    found = extremes_of(T, np.cos(T) + noise, PERIOD)
    assert np.diff(found.t) == pytest.approx(np.full(len(found.t) - 1, np.pi), abs=0.5)
    assert found.noise == pytest.approx(0.15, rel=0.2)


def test_a_record_without_a_lobe_has_no_extremes():
    found = extremes_of(T, 1.0 + 0.1 * np.sin(T), PERIOD)
    assert len(found.t) == len(found.x) == len(found.passage_t) == 0 and found.noise == 0.0


def points(t, passages=()):
    t = np.array(t, dtype=float)
    n, p = len(t), np.array(passages, dtype=float)
    count = np.arange(1.0, n + 1)
    return Extremes(t, (-0.9) ** count, count * 1e-3, count * 1e-2, p, np.arange(1.0, len(p) + 1) * 1e-4, 0.5)


def test_numbers_go_by_the_clock_and_passages_stand_between_their_extremes():
    found = points([1.0, 2.0, 3.0, 6.0, 7.0, 8.0], [1.5, 2.0, 2.5, 3.5, 6.5, 7.5, 8.0, 8.5])
    seen = _assembled(found, np.arange(1, 6), "mm", "name", ["a note"])
    assert seen.n.tolist() == [0, 1, 4, 5, 6] and seen.t.tolist() == [2.0, 3.0, 6.0, 7.0, 8.0]
    assert np.array_equal(seen.x, found.x[1:]) and (seen.unit, seen.name, seen.notes) == ("mm", "name", ("a note",))
    # 1.5 and 8.5 lie outside, 2.0 and 8.0 at the ends; the number of 3.5, across the gap, is not known.
    assert seen.passage_n.tolist() == [0, 4, 5] and seen.passage_t.tolist() == [2.5, 6.5, 7.5]
    assert seen.sigma_passage == pytest.approx([3e-4, 5e-4, 6e-4])
    assert np.array_equal(seen.sigma_x, found.sigma_x[1:]) and np.array_equal(seen.sigma_t, found.sigma_t[1:])


def test_values_are_taken_at_quiet_times_where_samples_lie_on_both_sides(monkeypatch):
    x = 3 * np.cos(T) + 0.2 * np.sin(2 * T)
    found = points(np.arange(1, 6) * np.pi)
    quiet = np.arange(1, 6) * np.pi + 0.02
    asked, chosen = [], np.array([0, 2, 4])
    monkeypatch.setattr(extraction, "quiet_times", lambda *given: (asked.append(given), quiet[chosen])[1])
    better = extraction._at_quiet_times(T, x, found, chosen, 0.7)
    at = quiet[chosen]
    assert better.x[chosen] == pytest.approx(3 * np.cos(at) + 0.2 * np.sin(2 * at), abs=1e-5)
    assert better.x[[1, 3]].tolist() == found.x[[1, 3]].tolist() and np.array_equal(better.t, found.t)
    ((t, own, sigma, passages, steps),) = asked
    assert np.array_equal(t, found.t[chosen]) and np.array_equal(own, found.x[chosen]) and steps.tolist() == [1, 1]
    assert np.array_equal(sigma, found.sigma_t[chosen]) and passages is found.passage_t
    from_here = T - np.pi
    for away in (from_here > -0.45, (from_here < 0.45) | (from_here > 0.75)):  # too few samples on one side
        kept = extraction._at_quiet_times(T[away], x[away], found, chosen, 0.7)
        assert kept.x[0] == found.x[0] and kept.x[2] == better.x[2]
    monkeypatch.setattr(extraction, "quiet_times", lambda *_: None)
    assert extraction._at_quiet_times(T, x, found, chosen, 0.7) is found


def decay(step=0.05, fall=0.02, span=60.0, base=0.0, drift=0.0, noise=0.0):
    t = np.arange(0, span, step)
    return t, base + drift * t + np.exp(-fall * t) * np.cos(t) + noise * np.random.default_rng(1).standard_normal(
        len(t)
    )


def test_a_base_line_is_removed_and_told_and_a_drift_where_it_is_worth_it():
    seen = observed(*decay(base=0.3, noise=1e-4))
    assert any(note.startswith("base line 0.3 removed") for note in seen.notes)
    assert seen.x[0] == pytest.approx(-np.exp(-0.02 * np.pi), abs=1e-3)
    seen = observed(*decay(base=0.3, drift=0.002, noise=1e-4))
    assert any("base line 0.3 and drift 0.002 a second removed" in note for note in seen.notes)
    assert seen.x[0] == pytest.approx(-np.exp(-0.02 * np.pi), abs=2e-3)


def test_what_is_left_without_noise_grows_with_the_window():
    """From 5e-5 at 0.11 of a period to 2e-4 at 0.26."""
    assert observed(*decay(0.05)).floor == pytest.approx(5e-5)
    step = 2 * np.pi / 24
    half = 4.6 / 24
    wide = 5e-5 + (half - 0.11) / 0.15 * 1.5e-4
    assert observed(*decay(step)).floor == pytest.approx(wide, rel=0.1)


def test_few_samples_a_period_or_uneven_ones_are_fitted_themselves():
    assert observed(*decay(2 * np.pi / 25)).samples is None and observed(*decay(2 * np.pi / 21)).samples is not None
    t, x = decay(0.05)
    assert observed(t[:49], np.cos(3 * t[:49])).samples is not None  # fewer than fifty
    steps = np.where(np.arange(1200) % 5 == 0, 0.15, 0.04)  # a fifth of the gaps are long
    uneven = np.cumsum(steps)
    assert observed(uneven, np.exp(-0.02 * uneven) * np.cos(uneven)).samples is None  # 157 a period by the median
    steps = np.where(np.arange(1200) % 5 == 0, 0.25, 0.08)
    uneven = np.cumsum(steps)
    assert observed(uneven, np.exp(-0.02 * uneven) * np.cos(uneven)).samples is not None  # 79


def test_noisy_extremes_are_left_for_the_samples():
    """Noise above 0.002 of the first amplitude, and few samples a period, or a decay down to the noise."""
    assert observed(*decay(0.05, noise=1e-3, span=80.0)).samples is None
    assert observed(*decay(0.1, noise=5e-3, span=80.0)).samples is not None  # 63 a period
    assert observed(*decay(0.05, noise=5e-3, span=80.0)).samples is None  # 126 a period, and far above the noise
    assert observed(*decay(0.05, noise=5e-3, fall=0.07)).samples is not None  # down to the noise


def test_few_extremes_are_left_for_the_samples_where_their_noise_is_seen():
    """Fewer than 20: above 0.0002 of the first amplitude the samples tell the noise, below the local fits do."""
    for span, many in ((63.5, False), (66.5, True)):  # 19 and 20 extremes about their windows
        seen = observed(*decay(0.05, noise=1e-3, span=span))
        assert (seen.samples is None) == many
    assert observed(*decay(0.05, noise=1e-4, span=60.0)).samples is None
    assert observed(*decay(0.05, noise=1e-3, span=25.0)).samples is None  # too few periods for a smooth line


def test_the_motion_is_fitted_where_it_is_asked_for():
    assert observed(*decay(0.05), whole_motion=True).samples is not None


def test_wide_angles_are_fitted_by_all_their_samples():
    t, x = decay(0.05)
    for unit, size, fitted in (("rad", 1.5, True), ("rad", 1.3, False), ("deg", 86.0, True), ("m", 1.5, False)):
        seen = observed(t, size / np.exp(-0.02 * np.pi) * x, unit=unit)
        assert (seen.samples is not None) == fitted
        if fitted:
            assert seen.notes[-1] == f"angles beyond 80 degrees: all {len(seen.samples.t)} samples fitted"
            assert seen.sigma_x == pytest.approx(np.full(len(seen.n), seen.samples.noise))
            assert seen.sigma_t == pytest.approx(seen.sigma_x / np.abs(seen.x[0])) and seen.samples.freedom == len(
                seen.samples.t
            )
            assert seen.samples.t[0] >= seen.t[0] and seen.samples.t[-1] <= seen.t[-1]


def test_a_clock_that_stands_still_is_refused_with_its_row():
    t, x = decay(0.05)
    t[7] = t[6]
    with pytest.raises(InputError, match="row 7.*the time does not increase"):
        observed(t, x)
