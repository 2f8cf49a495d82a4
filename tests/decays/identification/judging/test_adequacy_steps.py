"""Noise without a law, and whether residuals are larger: by least squares, by F and by Fisher's line, at borders."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import f

from asymptotics.decays.identification.fitting.model import Noise
from asymptotics.decays.identification.judging import adequacy
from asymptotics.decays.identification.judging.adequacy import adequate, noise_levels, smooth_noise, strongest_line
from asymptotics.present.percent import percent

N = np.arange(40)
RANDOM = np.random.default_rng(12).standard_normal(40)


@pytest.mark.parametrize("alternating", [True, False])
def test_the_noise_about_a_polynomial_is_that_of_least_squares(alternating):
    """In n (and, alternating, an offset beside it), of the degree from 1 to 13 whose AICc is least."""
    sign = (-1.0) ** N if alternating else np.ones(40)
    y = sign * (1 - 0.02 * N + 3e-4 * N**2) + 0.01 * RANDOM + 0.3 * alternating
    tried = []
    for degree in range(1, 14):
        V = np.stack(
            [*(sign * (N / 20 - 1) ** k for k in range(degree + 1)), *([np.ones(40)] if alternating else [])], 1
        )
        rss, k = ((y - V @ np.linalg.lstsq(V, y, rcond=None)[0]) ** 2).sum(), V.shape[1] + 1
        tried.append((40 * np.log(rss / 40) + 2 * k + 2 * k * (k + 1) / (39 - k), 41.0 - k, np.sqrt(rss / (41 - k))))
    _, freedom, level = min(tried)
    assert smooth_noise(N, y, alternating) == (pytest.approx(level), freedom) and freedom <= 38 - alternating


def test_half_of_the_data_stay_for_the_noise_and_numbers_may_begin_anywhere():
    y = np.exp(2.5 * np.linspace(-1, 1, 40))
    assert smooth_noise(N, y, False)[1] == 40 - 14 and smooth_noise(N + 7, y, False) == smooth_noise(N, y, False)
    assert smooth_noise(N[:12], y[:12] + 0.0 * N[:12], False)[1] >= 12 - 6
    assert smooth_noise(N[:3], y[:3], False) == (0.0, 1.0)  # no polynomial
    assert smooth_noise(N[:4], np.array([1.0, 2.0, 4.0, 9.0]), False) == (0.0, 1.0)


class Model:
    alternating = True

    def __init__(self, kinds):
        self.kinds = kinds

    def smooth_columns(self):
        return {kind: (N, kind) for kind in ("x", "t", "passage")}


def test_levels_are_those_that_are_known_or_of_the_smooth_columns(monkeypatch):
    monkeypatch.setattr(adequacy, "smooth_noise", lambda n, y, alternating: (y, alternating))
    model = Model(["x", "t", "passage"])
    assert noise_levels(model, None) == {"x": ("x", True), "t": ("t", False), "passage": ("passage", False)}
    known = noise_levels(model, Noise(x=0.1, passage=0.3))
    assert known == {"x": (0.1, 1000.0), "t": ("t", False), "passage": (0.3, 1000.0)}
    model.alternating = False
    assert noise_levels(model, None)["x"] == ("x", False)
    assert list(noise_levels(Model(["x"]), None)) == ["x"]


def test_the_level_of_samples_is_their_own_unless_it_is_known(monkeypatch):
    monkeypatch.setattr(adequacy, "WaveformModel", SimpleNamespace)
    model = SimpleNamespace(level=lambda: (0.2, 30.0))
    assert noise_levels(model, None) == {"x": (0.2, 30.0)} == noise_levels(model, Noise(t=1.0))
    assert noise_levels(model, Noise(x=0.1)) == {"x": (0.1, 1000.0)}


def residuals(x, *, freedoms=None, floor=1e-9, scale=1.0, count=40, t=()):
    """A fit that left these residuals of positions (and times)."""
    groups = [slice(0, len(x)), *([slice(len(x), len(x) + len(t))] if len(t) else [])]
    kinds = ["x", "t"][: len(groups)]
    model = SimpleNamespace(
        kinds=kinds, groups=groups, floor=lambda kind, theta: floor, seen=SimpleNamespace(n=range(count))
    )
    known = freedoms or {"x": len(x) - 3.0, "t": max(len(t) - 1.0, 1.0)}
    return SimpleNamespace(
        model=model, residuals=np.concatenate([x, t]), freedoms=known, theta=None, scales={"x": scale}
    )


WHITE = RANDOM / np.sqrt((RANDOM**2).mean())


def test_residuals_of_the_size_of_the_noise_are_adequate_and_it_is_said():
    good, said = adequate(residuals(WHITE), {"x": (1.0, 30.0)})
    assert good and said == f"x: residual {np.sqrt(40 / 37):.3g}, noise 1"
    good, said = adequate(residuals(3 * WHITE), {"x": (1.0, 30.0)})
    assert not good and said.startswith(f"x: residual {3 * np.sqrt(40 / 37):.3g}, noise 1 (too large)")
    assert adequate(residuals(3 * WHITE), {"x": (1.0, 4.9)}) == (True, "")  # a level of few data is worth no verdict
    assert (
        not adequate(residuals(20 * WHITE), {"x": (1.0, 5.0)})[0]
        and adequate(residuals(3 * WHITE), {"x": (0.0, 30.0)})[0]
    )
    assert adequate(residuals(3 * WHITE, floor=3.0), {"x": (1.0, 30.0)})[0]  # the arithmetic's
    assert adequate(residuals(3 * WHITE), {"x": (1.0, 30.0)}, left=0.1)[0]


def test_each_kind_is_judged_and_one_that_is_too_large_is_enough():
    levels = {"x": (1.0, 30.0), "t": (1.0, 30.0)}
    good, said = adequate(residuals(WHITE, t=4 * WHITE), levels)
    assert not good and "; t: residual" in said and said.count("too large") == 1
    good, said = adequate(residuals(4 * WHITE, t=WHITE), levels)
    assert not good and said.index("too large") < said.index("t: residual")


def test_one_value_alone_refutes_no_law():
    wild = WHITE.copy()
    wild[7] = 60.0
    good, said = adequate(residuals(wild), {"x": (1.0, 30.0)})
    rest = np.sqrt((np.delete(wild, 7) ** 2).sum() / 36)
    assert good and f" ({rest:.3g} but for one value)" in said
    wild[8] = -50.0
    assert not adequate(residuals(wild), {"x": (1.0, 30.0)})[0]


def test_larger_is_what_f_makes_improbable_and_a_third_above():
    edge = np.sqrt(f.isf(1e-4, 20, 30))
    assert adequacy._exceeds(1.001 * edge, 20, 1.0, 30) and not adequacy._exceeds(0.999 * edge, 20, 1.0, 30)
    assert adequacy._exceeds(2.002 * edge, 20, 2.0, 30) and not adequacy._exceeds(1.998 * edge, 20, 2.0, 30)
    assert adequacy._exceeds(1.301, 1e5, 1.0, 1e5) and not adequacy._exceeds(1.3, 1e5, 1.0, 1e5)
    one = np.sqrt(f.isf(1e-4, 1, 30))
    assert adequacy._exceeds(1.001 * one, 0.1, 1.0, 30) and not adequacy._exceeds(0.999 * one, 0.1, 1.0, 30)


@pytest.mark.parametrize("k", [1, 3, 7])
def test_the_strongest_line_is_that_of_the_spectrum(k):
    n = np.arange(48)
    r = 5.0 + np.cos(2 * np.pi * k * n / 48) + 0.2 * np.random.default_rng(3).standard_normal(48)
    share, frequency, p = strongest_line(r)
    power = np.array([abs(((r - r.mean()) * np.exp(-2j * np.pi * j * n / 48)).sum()) ** 2 for j in range(25)])
    assert frequency == k / 48 and share == pytest.approx(power[max(k - 1, 0) : k + 2].sum() / power.sum())
    g = power[k] / power.sum()
    assert p == pytest.approx(24 * (1 - g) ** 23) and p < 1e-4
    assert strongest_line(np.ones(48)) == (0.0, 0.0, 1.0) and strongest_line(WHITE)[2] <= 1.0
    assert strongest_line(np.random.default_rng(1).standard_normal(48))[2] > 1e-4


LINE = np.sqrt(2) * np.cos(2 * np.pi * 2 * N / 40)


@pytest.mark.parametrize(
    ("changed", "adequate_"),
    [({}, False), ({"count": 23}, True), ({"count": 24}, False), ({"scale": 1e-9}, True), ({"left": 0.5}, True)],
)
def test_residuals_that_are_one_line_are_no_noise(changed, adequate_):
    """Of 24 swings at least, above the arithmetic's floor, and not where something unseen is allowed for."""
    left = changed.pop("left", 1.0) if changed else 1.0
    good, said = adequate(residuals(LINE + 0.05 * WHITE, **changed), {"x": (1.0, 30.0)}, left)
    assert good == adequate_
    assert (" % of the residual of x is one line at 0.05 cycles a half-swing" in said) == (not adequate_)
    if not adequate_:
        assert said.split("; ")[1].startswith(f"{percent(strongest_line(LINE + 0.05 * WHITE)[0])} of")


def test_a_line_of_half_the_power_is_no_line():
    mixed = LINE + 2 * WHITE
    assert strongest_line(mixed)[0] < 0.55 and adequate(residuals(mixed), {"x": (2.5, 30.0)})[0]
