"""The averaged law of one or more laws in balls: dA/dtau = -sum_i kappa_i A^alpha_i, A(0) = 1, all kappa_i > 0.

Quadratures by Petras' algorithm (Johansson, Numerical integration in arbitrary-precision ball arithmetic, 2018); the
inverse by an a priori enclosure, the first-exit argument of Picard and Lindelöf.

With s = -ln A and g(s) = sum_i kappa_i e^(-(alpha_i-1)s) > 0 the law is ds/dtau = g(s), and

    tau(A) = int_0^s dr/g(r),    phi(A) = -int_0^s (sum_ij w_ij delta_i delta_j)/g dr,
    delta_i = eps_i e^(-(alpha_i-1)r),
    w_ij = alpha_i alpha_j M_(alpha_i+alpha_j)/((alpha_i+1)(alpha_j+1))        (derivation ``second-order-sums``).

*One law*: closed forms.  *Two laws*: tau from 2F1(1, a; a+1; z) with z < 0 (``hypergeometric``): for rational a by q
complex logarithms, else by Arb, which must be told that a+b-c = 0 (without the flag the enclosure is valid and
useless).  *More*: ``acb.integral``; numerator and g are entire, and a zero of g makes the integrand a non-finite ball,
which the integrator treats by subdivision, so that what comes out is an enclosure.

*Extinction* (least exponent alpha < 1), more than two laws.  For A = e^(-s) and R = sum_(i>1) (kappa_i/kappa)
A^(alpha_i-alpha), the rest int_0^A da/(kappa a^alpha (1 + r(a))) with 0 <= r <= R lies between X/(1+R) and X,
X = A^(1-alpha)/((1-alpha) kappa).  s is taken so large that R < 2^-precision.

*Inversion* A(tau).  Let s* be any number (a double-precision guess, improved by Newton), D = |tau - tau(s*)|, and h a
number with D sup_[s*-h, s*+h] g <= h.  On the way from tau(s*) to tau the solution cannot leave [s*-h, s*+h], for it
moves at most D sup g there (at a first exit it would have moved h; equality is allowed).  So s(tau) lies in it.

>>> from asymptotics.numbers.exact import parse_real
>>> laws = [(parse_real(a, "alpha"), arb(k) / 10) for a, k in (("0", 1), ("1", 1), ("2", 1))]
>>> time(laws, arb(1) / 2).str(15), extinction_time(laws).str(15)
('[2.19538136543845 +/- ...]', '[6.0459978807807 +/- ...]')
>>> amplitude(laws, time(laws, arb(1) / 2)).str(13)
'[0.5000000000000 +/- ...]'
"""

from collections.abc import Sequence
from fractions import Fraction
from math import inf

from flint import acb, arb, fmpq

from asymptotics.envelopes.numeric import NumericEnvelope
from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.moments.certified import moment
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.integral import integral
from asymptotics.numbers.precision import TooWideError
from asymptotics.numbers.root import verified_root

Laws = Sequence[tuple[ExactReal, arb]]

# Only a first look at which side of the extinction a time lies; where it cannot tell, the full precision is asked.
ROUGH_BITS = 64
MAX_S = 600.0
"""Amplitudes below e^-600 are refused: the double-precision guess of the inversion ends there."""


def time(laws: Laws, A: arb) -> arb:
    """tau(A) for A in (0, 1].  InputError for A <= 0; A slightly above 1 by its radius is harmless."""
    active = _active(laws)
    _require_positive(A, "0 < A <= 1, in units of x0")
    if len(active) == 1:
        return _time_one(*active[0], A)
    if _has_companion(active):
        return _time_two(active[0], active[1], A)
    return _integral(active, [], -A.log())


