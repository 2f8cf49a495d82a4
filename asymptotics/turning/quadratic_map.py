"""The turning points for quadratic damping (alpha = 2), one half-swing at a time, without losing digits.

The return map is a contraction, so the mean-value form (Moore, Interval Analysis, 1966) keeps the radius of a ball.

Write p = 2|u_n|, u = gamma x.  On a half-swing (1 + 2u) e^(-2u) takes one value at both ends (Smith (43)), so the next
amplitude q = 2|u_(n+1)| is the root in (0, 1) of

    p - log(1+p) = -q - log(1-q),        q = F(p) = 1 + W_0(-(1+p) e^(-(1+p))).

Evaluated in balls the formula loses two digits a step.  The map itself does not: 0 < F' < 1, because

    1/p + 2/3 < 1/q < 1/p + 1        (derivation ``smith-contraction``)

and F' = p (1-q) / (q (1+p)).  So F(ball) lies in F(midpoint) +- radius, and the radius only collects rounding errors.

>>> from flint import arb
>>> next_amplitude(arb(2))   # u_0 = 1
[0.82143937212... +/- ...]
"""

from collections.abc import Iterator

from flint import arb, fmpz

from asymptotics.numbers.context import ctx


def next_amplitude(p: arb) -> arb:
    """F(p) for a ball p > 0, to the full working precision: 2|u_(n+1)| from p = 2|u_n|.

    Raises ValueError if the ball reaches 0 or below.
    """
    middle = p.mid()
    if not p > 0:
        raise ValueError(f"the amplitude must be positive, not {p.str(5)}")
    # 0 < F' < 1 (derivation ``smith-contraction``): the image of the ball is no wider than the ball.
    return _at_exact_point(middle) + arb(0, p.rad())


def _at_exact_point(p: arb) -> arb:
    """F at an exact point.  Near p = 0 the argument of W is p^2 from its branch point: 2 log2(1/p) bits are added."""
    bits = ctx.prec + 8 + 2 * max(0, -_exponent(p))
    with ctx.workprec(bits):
        y = 1 + p
        q = 1 + (-y * (-y).exp()).lambertw()
    return +q


def _exponent(p: arb) -> int:
    """The integer e with 2^(e-1) <= |p| < 2^e for an exact nonzero p."""
    mantissa, exponent = p.man_exp()
    return fmpz(mantissa).bit_length() + int(exponent)


def amplitudes(p0: arb) -> Iterator[arb]:
    """Yield p_0, p_1, p_2, ... as balls at the precision current at each step."""
    p = p0
    while True:
        yield p
        p = next_amplitude(p)
