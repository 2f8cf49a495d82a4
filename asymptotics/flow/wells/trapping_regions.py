"""How a motion ends, decided in balls: it is held, creeps home, is overdamped; or it leaves its well.

*Traps* are trapping regions, positively invariant: on the boundary the vector field points inwards (Nagumo 1942;
derivation ``wells-traps``).  Let s_0(u*) = 0, u* = 0 without losses of exponent 0, and s_0(u) <= K (u - u*) for the
places between u* and u.  With y = u - u* the regions of the linear spring are traps, in units of time 1/sqrt(K):

    one alpha < 1:   (w/c)^alpha <= K y/epsilon with c^alpha = 2/(2 - alpha), while
                     c^2 y^(2/alpha-2) < alpha^2/(2-alpha) epsilon^(2/alpha) K^(1-2/alpha);
    alpha = 1, epsilon^2 >= 4 K:   w <= y (epsilon + sqrt(epsilon^2 - 4 K))/2.

More losses only slow the motion down.  ``None`` means: not proved here.

*The well.*  V' > 0 from 0 to x: then a motion from rest at x stays inside.  Beyond the first place where V' < 0 a
pendulum rotates, and any other mass escapes.

>>> from asymptotics.law import Law
>>> duffing = WellForce.of(Law({"1/2": 1}, spring={3: "-1/2"}).terms)
>>> trap(duffing, arb("0.1"), arb("0.001")), trap(duffing, arb("0.1"), arb("0.5")), inside(duffing, arb(1))
('creeps', None, True)
>>> inside(duffing, arb(2)), beyond(duffing, arb(-2)), beyond(duffing, arb(-1))
(False, 'escapes', None)
"""

from flint import arb

from asymptotics.errors import InputError
from asymptotics.flow.linear_spring.trapping_regions import CREEPS, OVERDAMPED
from asymptotics.flow.trajectory import ESCAPES, ROTATES
from asymptotics.flow.wells.force import WellForce
from asymptotics.numbers.context import ctx
from asymptotics.numbers.precision import TooWideError

# Twelve halvings of an interval everywhere, or far more about one place; what is not decided by then stays undecided.
_PIECES, _LOW = 4096, 53


def may_trap(force: WellForce) -> bool:
    """Whether some loss can hold the mass on one side at all: an exponent below 1, or a linear one of 2 or more."""
    # Where the slope at u = 0 counts, which is 1, K >= 1 and epsilon^2 >= 4 K needs epsilon >= 2.  A smaller K, of a
    # softening spring with dry friction, is not looked for: such a motion is not called overdamped.
    return any(f.place == 0 and f.alpha < 1 for f in force.losses) or not force.viscous < 2


def trap(force: WellForce, u: arb, w: arb) -> str | None:
    """Why u = 0 is never reached from any (u, w) in the two balls, or None if nothing proves it."""
    held = _held(force, u)
    if held is None or not u - held > 0:
        return None
    # The slowest states are in the trap as well; a smaller y makes the wedge narrower, and the largest y is asked in
    # the condition that bounds it.
    w, y = abs(w).upper(), (u - held).lower()
    # s_0(u) <= K (u - u*) by the mean value theorem, K being the largest slope in between; it serves all of the way
    # down to u*.
    chord = force.slope(held.union(u), arb(0))
    steepest = chord.upper()
    # The lower boundary, w = 0, needs s_0 > 0 from u* on: with dry friction by a slope above 0, which also makes u* the
    # only zero there; without it because V' > 0 on (0, u] inside a well.
    if not steepest > 0 or (force.grips and not chord > 0):
        return None
    for f in force.losses:
        if f.place == 0 and f.alpha < 1 and _slow(f.strength, f.exponent, steepest, y, (u - held).upper(), w):
            return CREEPS
    epsilon = force.viscous
    room = epsilon**2 - 4 * steepest
    if (room >= 0 or _critical(force, epsilon)) and w <= y * (epsilon + room.nonnegative_part().sqrt()) / 2:
        return OVERDAMPED
    return None


