"""A trial orbit over half a period, from the turning point (theta_0, X_0) to (theta_0 + pi, -X_0), in pieces.

From rest, power series in motion, and backwards from the turning point ahead, which is the first one mirrored.  Every
piece has its defect, and the jumps where two meet are counted with them: ``miss`` bounds the distance, in the norm
sqrt(k x^2 + mu v^2) that never grows, of the exact motion from (theta_0, X_0) at the end of the half period from the
point (-X_0, 0).  Derivation ``driven-unique``.
"""

from dataclasses import dataclass, replace

from flint import arb

from asymptotics.driven.drive import Balls
from asymptotics.driven.expansion import Arc, Lattice, grid, piece
from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.running.budget import tick

MAX_PIECES = 4000
_ROUNDS = 60


@dataclass(frozen=True)
class Trial:
    """The pieces in the order of the time, and the angles from theta_0 where they begin and end; the last one runs
    against the time."""

    balls: Balls
    theta: arb
    X: arb
    pieces: tuple[Arc, ...]
    nodes: tuple[arb, ...]
    miss: arb


def grids(alphas: tuple[ExactReal, ...], bits: int) -> tuple[Lattice, Lattice]:
    """The monomials at rest and in motion, as many as that many bits make cheap: choices."""
    order = int(0.35 * bits) + 6
    acting = tuple(a for a in alphas if not a.is_zero)
    top, wanted = min(8, order), max(90, order + 8)
    # Beside a turning point there may be many monomials below s^top: a lower top and a shorter piece.
    while top < order and len(grid(acting, higher := min(order, top * 5 // 4), bits).exponents) <= wanted:
        top = higher
    return grid(acting, top, bits), grid((), order, bits)


@dataclass(frozen=True)
class March:
    """Pieces with the exact angles from theta_0 at which they begin, the mismatch (x, v) of the last two, the rest of
    the jumps and defects."""

    pieces: tuple[Arc, ...]
    starts: tuple[arb, ...]
    mismatch: tuple[arb, arb]
    rest: arb


def march(balls: Balls, both: tuple[Lattice, Lattice], theta: arb, X: arb) -> March:
    """From rest at (theta, X), both exact, to rest at (theta + pi, -X)."""
    rest, moving = both
    aim, pi = 4.0 - ctx.prec, arb.pi()
    sign = 1 if theta.cos() * balls.f > balls.k * X else -1
    last = piece(balls, rest, theta + pi, -1, -sign, sign * X, None, aim)
    # Angles are counted from theta_0, where they are exact; the last piece is met a little within its length.
    meet, elapsed, extra = (pi - last.length).upper(), arb(0), arb(0)
    pieces, starts = [piece(balls, rest, theta, 1, sign, sign * X, None, aim)], [arb(0)]
    while True:
        tick(f"piece {len(pieces)} of half a period")
        here = pieces[-1]
        y, w = here.state(here.length)
        elapsed = elapsed + here.length
        if len(pieces) > MAX_PIECES or elapsed.rad() > 0:
            raise UndecidedError("a half period of the trial orbit takes too many pieces, or too short ones")
        if elapsed == meet:
            break
        extra += balls.k.sqrt() * y.rad() + balls.mu.sqrt() * w.rad()
        found, left = piece(balls, moving, theta + elapsed, 1, sign, y.mid(), w.mid(), aim), meet - elapsed
        pieces.append(found if found.length < left else replace(found, length=left))
        starts.append(elapsed)
    there = last.state(pi - meet)
    pieces.append(replace(last, length=pi - meet))
    defects = sum((p.defect for p in pieces), arb(0)) / balls.mu.sqrt()
    return March(tuple(pieces), (*starts, meet), (y + there[0], w - there[1]), upper(extra + defects))


def trial(balls: Balls, alphas: tuple[ExactReal, ...], start: tuple[arb, arb], least: int = 64) -> Trial:
    """The trial orbit by Newton's method from near a turning point, at precisions that double from ``least`` bits.

    Differences of two marches are slopes good to half of the bits: a step takes one level to the next.
    """
    bits, (theta, X) = ctx.prec, start
    for level in [b for n in range(12, 0, -1) if (b := bits >> n) >= least]:
        with ctx.workprec(level):
            theta, X, _ = _refined(balls, grids(alphas, level), theta, X)
    theta, X, found = _refined(balls, grids(alphas, bits), theta, X)
    dx, dw = found.mismatch
    miss = upper(balls.k.sqrt() * abs(dx) + balls.mu.sqrt() * abs(dw) + found.rest)
    return Trial(balls, theta, X, found.pieces, (*found.starts, arb.pi()), miss)


def _refined(balls: Balls, both: tuple[Lattice, Lattice], theta: arb, X: arb) -> tuple[arb, arb, March]:
    """The nearest turning point that Newton's method met, and its march."""
    found, fresh, last = march(balls, both, theta, X), False, arb.pos_inf()
    slopes: tuple[arb, ...] = ()
    nearest, size, noise, near = (theta, X, found), _size(found), arb(2) ** (16 - ctx.prec), arb(2) ** (-ctx.prec // 2)
    for _ in range(_ROUNDS):
        # At the noise of the arithmetic, or where near the end even new slopes gained next to nothing.
        if size < noise or (fresh and size < near and size * 4 > last):
            break
        p, q = (m.mid() for m in found.mismatch)
        fresh = not slopes or size * 64 > last
        try:
            slopes = _slopes(balls, both, (theta, X), (p, q)) if fresh else slopes
            step = _step(slopes, p, q)
            theta, X = (theta - step[0]).mid(), (X - step[1]).mid()
            found, last = march(balls, both, theta, X), size
            slopes = _updated(slopes, step, *(m.mid() for m in found.mismatch))
        except UndecidedError:  # a step so long, by slopes of few bits, that nothing moves there
            break
        size = _size(found)
        if size < last:
            nearest = theta, X, found
    return nearest


def _step(slopes: tuple[arb, ...], p: arb, q: arb) -> tuple[arb, arb]:
    """What Newton's method takes from (theta, X) for the mismatch (p, q)."""
    a, b, c, e = slopes
    det = a * e - b * c
    return ((p * e - q * b) / det).mid(), ((q * a - p * c) / det).mid()


def _updated(slopes: tuple[arb, ...], step: tuple[arb, arb], p: arb, q: arb) -> tuple[arb, ...]:
    """The slopes that would have foreseen what was left after the step (Broyden, Math. Comp. 19 (1965) 577): beside dry
    friction a quarter of the marches fewer than with those of before."""
    d, f = step
    square = d * d + f * f
    if square == 0:
        return slopes
    change = (-p * d / square, -p * f / square, -q * d / square, -q * f / square)
    return tuple((s + by).mid() for s, by in zip(slopes, change, strict=True))


def _size(found: March) -> arb:
    return max(abs(m.mid()) for m in found.mismatch)


def _slopes(
    balls: Balls, both: tuple[Lattice, Lattice], point: tuple[arb, arb], here: tuple[arb, arb]
) -> tuple[arb, ...]:
    """(p_theta, p_X, q_theta, q_X) of the mismatch p, q."""
    d, (theta, X) = arb(2) ** (-ctx.prec // 2), point
    (a, c), (b, e) = (
        [((after.mid() - before) / d).mid() for after, before in zip(march(balls, both, *moved).mismatch, here)]
        for moved in (((theta + d).mid(), X), (theta, (X + d).mid()))
    )
    return a, b, c, e
