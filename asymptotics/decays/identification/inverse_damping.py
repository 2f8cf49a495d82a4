"""From a table of equivalent damping to the law: (A, zeta), (A, Q) or (A, decrement) with resolutions.

The field's words are equivalent linearisation (Bogoliubov and Mitropolsky) and nonnegative least squares (Lawson and
Hanson 1974).

To first order zeta(A) = sum_i b_i z_i(A) is linear in the strengths: z_i, the zeta of a unit strength, comes from the
certified cycle (``equivalent.conservative_cycle``), and the rest is least squares in doubles, weighted by the
resolutions, with strengths >= 0.

    zeta = 1/(2 Q) = decrement/(2 pi),     chi^2 = sum ((zeta_j - sum_i b_i z_i(A_j))/s_j)^2.

Intervals are profiles: where chi^2, minimised over the other strengths, has risen by 3.84 (95 %).  The problem is
linear with a bound at 0, so that each point of a profile is one call of least squares with strengths >= 0, where
``fitting.profile`` iterates a nonlinear one without bounds.  The criterion and the grades are those of measured decays
(``measuring.criteria``, ``judging.grades``).  A candidate is

    consistent   if chi^2 is not too large for its degrees of freedom (5 %),
    adequate     else, if what it leaves is at most a tenth of the loss (told in %),
    refuted      else.

A law that is refuted by chi^2 has errors as large as its misfit: chi^2 per degree of freedom widens its intervals
(Birge's ratio); those of a consistent one are of the resolutions.  Without resolutions they are taken equal, as large
as the best candidate needs: then nothing is refuted by chance alone.  Such a resolution, of n degrees of freedom, is
itself uncertain, so that the rise is the quantile of F with 1 and n, the square of Student's t.

>>> A = [0.1, 0.2, 0.4, 0.8]
>>> found = fitted(A, [0.012, 0.0141, 0.0178, 0.0261], [2e-4] * 4, Problem("zeta", (("1",), ("2",), ("1", "2"))))
>>> [(fit.name, fit.grade) for fit in found]
[('1+2', 'consistent'), ('1', 'refuted'), ('2', 'refuted')]
>>> [f"{s.low:.3f} {s.estimate:.3f} {s.high:.3f}" for s in found[0].strengths]
['0.019 0.020 0.021', '0.046 0.047 0.049']
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

import numpy as np
from scipy.optimize import brentq, nnls
from scipy.special import chdtrc, fdtri

from asymptotics.decays.identification.between_amplitudes import means
from asymptotics.decays.identification.judging.grades import grade_of, in_words, off
from asymptotics.decays.identification.measuring.criteria import aicc
from asymptotics.equivalent.rows import cycle_of
from asymptotics.law import Oscillator
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.policy import exact_number
from asymptotics.present.shown import Page, Shown
from asymptotics.running.budget import tick

QUANTITIES = ("zeta", "Q", "decrement")
LEVEL = 0.05
"""Of chi^2: a table has few rows, and its resolutions are known, so that one law in twenty may be refuted by chance."""
RISE = 3.84
"""The quantile 0.95 of chi^2 with one degree of freedom."""
_LOW = 53
"""Bits of the balls of a unit strength: only their middles are used, in doubles."""


@dataclass(frozen=True)
class Problem:
    """What was measured, the candidates (exponents of each), and the oscillator: mass, stiffness and spring.

    ``between``: what was measured is a loss from one amplitude to another, and each place is a pair of them.
    """

    quantity: str
    candidates: tuple[tuple[str, ...], ...]
    mass: Any = 1
    stiffness: Any = 1
    spring: Any = None
    between: bool = False


@dataclass(frozen=True, repr=False)
class Strength(Shown):
    """b (epsilon without units) of one term with its 95 % interval; ``low`` is 0 where the data do not need it."""

    alpha: str
    low: float
    estimate: float
    high: float

    def _page(self) -> Page:
        """The estimate with its interval."""
        title = f"strength of v^{self.alpha} = {self.estimate:.4g} [{self.low:.4g}, {self.high:.4g}]"
        return Page(title, ("estimate, profile 95 %",))


@dataclass(frozen=True, repr=False)
class DampingCandidate(Shown):
    """One law: its strengths, what is left of the loss (root mean square, relative), chi^2, p, AICc and the grade."""

    name: str
    strengths: tuple[Strength, ...]
    left: float
    chi_squared: float
    p: float
    criterion: float
    grade: str

    @property
    def unneeded(self) -> tuple[str, ...]:
        """The exponents whose strength may be 0."""
        return tuple(s.alpha for s in self.strengths if s.low == 0)

    def grade_in_words(self) -> str:
        """The grade in words."""
        return in_words(self.grade, self.left)

    def _page(self) -> Page:
        worth = f"estimate; its damping is {off(self.left)}, p = {self.p:.2g}"
        rows = tuple((s.alpha, f"{s.estimate:.4g}", f"[{s.low:.4g}, {s.high:.4g}]") for s in self.strengths)
        return Page(f"law {self.name}: {self.grade_in_words()}", (worth,), ("exponent", "strength", "95 %"), rows)


def as_zeta(quantity: str, values: Any, resolution: Any) -> tuple[Any, Any]:
    """zeta and its resolution from what was measured.

    >>> as_zeta("Q", np.array([50.0]), np.array([1.0]))
    (array([0.01]), array([0.0002]))
    """
    if quantity == "Q":
        # d zeta = -dQ/(2 Q^2).
        return 1 / (2 * values), resolution / (2 * values**2)
    factor = 1 / (2 * np.pi) if quantity == "decrement" else 1.0
    return values * factor, resolution * factor


def columns(problem: Problem, alphas: Sequence[str], amplitudes: Any, zeta: Any = None) -> Any:
    """z_i(A_j): zeta of a unit strength, one column an exponent; of pairs of amplitudes the mean in between."""
    if problem.between:
        return means([partial(_unit, problem, alpha) for alpha in alphas], np.asarray(amplitudes), zeta)
    return np.array([[_unit(problem, alpha, a) for alpha in alphas] for a in amplitudes])


def _unit(problem: Problem, alpha: str, a: float) -> float:
    tick("the columns of the laws")
    place = exact_number(a, "amplitudes")
    local = Oscillator(
        {exact_number(alpha, "laws"): 1},
        mass=problem.mass,
        stiffness=problem.stiffness,
        x0=place,
        spring=problem.spring,
    )
    return _zeta(local)


# Every law of a table asks for the same exponents at the same amplitudes, for its scatter and for its fit.
@lru_cache(maxsize=1024)
def _zeta(local: Oscillator) -> float:
    with ctx.workprec(_LOW):
        return float(cycle_of(local).zeta)


def fitted(
    amplitudes: Any, values: Sequence[float], resolution: Sequence[float] | None, problem: Problem
) -> tuple[DampingCandidate, ...]:
    """The candidates, best first: by grade, then without terms that are not needed, then by AICc.

    The grade comes first, for a table may have as few rows as a law has strengths: AICc is then infinite.
    """
    zeta, s = weighted(amplitudes, values, resolution, problem)
    rise = RISE if resolution is not None else _rise_of_scatter(_scatter(amplitudes, zeta, problem)[1])
    made = [_candidate(problem, alphas, amplitudes, zeta, s, rise) for alphas in problem.candidates]
    order = ("consistent", "adequate", "refuted")
    return tuple(sorted(made, key=lambda c: (order.index(c.grade), bool(c.unneeded), c.criterion)))


def weighted(
    amplitudes: Any, values: Sequence[float], resolution: Sequence[float] | None, problem: Problem
) -> tuple[Any, Any]:
    """zeta and its resolution; where none is given, all equal and as large as the best candidate needs."""
    known = np.ones(len(values)) if resolution is None else np.asarray(resolution, dtype=float)
    zeta, s = as_zeta(problem.quantity, np.asarray(values, dtype=float), known)
    return zeta, np.full(len(zeta), _scatter(amplitudes, zeta, problem)[0]) if resolution is None else s


def _rise_of_scatter(free: int) -> float:
    """The rise of chi^2 where the resolution is a scatter of so many degrees of freedom."""
    return float(fdtri(1, free, 0.95)) if free else RISE


def _scatter(amplitudes: Any, zeta: Any, problem: Problem) -> tuple[float, int]:
    """The resolution that the best candidate needs to be just as far off as expected, and its degrees of freedom."""
    found = []
    for alphas in problem.candidates:
        free = len(zeta) - len(alphas)
        # A law with as many strengths as there are rows leaves nothing, and knows no scatter.
        if free > 0:
            z = columns(problem, alphas, amplitudes, zeta)
            found.append((float(nnls(z, zeta)[1] / np.sqrt(free)), free))
    # A table without scatter, such as one that was computed, still needs a weight that is not infinite.
    least, free = min(found, default=(0.0, 0))
    return max(least, 1e-12 * float(np.abs(zeta).max())), free


def _candidate(
    problem: Problem, alphas: tuple[str, ...], amplitudes: Any, zeta: Any, s: Any, rise: float = RISE
) -> DampingCandidate:
    z = columns(problem, alphas, amplitudes, zeta)
    b, root = nnls(z / s[:, None], zeta / s)
    square, n, count = float(root**2), len(zeta), len(alphas)
    # Strengths at the bound 0 are counted as fitted, though they fit nothing: p is rather too small.
    p = float(chdtrc(n - count, square)) if n > count else 1.0
    left = float(np.sqrt(np.mean(((zeta - z @ b) / zeta) ** 2)))
    grade = grade_of("consistent" if p > LEVEL else "refuted", left)
    # A law that does not fit has errors as large as its misfit; a good fit says nothing against the resolutions.
    rise *= max(1.0, square / (n - count)) if p <= LEVEL else 1.0
    profile = [_interval(z / s[:, None], zeta / s, b, i, square, rise) for i in range(count)]
    strengths = tuple(Strength(a, low, float(e), high) for a, e, (low, high) in zip(alphas, b, profile))
    return DampingCandidate("+".join(alphas), strengths, left, square, p, aicc(square, count, n), grade)


def _interval(z: Any, y: Any, b: Any, i: int, least: float, rise: float) -> tuple[float, float]:
    """Where the profile of strength i has risen so far from its least."""
    others = np.delete(z, i, axis=1)

    def above(value: float) -> float:
        rest = y - value * z[:, i]
        square = float(nnls(others, rest)[1]) ** 2 if others.shape[1] else float(rest @ rest)
        return square - least - rise

    step: float = float(np.sqrt(rise) / np.linalg.norm(z[:, i]))
    # The profile is convex: one end below the estimate, or none above 0.
    low = 0.0 if above(0.0) <= 0 else float(brentq(above, 0.0, b[i]))
    high = _first_above(above, float(b[i]), step)
    return low, float(brentq(above, b[i], high))


def _first_above(above: Callable[[float], float], start: float, step: float) -> float:
    """A place beyond the start where the profile has risen enough."""
    place: float = start + step
    # A quadratic without others rises in the first step; with others that give way it rises more slowly, but it rises.
    while above(place) <= 0:
        step *= 2
        place = start + step
    return place
