"""Decays whose law is known, by an integrator of their own: SciPy, one half-swing after the other, events at v = 0.

Nothing of ``identification`` makes them: x'' + S(x) + sum_i epsilon_i x'|x'|^(alpha_i - 1) = 0 with S = x, x + c x^3 or
sin x is integrated between turning points, where the force is smooth; then it is sampled and spoiled as its class says.

>>> made = decay("plain", 0)
>>> made.law, len(made.strengths), sorted(made.data)
('1', 1, ['t', 'x'])
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from math import gamma, pi, sqrt
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

Array = NDArray[np.float64]
LAWS = (("1",), ("2",), ("1", "2"), ("0", "1"), ("0", "2"))
CLASSES = (
    "turning points", "plain", "sparse", "uneven", "velocity", "acceleration", "coloured", "quantised", "jitter",
    "drift", "cubic spring", "pendulum", "strong", "short", "unquiet tail",
)  # fmt: skip
SEED = 20261126_43


@dataclass(frozen=True)
class Decay:
    """One record: its class, ``law`` as ``identify`` names it, the strengths at 1 unit of x (of the losses, then of the
    spring), the columns, and what must be said of them."""

    kind: str
    law: str
    strengths: tuple[float, ...]
    data: dict[str, Array]
    said: dict[str, Any] = field(default_factory=dict)


def fall(alpha: float) -> float:
    """By how much ln A falls in a half-swing, to first order, at local strength 1.

    >>> round(fall(1.0), 9), round(fall(2.0), 9)
    (1.570796327, 1.333333333)
    """
    return sqrt(pi) * gamma(alpha / 2 + 1) / gamma((alpha + 3) / 2)


def half_swings(
    spring: Callable[[float], float], losses: Sequence[tuple[float, float]], start: float, until: float
) -> Iterator[tuple[float, float, Callable[[Array], Array]]]:
    """(begin, end, dense (x, x') between) of each half-swing from rest at ``start``; none where dry friction sticks."""
    dry = sum(e for alpha, e in losses if alpha == 0)
    now, at = 0.0, start
    while now < until and abs(spring(at)) > dry:
        way = -float(np.sign(at))

        def force(_: float, y: Array, way: float = way) -> list[float]:
            speed = max(way * y[1], 0.0)
            return [y[1], -spring(y[0]) - way * sum(e * speed**alpha for alpha, e in losses)]

        def stop(_: float, y: Array, way: float = way) -> float:
            return float(way * y[1])

        stop.terminal, stop.direction = True, -1  # type: ignore[attr-defined]
        kick = [at, way * 1e-13 * abs(start)]
        found = solve_ivp(
            force,
            (now, now + 60),
            kick,
            events=stop,
            rtol=1e-10,
            atol=1e-12 * abs(start),
            dense_output=True,
            method="DOP853",
        )
        yield now, float(found.t[-1]), found.sol
        now, at = float(found.t[-1]), float(found.y[0, -1])


def motion(
    spring: Callable[[float], float], losses: Sequence[tuple[float, float]], start: float, tau: Array
) -> tuple[Array, Array]:
    """(x, x') at increasing times from rest; rest where the spring no longer overcomes dry friction.

    >>> t = np.linspace(0, 20, 5)
    >>> x, _ = motion(lambda x: x, [(1.0, 0.1)], 1.0, t)
    >>> w = np.sqrt(1 - 0.05**2)
    >>> bool(np.abs(x - np.exp(-0.05 * t) * (np.cos(w * t) + 0.05 / w * np.sin(w * t))).max() < 1e-8)
    True
    """
    x, v = np.full(len(tau), start), np.zeros(len(tau))
    for begin, end, between in half_swings(spring, losses, start, float(tau[-1])):
        inside = (tau >= begin) & (tau <= end)
        if inside.any():
            x[inside], v[inside] = between(tau[inside])
        x[tau > end] = between(np.array(end))[0]
    return x, v


def decay(kind: str, index: int, seed: int = SEED) -> Decay:
    """Record ``index`` of a class; another ``seed`` makes another set."""
    random = np.random.default_rng([seed, CLASSES.index(kind), index])
    law = LAWS[index % len(LAWS)]
    swings, omega = int(random.integers(24, 70)), float(np.exp(random.uniform(-0.7, 2.3)))
    start = float(np.radians(random.uniform(5, 80))) if kind == "pendulum" else float(10 ** random.uniform(-1.5, 1.5))
    if kind in ("strong", "short"):
        swings = int(random.integers(9, 20))
    share = float(random.uniform(0.3, 0.7))
    parts = (share, 1 - share) if len(law) == 2 else (1.0,)
    depth = float(random.uniform(0.6, 1.4)) * (0.6 if "0" in law else 1.0) * (2.0 if kind == "strong" else 1.0)
    alphas = [float(a) for a in law]
    losses = [(a, depth * p / (fall(a) * swings) * start ** (1 - a)) for a, p in zip(alphas, parts)]
    cubic = float(random.uniform(0.02, 0.15)) / start**2 if kind == "cubic spring" else 0.0
    pendulum = kind == "pendulum"
    spring: Callable[[float], float] = (lambda x: float(np.sin(x))) if pendulum else (lambda x: x + cubic * x**3)
    name = "+".join(law) + {"cubic spring": "+s3", "pendulum": "+pendulum"}.get(kind, "")
    strengths = (*(e for _, e in losses), *([cubic] if cubic else []))
    noise = 10 ** float(random.uniform(-3.3, -2)) * start
    if kind == "turning points":
        return Decay(kind, name, strengths, _turning(spring, losses, start, swings, noise, random))
    tau = _times(kind, swings, random)
    x, v = motion(spring, losses, start, tau)
    t = tau / omega
    column, values, size = "x", x, 1.0
    if kind == "velocity":
        column, values, size = "v", omega * v, omega
    elif kind == "acceleration":
        acceleration = -x - sum(e * np.sign(v) * np.abs(v) ** a for a, e in losses)
        column, values, size = "a", omega**2 * acceleration, omega**2
    values = _spoiled(kind, values, size * noise, size * start, random)
    if kind == "jitter":
        step = float(np.median(np.diff(t)))
        t = np.sort(t + 0.15 * step * random.standard_normal(len(t)))
    return Decay(kind, name, strengths, {"t": t, column: values}, {"unit": "rad"} if kind == "pendulum" else {})


def _times(kind: str, swings: int, random: np.random.Generator) -> Array:
    """omega_0 t of the samples."""
    span = np.pi * swings
    if kind == "sparse":
        return np.arange(0.3, span, 2 * np.pi / random.uniform(3.2, 18))
    if kind == "uneven":
        return np.sort(random.uniform(0, span, int(swings / 2 * random.uniform(8, 25))))
    return np.arange(0.3, span, 2 * np.pi / random.uniform(40, 120))


def _spoiled(kind: str, values: Array, noise: float, size: float, random: np.random.Generator) -> Array:
    """The values with what a sensor of this class adds."""
    drawn = random.standard_normal(len(values))
    if kind == "coloured":
        rho = float(random.uniform(0.3, 0.95))
        for i in range(1, len(drawn)):
            drawn[i] = rho * drawn[i - 1] + np.sqrt(1 - rho**2) * drawn[i]
    spoiled = values + noise * drawn
    if kind in ("drift", "velocity", "acceleration"):
        low, high = random.uniform(-0.2, 0.2, 2) * size
        spoiled = spoiled + np.linspace(low, high, len(values))
    if kind == "unquiet tail":
        # A slow disturbance that begins late, as of a draught, 2 to 5 % of the first amplitude.
        u = np.linspace(0.0, 1.0, len(values))
        late = 1 / (1 + np.exp(-(u - random.uniform(0.6, 0.8)) * 40))
        size_late, turns = random.uniform(0.02, 0.05) * size, random.uniform(1, 3)
        spoiled = spoiled + late * size_late * np.sin(2 * np.pi * turns * u + random.uniform(0, 6))
    if kind == "quantised":
        step = float(random.uniform(0.003, 0.02)) * size
        spoiled = np.round(spoiled / step) * step
    return np.asarray(spoiled)


def _turning(
    spring: Callable[[float], float], losses: Sequence[tuple[float, float]], start: float, swings: int, noise: float,
    random: np.random.Generator,
) -> dict[str, Array]:  # fmt: skip
    """n and x_n, without times."""
    found = [start]
    for _, end, between in half_swings(spring, losses, start, np.pi * swings):
        found.append(float(between(np.array(end))[0]))
    x = np.array(found) + noise * random.standard_normal(len(found))
    return {"n": np.arange(len(found), dtype=float), "x": x}