def _critical(force: WellForce, epsilon: arb) -> bool:
    """epsilon = 2 exactly under a spring that only softens: K = 1."""
    softening = all(c < 0 for c, _ in force.springs) and not force.grips
    # A spring below the linear one: K = 1 although the ball of the slope may exceed it by its rounding, and epsilon^2 =
    # 4 K exactly.
    return bool(epsilon == 2) and softening and (force.rate is None or bool(force.rate > 0))


def _held(force: WellForce, u: arb) -> arb | None:
    """The first place u* above 0 where s_0 changes its sign, as a ball; None where the search does not decide."""
    if not force.grips:
        return arb(0)
    low, high = arb(0), u.mid()
    if not force.restoring(high) > 0:
        return None
    for _ in range(ctx.prec):
        middle = ((low + high) / 2).mid()
        if force.restoring(middle) > 0:
            high = middle
        elif force.restoring(middle) < 0:
            low = middle
        else:
            break
    # A zero lies between only if s_0 < 0 at the lower end; low = 0 has not been looked at yet.
    return low.union(high) if low > 0 or force.restoring(arb(0)) < 0 else None


def _slow(epsilon: arb, a: arb, K: arb, y: arb, highest: arb, w: arb) -> bool:
    # C of the module's docstring; the condition on y is asked at the highest place, from which on y falls.
    c = (2 / (2 - a)) ** (1 / a)
    inside = w == 0 or w**a <= c**a * K * y / epsilon
    return bool(inside) and bool(c**2 * highest ** (2 / a - 2) < a**2 / (2 - a) * epsilon ** (2 / a) * K ** (1 - 2 / a))


def beyond(force: WellForce, u: arb) -> str | None:
    """Why a motion that passes the place u < 0 has left its well, or None."""
    # At u < 0 the force of a well points back, V' < 0: where it points outwards the top has been passed.
    return leaves(force) if u < 0 and force.spring_force(u) > 0 else None


def leaves(force: WellForce) -> str:
    """What a motion does that leaves its well."""
    return ROTATES if force.rate is not None else ESCAPES


def inside(force: WellForce, x: arb) -> bool | None:
    """Whether V' > 0 from 0 to all of |x|; False if V' <= 0 somewhere before any of it, None if undecided."""
    with ctx.workprec(max(ctx.prec, _LOW)):
        nearest, farthest = max(abs(x).lower(), arb(0)), abs(x).upper()
        # The sure part of |x| is looked at first (the stack gives its last): a failure there is certain, beyond it only
        # possible.
        stack, pieces = [(nearest, farthest), (arb(0), nearest)], 0
        while stack:
            low, high = stack.pop()
            pieces += 1
            if _stiffness(force, low.union(high)) > 0:
                continue
            if _stiffness(force, high) <= 0:
                return False if high <= nearest else None
            if pieces > _PIECES:
                return None
            middle = ((low + high) / 2).mid()
            stack += [(low, middle), (middle, high)]
    return True


def require_inside(force: WellForce, x: arb, shown: str) -> None:
    """InputError unless V' > 0 from 0 to |x|; UndecidedError where balls cannot tell."""
    stays = inside(force, x)
    if stays is None:
        raise TooWideError(f"whether {shown} lies inside the well is undecided")
    if not stays:
        raise outside(force, shown)


def outside(force: WellForce, shown: str) -> InputError:
    """The refusal of a start that V' > 0 does not hold in its well."""
    reason = f"{shown} lies outside the well, V' > 0 fails on the way: it {leaves(force)}"
    return InputError("x0", reason, "a start inside it")


def _stiffness(force: WellForce, x: arb) -> arb:
    """V'(x)/x for a ball x >= 0."""
    # V'(x)/x rather than V'(x), which vanishes at x = 0 and would leave that end undecided.
    linear = arb(1) if force.rate is None else (force.rate * x).sinc()
    return sum((c * x ** (p - 1) for c, p in force.springs), linear)