def amplitude(laws: Laws, tau: arb) -> arb:
    """A(tau) for tau >= 0; exactly 0 from the extinction time on (the averaged law stays at rest there).

    Around the extinction time the enclosure contains 0; a precision too low for the inversion gives
    [0, 1], where A always is.  Raises InputError for tau < 0 and LimitError for amplitudes below e^-600.
    """
    active = _active(laws)
    if not tau >= 0:
        raise InputError("time", f"{tau.str(5)} is not certainly >= 0", "a time from the start on")
    if tau == 0:
        return arb(1)
    # The order matters: without this look each amplitude would cost an extinction time at full precision.
    with ctx.workprec(ROUGH_BITS):  # decides all but the closest cases at a fraction of the cost
        before = _is_before(tau, extinction_time(active))
    if before is None:
        before = _is_before(tau, extinction_time(active))
    if before is False:
        return arb(0)
    if before is None:
        # A falls with tau: over the ball it lies between 0 and A at the lower end, if that is certainly before the end;
        # else A is somewhere in [0, 1], where it always is.
        low = tau.lower()
        return arb(0).union(amplitude(laws, low) if low > 0 and _is_before(low, extinction_time(active)) else arb(1))
    if len(active) == 1:
        return _amplitude_one(*active[0], tau)
    s = _inverse(active, tau)
    return arb(0).union(arb(1)) if s is None else (-s).exp()


def extinction_time(laws: Laws) -> arb | None:
    """tau where A reaches 0, if the least exponent is below 1; None otherwise: A vanishes only in the limit."""
    active = _active(laws)
    alpha, kappa = active[0]
    if not alpha < 1:
        return None
    if len(active) == 1:
        return 1 / ((1 - alpha.ball()) * kappa)
    if _has_companion(active):
        return _companion(active[0], active[1], arb(1))
    gap = active[1][0].ball() - alpha.ball()
    # Chosen so that the share R <= sum (kappa_i/kappa) e^(-gap s) of the rest, which goes like e^(-(1 - alpha) s), is
    # below 2^-(prec+2); R is made anew from the s that is taken, so that a poor choice costs width alone.
    far = gap + 1 - alpha.ball()
    s = ((ctx.prec + 2) * arb(2).log() + sum((k for _, k in active[1:]), arb(0)).log() - kappa.log()) / far
    # The midpoint is an exact number, which the integral below wants, and which this comparison orders for certain.
    s = max(s.mid(), arb(1))
    rest = (-(1 - alpha.ball()) * s).exp() / ((1 - alpha.ball()) * kappa)
    R = sum((k / kappa * (-(a.ball() - alpha.ball()) * s).exp() for a, k in active[1:]), arb(0))
    # 1/(1 + r) falls from 1 to 1/(1 + R) as r goes from 0 to R: both ends, and what lies between, are in the union.
    return _integral(active, [], s) + rest * (1 / (1 + R)).union(arb(1))


def phase(laws: Laws, strengths: Sequence[arb], A: arb) -> arb:
    """phi at the amplitude A in (0, 1], turning-point gauge; ``strengths`` are the eps_i that belong to ``laws``."""
    _active(laws)
    _require_positive(A, "0 < A <= 1: before the extinction")
    active = [(a, k, e) for (a, k), e in zip(laws, strengths) if k > 0]
    if len(active) == 1:
        alpha, kappa, eps = active[0]
        w = _w(alpha.ball(), alpha.ball()) * eps**2
        if alpha.ball() == 1:
            return w * A.log() / kappa
        exponent = alpha.ball() - 1
        return w / (exponent * kappa) * (exponent * A.log()).expm1()
    # delta_i delta_j = eps_i eps_j e^(-(alpha_i + alpha_j - 2) r): exponents and coefficients of the numerator.
    pairs = [(a.ball() + b.ball() - 2, _w(a.ball(), b.ball()) * e * f) for a, _, e in active for b, _, f in active]
    return -_integral([(a, k) for a, k, _ in active], pairs, -A.log())


def _require_positive(A: arb, accepted: str) -> None:
    """InputError for A <= 0; TooWideError for a ball that may be positive, as next to the extinction."""
    if A <= 0:
        raise InputError("amplitude", f"{A.str(5)} is not positive", accepted)
    if not A > 0:
        raise TooWideError(f"the amplitude {A.str(5)} is not certainly positive")


def _is_before(tau: arb, end: arb | None) -> bool | None:
    """Whether tau < end; None if the balls do not tell.  No end is later than any time."""
    if end is None or tau < end:
        return True
    return False if tau >= end else None


