"""Route "quadratic": quadratic damping alone (alpha = 2) by the Lambert W map, from any starting index.

>>> from asymptotics.law import Law
>>> for point in points(PointsRequest.read(Law({2: 1}), 3, 20, times=True)).points:
...     print(point.n, point.x, point.tau)
0 1.0000000000000000000 0
1 -0.41071968606103944670 3.3809710603589252128
2 0.26356838641759692059 6.5808870083860533294
>>> points(PointsRequest.read(Law({2: 1}), 1, 20, start=10**9)).points[0].x
'7.4999999933950386713e-10'
"""

from collections.abc import Iterator
from fractions import Fraction
from itertools import islice
from math import ceil, log2

from flint import arb

from asymptotics.costs import map_seconds, require_affordable
from asymptotics.errors import LimitError
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import BITS_PER_DIGIT, MAX_BITS, bits_for
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.running.budget import Unasked
from asymptotics.turning.quadratic_abel import quadratic_abel
from asymptotics.turning.quadratic_duration import duration, node_count
from asymptotics.turning.quadratic_map import amplitudes, next_amplitude
from asymptotics.turning.result import TurningPoints, proved_point
from asymptotics.turning.route import Route
from asymptotics.turning.table import PointsDone, PointsRequest, Progress

MAX_JUMP_DIGITS = 1_000  # the exact coefficients of the Abel function cost about digits^4
MAX_SECONDS = Unasked(600)
_HEAD, _TERMS = (7, 200), (12, 2)
_DIRECT = 20_000  # up to this index it is cheaper to iterate than to set up the Abel function
# Beyond them the extra bits of ``_magnitude`` or the nodes of the first half-swing are too many; other routes serve.
_SMALLEST, _LARGEST = Fraction(1, 10**12), Fraction(10**12)


def serves(request: PointsRequest) -> float | None:
    """The seconds; None unless quadratic damping acts alone, from rest, with 1e-12 <= epsilon <= 1e12."""
    alone = request.alone
    if alone is None or alone[0] != 2 or request.in_motion or not _SMALLEST <= alone[1] <= _LARGEST:
        return None
    return estimated_seconds(alone[1], request.count, request.digits, request.start, request.times)


def points(request: PointsRequest, progress: Progress = lambda done: None) -> TurningPoints:
    """The turning points, which never end, for X'' + X + epsilon X'|X'| = 0, X(0) = 1, X'(0) = 0.

    epsilon = b x0/m is Smith's u_0.  LimitError for more work than the stated limits.
    """
    _require_moderate(request)
    epsilon, start = request.epsilon, request.start
    # Errors add over the half-swings, and x is p over p_0, for which a small or a large epsilon costs its size.
    bits = bits_for(request.digits, 48) + 2 * (start + request.count).bit_length() + _magnitude(epsilon)

    kept, name = PointsDone(request), "iterated map" if start <= _DIRECT else "Abel function"

    def attempt(bits: int) -> TurningPoints:
        method = f"{name}, balls of {bits} bits"
        made = kept.begin(lambda: method)
        for n, ratio, tau in islice(_balls(epsilon, start, request.times), request.count):
            made.append(proved_point(n, -ratio if n % 2 else ratio, tau if request.times else None, request.digits))
            progress(len(made))
        return request.table(tuple(made), method)

    with kept:
        return at_growing_precision(attempt, request.digits, bits, max_bits=MAX_BITS)


def _balls(epsilon: ExactReal, start: int, times: bool) -> Iterator[tuple[int, arb, arb]]:
    """Yield (n, p_n / p_0, tau_n) from n = start on; tau is 0 throughout unless it is asked for."""
    p0 = 2 * epsilon.ball()
    n, p, tau = (0, p0, arb(0)) if start <= _DIRECT else _jump(p0, start, times)
    while True:
        if n >= start:
            yield n, p / p0, tau
        q = next_amplitude(p)
        if times:
            tau += duration(p, q)
        n, p = n + 1, q


def _head(digits: int) -> int:
    """How many turning points come before the jump."""
    return _HEAD[0] * digits + _HEAD[1]


def _jump(p0: arb, start: int, times: bool) -> tuple[int, arb, arb]:
    """The turning point ``start`` through the Abel function, from a certified head of the orbit."""
    digits = int(ctx.prec / BITS_PER_DIGIT)
    # Head and terms in proportion to the digits: p is about 3/(2n) = 0.2/digits at its end, and K = 2/9 digits + 12
    # terms make the defect as small as the precision.  They decide cost alone, for the defect is bounded: half or twice
    # the head cost the same, half the terms a fifth less, and twice the terms twice (``benchmarks/constants.json``).
    head = list(islice(amplitudes(p0), min(_head(digits), start)))
    abel = quadratic_abel(terms=_TERMS[0] + digits * _TERMS[1] // 9)
    p = 2 * abel.advance(head[-1] / 2, start - len(head) + 1)
    if not times:
        return start, p, arb(0)
    tau = sum((duration(a, b) for a, b in zip(head, head[1:])), arb(0))
    return start, p, tau + abel.time_between(head[-1] / 2, p / 2)


def _magnitude(epsilon: ExactReal) -> int:
    """|log2 epsilon|, rounded up: the bits that small amplitudes and long first half-swings cost."""
    with ctx.workprec(53):
        return ceil(abs(log2(float(epsilon.ball().mid())))) + 1


def _require_moderate(request: PointsRequest) -> None:
    """LimitError for work beyond the limits of this route."""
    start, digits = request.start, request.digits
    if start > _DIRECT and digits > MAX_JUMP_DIGITS:
        reason = f"{digits} digits are too many for a start beyond {_DIRECT}"
        raise LimitError("digits", reason, f"at most {MAX_JUMP_DIGITS} digits there")
    seconds = estimated_seconds(request.epsilon, request.count, digits, start, request.times)
    work = f"{request.count} points with {digits} digits"
    require_affordable(seconds, MAX_SECONDS, "count", work, ": fewer points, fewer digits or no times")


def estimated_seconds(epsilon: ExactReal, count: int, digits: int, start: int, times: bool) -> float:
    """The expected running time in seconds, by ``costs.map_seconds``."""
    steps = count + (start if start <= _DIRECT else _head(digits))
    with ctx.workprec(53):
        first = node_count(2 * float(epsilon.ball().mid()) + 1, bits_for(digits)) if times else 0
    return map_seconds(steps, digits, first, times=times)


ROUTE = Route(
    "quadratic",
    "quadratic damping alone, from rest, at any index",
    "Lambert W map, half periods by quadrature, Abel function of exact coefficients",
    serves,
    points,
)
