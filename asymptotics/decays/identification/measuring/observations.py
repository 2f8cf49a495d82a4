"""What was measured: turning points x_n with their numbers, and times where there are any.

>>> seen = Observations.of([0, 1, 2], [1.0, -0.9, 0.81])
>>> seen.sign, seen.has_times, seen.reference
(array([ 1., -1.,  1.]), False, 1.0)
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.late_extremes import Window
from asymptotics.numbers.alike import Alike
from asymptotics.present.counts import many

Indices = NDArray[np.intp]


_OF_POINTS, _OF_PASSAGES = ("n", "x", "t", "sigma_x", "sigma_t"), ("passage_n", "passage_t", "sigma_passage")
_TWO = ", two in a period (of peaks of one side: call their column cycle)"


@dataclass(frozen=True, eq=False)
class Samples(Alike):
    """The motion as it was sampled, or a ``derivative`` of it; ``noise`` about a smooth line, with its degrees of
    ``freedom``, and its ``memory``, the correlation of neighbours; ``mode``: where the fit of a second mode begins, its
    cosine and sine at the first sample, its frequency and its rate of decay (empty: there is none); ``slow``: columns
    of which any sum is fitted beside every law, those of a base line that wanders by up to ``wander`` (None: there are
    none)."""

    t: Array
    x: Array
    noise: float
    freedom: float
    memory: float = 0.0
    derivative: int = 0
    mode: tuple[float, ...] = ()
    slow: Array | None = None
    wander: float = 0.0


@dataclass(frozen=True, eq=False)
class Observations(Alike):
    """Turning points of one run, numbered from 0; gaps in ``n`` are allowed.

    ``x``: signed positions, in the unit of the file; ``t``: turning times (empty: none); ``passage_n``,
    ``passage_t``: times at which x crosses 0 after turning point n (empty: none); ``sigma_x``, ``sigma_t``,
    ``sigma_passage``: standard errors known from elsewhere (empty: unknown); ``notes``: what was found and discarded
    on the way here; ``floor``: the error, as a share of the first amplitude and of 1/omega_0, that is there without
    noise too; ``samples``: the motion itself, where it is fitted and the turning points only start the fit;
    ``time_unit``: that of the file, in which a period is told (empty: s), while ``t`` is in s; ``stride``: how many
    true half-swings one n of an envelope counts (0 where nobody says), and ``spacing`` the time between two
    (``ringdown``); ``window``: that of the local fits which found the turning times, and find them late (None: measured
    otherwise); ``record``: the samples in which they were found, about the base line, for the picture alone;
    ``written``: the unit of the file where it is none of those that are known, such as V; ``no_law``: why it can tell
    no law from another, and none is tried (empty: it may).
    """

    n: Indices
    x: Array
    t: Array
    passage_n: Indices
    passage_t: Array
    sigma_x: Array
    sigma_t: Array
    sigma_passage: Array
    unit: str = ""
    name: str = ""
    notes: tuple[str, ...] = ()
    floor: float = 0.0
    samples: Samples | None = None
    time_unit: str = ""
    stride: float = 1.0
    spacing: float | None = None
    window: Window | None = None
    record: tuple[Array, Array] | None = None
    written: str = ""
    no_law: str = ""

    @classmethod
    def of(
        cls,
        n: Sequence[int] | Indices,
        x: Sequence[float] | Array,
        t: Sequence[float] | Array = (),
        *,
        passage_n: Sequence[int] | Indices = (),
        passage_t: Sequence[float] | Array = (),
        sigma_x: Sequence[float] | Array = (),
        sigma_t: Sequence[float] | Array = (),
        sigma_passage: Sequence[float] | Array = (),
        unit: str = "",
        name: str = "",
        notes: Sequence[str] = (),
        floor: float = 0.0,
    ) -> "Observations":
        """From any sequences, named as the fields; unsigned amplitudes ``x`` are given alternating signs.

        ``n``: the numbers of the turning points (empty: 0, 1, ...), ``x`` and ``t`` theirs, in ``unit`` and in s;
        ``passage_n``, ``passage_t``: the passages through 0; ``sigma_x``, ``sigma_t``, ``sigma_passage``: standard
        deviations; ``name``, ``notes``: of the run; ``floor``: the error that is there without noise too.
        """
        number = np.asarray(n, dtype=np.intp)
        position = np.asarray(x, dtype=float)
        text = tuple(notes)
        alternate = np.where((number - number[0]) % 2, -1.0, 1.0)
        # A decay about a base line changes sign at every turning point: values of one sign are amplitudes.
        if len(position) > 1 and ((position > 0).all() or (position < 0).all()):
            position = np.abs(position) * alternate
            text = (*text, f"the values have one sign: read as amplitudes |x_n|{_TWO * bool((alternate < 0).any())}")
        floats = (np.asarray(v, dtype=float) for v in (t, passage_t, sigma_x, sigma_t, sigma_passage))
        time, crossing, s_x, s_t, s_p = floats
        first = int(number[0])
        return cls(
            number - first, position, time, np.asarray(passage_n, dtype=np.intp) - first, crossing, s_x, s_t, s_p,
            unit, name, text, floor,
        )  # fmt: skip

    def as_envelope(self, stride: float, spacing: float, notes: tuple[str, ...]) -> "Observations":
        """The same numbers as an artificial clock of an envelope: each ``stride`` half-swings, ``spacing`` s apart.

        ``notes``: what was found on the way there.
        """
        return replace(self, stride=stride, spacing=spacing, notes=notes)

    @property
    def omega(self) -> float | None:
        """The angular frequency of an envelope, in rad/s, if known; None for turning points, whose times tell it."""
        return None if self.spacing is None or self.without_frequency else np.pi * self.stride / self.spacing

    @property
    def without_frequency(self) -> bool:
        """Whether it is an envelope of which nobody says how fast it swings."""
        return self.stride == 0

    @property
    def sign(self) -> Array:
        """The sign of x_n: it alternates, whatever the noise does."""
        # By all of them together: a late one may have lost its sign to noise.
        first = 1.0 if (self.x * np.where(self.n % 2, -1.0, 1.0)).sum() >= 0 else -1.0
        return first * np.where(self.n % 2, -1.0, 1.0)

    @property
    def has_times(self) -> bool:
        """Whether turning times are known."""
        return len(self.t) > 0

    @property
    def inside(self) -> NDArray[np.bool_]:
        """Which turning points were measured: the outermost ones of a smooth line may lie beyond its samples."""
        if self.samples is None:
            return np.ones(len(self.n), dtype=bool)
        t = self.samples.t
        # A sample further than the last one, or a tenth of a half-swing, is not beyond what they tell.
        near = min(float(np.median(np.diff(t))), 0.1 * float(np.median(np.diff(self.t))))
        return np.asarray((self.t >= t[0] - near) & (self.t <= t[-1] + near))

    @property
    def sizes(self) -> Array:
        """|x| at the turning points that were measured."""
        return np.asarray(np.abs(self.x[self.inside]))

    @property
    def reference(self) -> float:
        """The amplitude at which strengths are compared: the first that was measured."""
        return float(self.sizes[0])

    @property
    def last(self) -> int:
        """The number of the last turning point."""
        return int(self.n[-1])

    def up_to(self, last: int) -> "Observations":
        """The turning points n <= ``last`` only, and the passages between them."""
        keep, inside = self.n <= last, self.passage_n < last
        cut: dict[str, Any] = {name: _kept(getattr(self, name), keep) for name in _OF_POINTS}
        crossings: dict[str, Any] = {name: _kept(getattr(self, name), inside) for name in _OF_PASSAGES}
        return replace(self, **cut, **crossings, samples=None)

    def since(self, place: int) -> "Observations":
        """The turning points from the one at ``place`` on, numbered from 0, and the passages behind; no samples."""
        kept: dict[str, Any] = {name: _kept(getattr(self, name), slice(place, None)) for name in _OF_POINTS}
        later = self.passage_n >= self.n[place]
        crossings: dict[str, Any] = {name: _kept(getattr(self, name), later) for name in _OF_PASSAGES}
        start = self.n[place]
        kept |= {**crossings, "n": kept["n"] - start, "passage_n": crossings["passage_n"] - start}
        return replace(self, **kept, samples=None)

    def between(self, low: float, high: float) -> "Observations":
        """The longest stretch of turning points with ``low`` <= |x_n| <= ``high``; the numbering starts with it."""
        inside = np.flatnonzero((np.abs(self.x) >= low) & (np.abs(self.x) <= high))
        pieces = np.split(inside, np.flatnonzero(np.diff(inside) > 1) + 1)
        # A stretch, not all that fits: a beat comes back into the range, and belongs to another decay.
        chosen = max(pieces, key=len)
        passages = np.isin(self.passage_n, self.n[chosen[:-1]])
        found = Observations.of(
            self.n[chosen],
            self.x[chosen],
            self.t[chosen] if len(self.t) else (),
            passage_n=self.passage_n[passages],
            passage_t=self.passage_t[passages],
            sigma_x=self.sigma_x[chosen] if len(self.sigma_x) else (),
            sigma_t=self.sigma_t[chosen] if len(self.sigma_t) else (),
            sigma_passage=self.sigma_passage[passages] if len(self.sigma_passage) else (),
            floor=self.floor,
            unit=self.unit,
            name=self.name,
            notes=(*self.notes, f"{many(len(chosen), 'turning point')} with amplitudes from {low:.4g} to {high:.4g}"),
        )
        return replace(
            found, stride=self.stride, spacing=self.spacing, window=self.window, time_unit=self.time_unit,
            written=self.written,
        )  # fmt: skip

    @property
    def shown_unit(self) -> str:
        """The unit of x as it is told: one that is known, or the one that the file writes."""
        return self.unit or self.written

    def without_times(self) -> "Observations":
        """The amplitudes alone."""
        empty = np.array([])
        return replace(
            self, t=empty, passage_n=np.array([], dtype=np.intp), passage_t=empty, sigma_t=empty, sigma_passage=empty,
            samples=None,
        )  # fmt: skip


def _kept(values: NDArray[np.generic], keep: NDArray[np.bool_] | slice) -> NDArray[np.generic]:
    return values[keep] if len(values) else values