def F(a: Fraction | arb, z: arb) -> arb:
    """2F1(1, a; a+1; z) for a > 0, z < 0: for a = p/q and z < -1/4 by q logarithms, otherwise by Arb.

    >>> (F(Fraction(1, 2), arb(-3)) * arb(3).sqrt() * 3 / arb.pi()).str(10)       # arctan(sqrt 3)/sqrt 3
    '[1.000000000 +/- ...]'
    """
    # Both forms enclose the same number, so that this is a choice of speed and width: y^(-p) undoes 2 p/q bits at z =
    # -1/4 and more nearer to 0, and a thousand logarithms and steps are slower than Arb's series.
    if isinstance(a, Fraction) and z < -0.25 and a.denominator + a.numerator < 1000:
        return _log_form(a.numerator, a.denominator, -z)
    b = arb(fmpq(a.numerator, a.denominator)) if isinstance(a, Fraction) else a
    return z.hypgeom_2f1(1, b, b + 1, abc=True)


def _log_form(p: int, q: int, w: arb) -> arb:
    """p y^(-p) I_p with y = w^(1/q), I_p = int_0^y u^(p-1)/(1+u^q) du (``hypergeometric``).

    1 - y/root stays off (-inf, 0]: its imaginary part y sin(theta) vanishes only at theta = pi, where it is 1 + y.
    """
    y = (w.log() / q).exp()
    # 1 <= low <= q is where the sum of logarithms holds; the recursion leads from there up to p.
    low = (p - 1) % q + 1
    total = acb(0)
    for j in range(q):
        theta = fmpq(2 * j + 1, q)
        direction = acb(arb.cos_pi_fmpq(-theta), arb.sin_pi_fmpq(-theta))
        total += direction ** (-low) * (1 - y * direction).log()
    # The roots come in conjugate pairs, so the imaginary part holds 0.
    integral = -total.real / q
    for n in range(low + q, p + 1, q):
        integral = y ** (n - q) / (n - q) - integral
    return p * integral / y**p


def _has_companion(active: Laws) -> bool:
    """Whether two laws have 2F1(1, b; b+1; z) with an index b, next to 1/(difference of the exponents), that is small.

    Arb's series take as many steps as b is large: two exponents next to each other are left to the integral.
    """
    return len(active) == 2 and bool(active[1][0].ball() - active[0][0].ball() > arb(2) ** -16)


def _active(laws: Laws) -> list[tuple[ExactReal, arb]]:
    """The laws of positive strength, by exponent; InputError for a strength that is not certainly 0 or positive."""
    for _, kappa in laws:
        if not (kappa == 0 or kappa > 0):
            raise InputError(
                "strength", f"the strength {kappa.str(5)} is not certainly >= 0", "dissipative laws, strengths >= 0"
            )
    active = sorted(((a, k) for a, k in laws if k > 0), key=lambda law: law[0])
    if not active:
        raise InputError("law", "every strength is zero: the amplitude is constant", "at least one b > 0")
    return active


def _time_one(alpha: ExactReal, kappa: arb, A: arb) -> arb:
    exponent = 1 - alpha.ball()
    if exponent == 0:
        return -A.log() / kappa
    return -(exponent * A.log()).expm1() / (exponent * kappa)


def _amplitude_one(alpha: ExactReal, kappa: arb, tau: arb) -> arb:
    exponent = alpha.ball() - 1
    if exponent == 0:
        return (-kappa * tau).exp()
    return (-(exponent * kappa * tau).log1p() / exponent).exp()


def _index(numerator: Fraction | arb, low: ExactReal, high: ExactReal) -> Fraction | arb:
    """numerator/(high - low), as a Fraction when everything is rational."""
    if isinstance(numerator, Fraction):
        return numerator / (high.rational - low.rational)
    return numerator / (high.ball() - low.ball())


def _shifted(alpha: ExactReal, other: ExactReal, sign: int) -> Fraction | arb:
    """sign (alpha - 1), as a Fraction if both exponents are rational."""
    return sign * (alpha.rational - 1) if alpha.is_rational and other.is_rational else sign * (alpha.ball() - 1)


def _companion(low: tuple[ExactReal, arb], high: tuple[ExactReal, arb], x: arb) -> arb:
    """The companion antiderivative, 0 at x = 0; alpha < 1."""
    (a, kappa), (b, kappa_prime) = low, high
    exponent = 1 - a.ball()
    z = -kappa_prime / kappa * ((b.ball() - a.ball()) * x.log()).exp()
    return (exponent * x.log()).exp() / (kappa * exponent) * F(_index(_shifted(a, b, -1), a, b), z)


