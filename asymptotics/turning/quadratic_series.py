"""Exact power series for quadratic damping: the map F, the half period T, and their Abel functions, in p = 2|u|.

Let h(p) = p - log(1+p) and sigma(p) = sqrt(2 h(p)) = p - p^2/3 + ...  A half-swing leads from sigma to -sigma, hence

    F = -sigma^(-1)(-sigma(p)),
    T = integral over -pi/2 <= phi <= pi/2 of x'(s sin phi) (1 + x)^(-1/2) b(s^2 cos^2(phi) / 2),   s = sigma(p),

with x = sigma^(-1) and b(y) = sqrt(y / (1 - e^(-y))): s^2 is the level, so the averages of sin^(2j) cos^(2k) do the
rest.  F is reversible, F(-F(p)) = -p; so the Abel function of F (Psi(F) = Psi + 1) and the time function (Theta(F) =
Theta + T) are odd Laurent series in p without a logarithm.

>>> [str(c) for c in half_period_series(4)]     # T / pi = 1 + u^2/6 - 2 u^3/9 + 49 u^4/144 + ..., u = p/2
['1', '0', '1/24', '-1/36', '49/2304']
"""

from flint import fmpq, fmpq_poly, fmpq_series

from asymptotics.numbers.context import ctx


def map_series(order: int) -> list[fmpq]:
    """The coefficients of F(p) through p^order.

    >>> [str(c) for c in map_series(3)]
    ['0', '1', '-2/3', '4/9']
    """
    with ctx.workcap(order + 1):
        sigma = _sigma()
        # sigma(F) = -sigma(p) on the other branch: reversion of a power series over the rationals.
        return _coefficients(-sigma.reversion()(-sigma), order)


def half_period_series(order: int) -> list[fmpq]:
    """The coefficients of T(p) / pi through p^order; T is the duration of a half-swing that starts, or ends, at p.

    A half-swing that ends at q has the duration T(-q): both ends lie on one level.  Smith's series of the transit
    time, sum H_i(pi) u^i (``motions.invariants.symbolic``), gives the same numbers by another route.
    """
    with ctx.workcap(order + 2):
        sigma, y = _sigma(), fmpq_series([0, 1], prec=order + 2)
        x = sigma.reversion()
        speed = list(x.derivative() / (1 + x).sqrt())
        stretch = list((y / (1 - (-y).exp())).sqrt())
        # Averages of sin^(2j) cos^(2k) over the half-turn: (2j-1)!! (2k-1)!!/(2j+2k)!!, so that a product of two series
        # gives all of them; b's variable s^2 cos^2/2 brings the 2^-k.
        by_sine = fmpq_poly([c * _odd_factorial(j) for j, c in enumerate(speed[::2])])
        by_cosine = fmpq_poly([c * _odd_factorial(k) / 2**k for k, c in enumerate(stretch[: order // 2 + 1])])
        level = [c / _even_factorial(n) for n, c in enumerate(by_sine.mul_low(by_cosine, order // 2 + 1))]
        return _coefficients(fmpq_series(level, prec=order + 2)(sigma * sigma), order)


def abel_coefficients(terms: int) -> list[fmpq]:
    """c_0, ..., c_(terms-1) of Psi = sum c_k p^(2k-1), so that Psi(F(p)) - Psi(p) - 1 = O(p^(2 terms)).

    >>> [str(c) for c in abel_coefficients(3)]
    ['3/2', '1/15', '-4/14175']
    """
    return _solve([fmpq(1)], terms)


def time_coefficients(terms: int) -> list[fmpq]:
    """theta_k / pi of Theta = sum theta_k p^(2k-1), so that Theta(F(p)) - Theta(p) - T(p) = O(p^(2 terms)).

    >>> [str(c) for c in time_coefficients(3)]
    ['3/2', '1/240', '-5303/7257600']
    """
    return _solve(half_period_series(2 * terms), terms)


def _solve(increment: list[fmpq], terms: int) -> list[fmpq]:
    """The odd Laurent series with a given increment under F, power by power: p^(2k-1) grows by -(2k-1) 2/3 p^(2k)."""
    order = 2 * terms + 1
    ratio = fmpq_poly(map_series(order)[1:])  # F(p) / p
    with ctx.workcap(order):
        power = fmpq_poly(_coefficients(1 / fmpq_series(list(ratio), prec=order), order - 1))
    square, rest, solution = ratio.mul_low(ratio, order), fmpq_poly(increment), []
    for k in range(terms):
        grown = power - 1  # (F/p)^(2k-1) - 1 begins with p
        step = grown.right_shift(1) if k == 0 else grown.left_shift(2 * k - 1)
        # The lowest power that is left, p^(2k), belongs to c_k; the odd ones must vanish by themselves, which the last
        # lines check.
        c = rest[2 * k] / step[2 * k]
        solution.append(c)
        rest = (rest - c * step).truncate(2 * terms)
        power = power.mul_low(square, order)
    if rest:
        raise ArithmeticError("the increments leave an odd power: the map is not reversible")
    return solution


def _sigma() -> fmpq_series:
    """sigma(p) = p sqrt(1 - 2p/3 + 2p^2/4 - ...) to the current number of terms."""
    ratio = [fmpq(2 * (-1) ** k, k + 2) for k in range(ctx.cap)]
    return fmpq_series([0, 1], prec=ctx.cap) * fmpq_series(ratio, prec=ctx.cap).sqrt()


def _coefficients(series: fmpq_series, order: int) -> list[fmpq]:
    return [series[k] for k in range(order + 1)]


def _odd_factorial(k: int) -> fmpq:
    """(2k-1)!! = 1 3 5 ... (2k-1)."""
    value = fmpq(1)
    for j in range(1, 2 * k, 2):
        value *= j
    return value


def _even_factorial(k: int) -> fmpq:
    """(2k)!! = 2 4 ... 2k."""
    value = fmpq(1)
    for j in range(2, 2 * k + 1, 2):
        value *= j
    return value
