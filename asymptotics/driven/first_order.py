"""The response to first order in closed form: x = A cos(theta - phase), for every alpha >= 0 and any sum.

Harmonic balance, which is also averaging: with M_p the mean of |sin|^p and

    R(A) = sum_i 2 c_i M_(alpha_i+1) A^alpha_i,    c_i = b_i Omega^alpha_i,

the amplitude is the one root of (A (k - mu))^2 + R(A)^2 = f^2, whose left side grows, and tan(phase) = R/(A (k - mu)).
At omega_0, where mu = k, R(A) = f, and the phase is pi/2.  Source: derivation ``driven-first-order``.

>>> from asymptotics.law import Oscillator
>>> drive = Drive.read(Oscillator({1: "1/10"}), "1/5", 1)
>>> A = amplitude(drive.balls())
>>> A.str(10), phase(drive.balls(), A).str(10)
('[2.000000000 +/- ...]', '[1.570796327 +/- ...]')
"""

from flint import acb, arb

from asymptotics.driven.drive import Balls, Drive
from asymptotics.errors import InputError, UndecidedError
from asymptotics.expansions.moments.certified import moment
from asymptotics.numbers.context import ctx
from asymptotics.numbers.root import verified_root

_STEPS = 200  # Newton's method for ln A is monotone from the right and ends quadratically: a limit, never met


def resistance(balls: Balls, A: arb) -> arb:
    """R(A), the force of the losses in phase with the speed."""
    return sum((2 * c * moment(a + 1) * A**a for c, a in balls.losses), arb(0))


def phase(balls: Balls, A: arb) -> arb:
    """By how much x lags behind the force, between 0 and pi."""
    return acb(A * (balls.k - balls.mu), resistance(balls, A)).arg()


def amplitude(balls: Balls) -> arb:
    """The root A, proved; InputError where dry friction is so strong that there is none, or alone at omega_0."""
    detuning = abs(balls.k - balls.mu)
    dry = sum((2 * c * moment(arb(1)) for c, a in balls.losses if a == 0), arb(0))
    room = balls.f**2 - dry**2
    if not room > 0:
        reason = "it is no larger than 4/pi times the dry friction: the mass sticks in every swing"
        raise InputError("force", reason, "a force above 4/pi times the dry friction")
    moving = [(2 * c * moment(a + 1), a) for c, a in balls.losses if a > 0]
    if not moving:
        if not detuning > 0:
            raise InputError("omega", "at omega_0 dry friction alone does not bound the amplitude", "another frequency")
        return room.sqrt() / detuning
    return _root(balls, detuning, moving)


def _root(balls: Balls, detuning: arb, moving: list[tuple[arb, arb]]) -> arb:
    """ln f = ln(A^2 d^2 + R^2)/2 for s = ln A: convex in s, so Newton's method from the right falls to the root."""
    # Each term alone would need at least this A: the least of them is at or beyond the root.
    starts = [(balls.f / r).log() / a for r, a in moving]
    if detuning > 0:
        starts.append((balls.f / detuning).log())
    s, aim = min(starts, key=lambda x: float(x.mid())).mid(), balls.f.log()
    for _ in range(_STEPS):
        value, slope = _log_force(balls, detuning, s)
        step = ((value - aim) / slope).mid()
        s = (s - step).mid()
        if abs(step) < arb(2) ** (8 - ctx.prec) * (1 + abs(s)):
            break
    value, _ = _log_force(balls, detuning, s)
    radii = [arb(2) ** (n - ctx.prec) * (1 + abs(s)).upper() for n in range(6, ctx.prec, 6)]
    found = verified_root(s, abs(value - aim), lambda x: 1 / _log_force(balls, detuning, x)[1], radii)
    if found is None:
        raise UndecidedError("the amplitude of first order was not enclosed")
    return found.exp()


def _log_force(balls: Balls, detuning: arb, s: arb) -> tuple[arb, arb]:
    """ln(A^2 d^2 + R^2)/2 and its slope in s = ln A."""
    parts = [(2 * c * moment(a + 1) * (a * s).exp(), a) for c, a in balls.losses]
    d, R = detuning * s.exp(), sum((p for p, _ in parts), arb(0))
    square = d * d  # at omega_0 the ball of d holds 0, which ** 2 does not take
    total = square + R**2
    return total.log() / 2, (square + R * sum((p * a for p, a in parts), arb(0))) / total


def damping(drive: Drive, A: arb) -> arb:
    """c_eq(A) = R(A)/(A Omega): the viscous damping that takes the same energy."""
    return resistance(drive.balls(), A) / (A * drive.omega.ball())


def quality(drive: Drive, A: arb) -> tuple[arb, arb]:
    """Q at resonance with the amplitude A: of the decay there, k A/f, and of the half-power width.

    The second, to leading order in the loss, is k A/sqrt(2 (f^2 - R(A/sqrt 2)^2)): where R grows like A^alpha, 1 over
    sqrt(2 (1 - 2^-alpha)) times the first, which is 1 for alpha = 1 alone.
    """
    there = drive.balls_at_resonance()
    half = resistance(there, A / arb(2).sqrt())
    return there.k * A / there.f, there.k * A / (2 * (there.f**2 - half**2)).sqrt()


def peak(drive: Drive) -> tuple[arb, arb] | None:
    """(A, Omega) of the largest amplitude, all alpha_i >= 1; None for others, and where A falls from Omega = 0 on.

    With the speed s = A Omega, R = sum r_i s^alpha_i and q = R (sum alpha_i r_i s^alpha_i)/(2 m s^2) the amplitude is
    stationary where k - m Omega^2 = q, and there m s^2 q^2/(k - q) + R^2 = f^2, whose left side grows with s.
    """
    if any(a < 1 for a in drive.alphas):
        return None
    m, k, f = drive.oscillator.mass.ball(), drive.oscillator.stiffness.ball(), drive.force.ball()
    terms = [(2 * t.strength.ball() * moment(t.velocity.ball() + 1), t.velocity.ball()) for t in drive.losses]

    def parts(s: arb) -> tuple[arb, arb]:
        R = sum((r * s**a for r, a in terms), arb(0))
        return R, R * sum((a * r * s**a for r, a in terms), arb(0)) / (2 * m * s**2)

    def beyond(s: arb) -> bool | None:
        R, q = parts(s)
        excess = m * s**2 * q**2 / (k - q) + R**2 - f**2 if q < k else arb(1) if q >= k else arb.nan()
        return True if excess > 0 else False if excess < 0 else None

    high = min(((f / r).log() / a for r, a in terms), key=lambda x: float(x.mid())).exp().upper()
    low = (high * arb(2) ** -200).mid()
    if beyond(low) is not False:
        return None
    for _ in range(ctx.prec + 200):
        middle = ((low + high) / 2).mid()
        side = beyond(middle)
        if side is None:
            break
        low, high = (low, middle) if side else (middle, high)
    s = low.union(high)
    omega = ((k - parts(s)[1]) / m).sqrt()
    return s / omega, omega