def _printed(low: tuple[ExactReal, arb], high: tuple[ExactReal, arb], x: arb) -> arb:
    """Footnote 22 as printed; alpha >= 1."""
    (a, kappa), (b, kappa_prime) = low, high
    exponent = 1 - b.ball()
    z = -kappa / kappa_prime * ((a.ball() - b.ball()) * x.log()).exp()
    return (exponent * x.log()).exp() / (kappa_prime * exponent) * F(_index(_shifted(b, a, 1), a, b), z)


def _time_two(low: tuple[ExactReal, arb], high: tuple[ExactReal, arb], A: arb) -> arb:
    antiderivative = _companion if low[0] < 1 else _printed
    return antiderivative(low, high, arb(1)) - antiderivative(low, high, A)


def _w(a: arb, b: arb) -> arb:
    return a * b * moment(a + b) / ((a + 1) * (b + 1))


def _integral(laws: Laws, numerator: Sequence[tuple[arb, arb]], s: arb) -> arb:
    """int_0^s (sum_j c_j e^(-beta_j r))/g(r) dr, by the mean-value form in s; an empty numerator is 1."""
    terms = [(1 - a.ball(), k) for a, k in laws]

    def integrand(r: acb, analytic: bool) -> acb:
        top = sum((c * (-beta * r).exp() for beta, c in numerator), acb(0)) if numerator else acb(1)
        # Where the sum may vanish this ball is not finite, and the integrator bisects: ``analytic`` need not be asked.
        return top / sum((k * (e * r).exp() for e, k in terms), acb(0))

    # The mean value theorem: what lies between the middle and any s of the ball is the integrand somewhere on the way,
    # which the integrand of the whole ball encloses.
    middle = s.mid()
    whole = integral(integrand, arb(0), middle, "an integral over the envelope")
    return whole + integrand(acb(s), False).real * (s - middle)


def _rate(laws: Laws, s: arb) -> arb:
    return sum((k * ((1 - a.ball()) * s).exp() for a, k in laws), arb(0))


def _inverse(laws: Laws, tau: arb) -> arb | None:
    """s(tau) by Newton from a double-precision guess, then the enclosure of the module docstring, or None."""
    # Doubles give the place to look at; the distance of tau at that place, and the root about it, are found in balls.
    guess = NumericEnvelope.of([(float(a.ball().mid()), float(k.mid())) for a, k in laws])
    start = float(guess.log_decay(float(tau.mid())))
    # The start is right to 50 bits or so, and each step of Newton's method doubles that: 50 * 2^(b-4) > prec for b the
    # length of prec in bits. One step less makes the ball wide, and not wrong.
    steps = max(ctx.prec.bit_length() - 4, 2)
    if not 0 <= start <= MAX_S:
        start, steps = _log_decay_near_the_end(laws, tau), steps + 4
    if not 0 <= start <= MAX_S:
        raise LimitError("time", f"the amplitude at {tau.str(5)} is below e^-600", "an earlier time")
    s, target = arb(start), tau.mid()
    for _ in range(steps):
        s = (s + (target - time(laws, (-s).exp())) * _rate(laws, s)).mid()
    distance = abs(tau - time(laws, (-s).exp())).upper()
    # With half = k distance g(s) and g growing by e^(c half) at most, the inversion wants c distance g <= ln(k)/k: k =
    # 2 is within 6 per cent of the best, k = e, so that a second radius would seldom help.
    half = (2 * distance * _rate(laws, s)).upper()  # g changes at most exponentially: where this fails, more does too
    return verified_root(s, distance, lambda near: _rate(laws, near), [half])


def _log_decay_near_the_end(laws: Laws, tau: arb) -> float:
    """About -ln A where doubles take tau for the end: e^(-w s)/(w kappa) is left of it, by the least exponent 1 - w.

    Infinite where there is no end, or none that is certainly later.
    """
    (alpha, kappa), end = laws[0], extinction_time(laws)
    if end is None or not end > tau:
        return inf
    w = 1 - alpha.ball()
    return float((-(w * kappa * (end - tau)).log() / w).mid())
