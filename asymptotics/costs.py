"""What work costs, from its sizes alone: all measured rates of the project, and the one refusal of too much work.

Seconds on one ordinary core, good to a factor of about three: enough to refuse what would take hours, at once and with
the estimate.  What an estimate cannot see, the time budget stops (``budget``).

The constants are fitted to processor times.  ``python -m benchmarks costs`` holds them beside new ones: on 23 November
2026, one core of a cloud machine (Intel Xeon, Python 3.11), the routes to the turning points took between half and
twice what is said here, dry friction alone a seventh.

>>> round(half_swing_seconds(swings=100, bits=150, terms=1, apart=0), 1)
3.5
>>> require_affordable(7200, 60, "order", "order 300")
Traceback (most recent call last):
    ...
asymptotics.errors.LimitError: argument order: order 300 would take about 7200 s (accepted: work of at most 60 s)
"""

from collections.abc import Iterable
from math import comb, log2

from asymptotics.errors import LimitError
from asymptotics.running.budget import allowed, seconds_told

# What all of these numbers decide: which route is offered first, and whether a request is refused before it begins.  No
# digit depends on one.  Half or twice a constant moves a refusal, and the time budget stops what was let through.


def exact_expansion_seconds(order: int, variables: int, degree: float, *, smooth: bool, turning_point: bool) -> float:
    """Monomials^2 order^2, for integer exponents; ``degree`` is half the largest degree, at least 1."""
    # Products of series take the square of the number of monomials;
    # order^2 covers the passes and the growing rationals.
    work = order**2 * comb(order + variables, variables) ** 2
    if smooth:
        # Fourier polynomials are as long as the degree, once for each factor.
        return 1e-6 * work * degree**2
    # The waveform moments of the other gauges take about twenty times the flow itself.
    return (1e-6 if turning_point else 2e-5) * work * degree


def series_seconds(products: int, terms: int, bits: int) -> float:
    """Certified coefficients of the quarter-swing: products of power series of ``terms`` coefficients."""
    # Linear in the terms and in the 64-bit words of a ball: FLINT multiplies polynomials of these lengths nearly so.
    return 5e-7 * products * terms * (1 + bits // 64)


def node_seconds(order: int, nodes: int, bits: int) -> float:
    """The quarter-swing of one law at Chebyshev nodes: convolutions at each, and two matrices for each order."""
    # First the convolutions, then a matrix times a vector for each order; the last factor is what longer balls cost.
    return (1e-7 * order**2 * nodes + 6e-8 * order * nodes**2) * (1 + bits / 500)


def hierarchy_seconds(monomials: int, powers: int, length: int) -> float:
    """(powers) x (pairs of monomials) x (length of the polynomials)."""
    return 3e-7 * powers * monomials**2 * length


def turning_hierarchy_seconds(order: int, variables: int, degree: int) -> float:
    """Monomials of the strengths times the length of their polynomials in psi, sin psi, cos psi."""
    return float(1e-6 * comb(order + variables, variables) * order**3 * max(degree, 1) ** 1.5)


def half_swing_seconds(swings: float, bits: int, terms: int, apart: int) -> float:
    """Certified half-swings by local expansions; ``apart`` counts the exponents without a small denominator."""
    # 0.035 s at 150 bits, and a steeper power from 1000 bits on: both fitted, like all that stands here.
    one = 0.035 * (bits / 150) ** 2.2 * max(1.0, bits / 1000) ** 0.7
    # An exponent without a small denominator opens an axis of its own in the local expansion.
    return float(swings * one * (1 + apart) * (0.6 + 0.4 * terms))


SLIDES = 64
"""log2 of the strength up to which one law was seen to slide within seconds (3/2 at 10^4, 10^6, …, 10^18)."""


def stiff_seconds(sizes: Iterable[tuple[float, float]], bits: int) -> float:
    """The first half-swing under strong damping, from (log2 epsilon_i, alpha_i): the number of Taylor steps grows like
    epsilon^(2/alpha), unless one law alone slides along its slow curve; at most 10^9 s are said."""
    sizes = list(sizes)
    # 2^60 stands for "never" and keeps the power within the doubles.
    steps = sum(0.2 * 2 ** min(2 * size / alpha, 60.0) for size, alpha in sizes if alpha > 1 and size > 0)
    if len(sizes) == 1 and sizes[0][1] > 1 and sizes[0][0] <= SLIDES:
        # Along its slow curve one law takes steps of the scale of the curve, more of them the nearer alpha is to 1.
        steps = min(steps, 100 + 10 / (sizes[0][1] - 1))
    # 1.5 ms a Taylor step at 150 bits; 10^9 s, thirty years, is refused like anything above it.
    return float(min(1e9, steps * 0.0015 * (bits / 150) ** 2))


def interpolation_seconds(swings: float) -> float:
    """Half-swings by interpolation, after the nodes."""
    return 3e-5 * swings


def jump_seconds(bits: int) -> float:
    """The coefficients of the series and of the Abel function."""
    return float(12 * (bits / 200) ** 1.5)


def flow_seconds(order: int, laws: int, bits: int) -> float:
    """The coefficients of the slow flow of a sum through an order."""
    # 3.7 s at order 13 of two laws, 7.5 s at order 9 of three, 9.2 s at
    # order 7 of more, at 220 bits: the number of monomials sets the powers.
    one = {2: 3.7 * (order / 13) ** 3.6, 3: 7.5 * (order / 9) ** 4.8}.get(laws, 9.2 * (order / 7) ** 5.4)
    return float(one * (bits / 220) ** 1.2)


def well_seconds(swings: float, bits: int, terms: int, apart: int) -> float:
    """The same in a well with springs or losses that depend on the position."""
    return swings * 0.06 * (bits / 130) ** 2 * (1 + 4 * apart) * (0.7 + 0.3 * terms)


def binomial_seconds(line: float, i: int, n: int) -> float:
    """One of Smith's coefficients C_i^n: i passes over a line of integers of about n log n bits."""
    return 2e-7 * line * i * (1 + n * log2(n + 2) / 8000)


def map_seconds(steps: int, digits: int, nodes: float = 0.0, *, times: bool = False) -> float:
    """Steps of a map in closed form, and for their times a quadrature: ``nodes`` of them for the first half-swing."""
    one_evaluation = float(4e-6 * (1 + digits / 40) ** 1.15)
    seconds = steps * (3 * one_evaluation + 1e-5)
    return seconds + (nodes + steps * digits / 3) * one_evaluation if times else seconds


def deep_quadrature_seconds(bits: int) -> float:
    """One time on a half-swing under quadratic damping: as many nodes as bits, and a sum over them for each."""
    # 8 s at 1600 bits: nodes and sums grow with the bits, and so does each of their products.
    return float(8 * (bits / 1600) ** 3.5)


def closed_form_seconds(points: int, digits: int) -> float:
    """Turning points in closed form: an exponential or a product each."""
    return float(2e-5 * points * (1 + digits / 100))


def primitive_seconds(swings: float, bits: int) -> float:
    """Half-swings by the closed primitive, some fifty evaluations each at twice ``bits``."""
    return float(swings * 0.003 * (1 + (bits / 500) ** 1.45))


def require_affordable(seconds: float, limit: float, argument: str, work: str, accepted: str = "") -> None:
    """LimitError with the estimate when it is above ``limit``, or what is ``allowed`` where nobody asked for that."""
    limit = allowed(limit)
    if seconds > limit:
        reason = f"{work} would take about {seconds_told(seconds)} s"
        raise LimitError(argument, reason, f"work of at most {seconds_told(limit)} s{accepted}")
