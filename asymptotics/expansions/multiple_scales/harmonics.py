"""Fourier coefficients of |sin|^alpha sgn sin for any alpha >= 0, and the sums over them that the method needs.

    |sin psi|^alpha sgn sin psi = sum_(n odd) b_n sin n psi,
    b_n = (-1)^((n-1)/2) 2^(1-alpha) Gamma(alpha+1)/(Gamma((alpha+n)/2 + 1) Gamma((alpha-n)/2 + 1)),
    b_1 = 2 M_(alpha+1),    b_(n+2)/b_n = (n - alpha)/(n + alpha + 2),    b_n = O(n^(-alpha-1)).

For odd alpha the sum ends at n = alpha; alpha = 0 is the square wave, b_n = 4/(pi n).

*Sums that telescope* (hypergeometric terms, as in Gosper's summation).  With the ratio of neighbours, for b_n of alpha
and c_n of beta (alpha = beta for one law),

    b_n c_n [1/(n^2-1) + (alpha+beta+1)/((alpha+1)(beta+1))] = F(n+2) - F(n),
    F(n) = -(n+alpha)(n+beta)/(2 (alpha+1)(beta+1)(n-1)) b_n c_n,
    n b_n/(n^2-1) = G(n+2) - G(n),    G(n) = -(n+alpha)/(2 (alpha+1)(n-1)) b_n,

F and G vanish at infinity, and sum_(n>=1) b_n c_n = 2 M_(alpha+beta) (Parseval).  So, over odd n >= 3,

    sum n^2 b_n c_n/(n^2-1) = [2 alpha beta M_(alpha+beta) + (1 - alpha - beta - 3 alpha beta) p q]/((alpha+1)(beta+1)),
    sum n b_n/(n^2-1) = (1-alpha)/(2 (alpha+1)) p,        p = M_(alpha+1), q = M_(beta+1).

*A spring* x|x|^(p-1) sees the cosine: |cos psi|^p sgn cos psi = sum_(n odd) d_n cos n psi with d_n = (-1)^((n-1)/2) b_n
of p, so d_(n+2)/d_n = -(n-p)/(n+p+2).  The same certificates with a sign, the value 1 of the series at psi = 0 and the
mean N = <|cos|^(p-1) |sin|^(alpha+1)> = (1/(2 p)) sum_(n>=1) n b_n d_n give, b_n of alpha, d_n of p, q = M_(p+1),

    sum n b_n d_n/(n^2-1) = [4 p_ q - 2 p N - (1-alpha) (1-p) p_ q]/((alpha+1)(p+1)),      p_ = M_(alpha+1),
    sum d_n/(n^2-1) = [(p+3) q - 2]/(2 (p+1)),                                              again over n >= 3.

>>> from sympy import Integer
>>> [harmonic(Integer(3), n) for n in (1, 3, 5)], harmonic(Integer(0), 5)
([3/4, -1/4, 0], 4/(5*pi))
>>> velocity_sum(Integer(3), Integer(3))                     # 9/8 b_3^2
9/128
"""

from sympy import Expr

from asymptotics.expansions.moments.symbolic import moment


def harmonic(alpha: Expr, n: int) -> Expr:
    """b_n for an odd n >= 1 by the ratio of neighbours: 0 where the Gamma functions have their poles."""
    value = 2 * moment(alpha + 1)
    for k in range(1, n, 2):
        # For an odd alpha the factor at k = alpha is 0, and with it all later harmonics.
        value = value * (k - alpha) / (k + alpha + 2)
    return value


def velocity_sum(alpha: Expr, beta: Expr) -> Expr:
    """sum over odd n >= 3 of n^2 b_n c_n/(n^2 - 1), the velocity of X_1 against the force: in closed form."""
    products = (1 - alpha - beta - 3 * alpha * beta) * moment(alpha + 1) * moment(beta + 1)
    return (2 * alpha * beta * moment(alpha + beta) + products) / ((alpha + 1) * (beta + 1))


def spring_sum(p: Expr, r: Expr) -> Expr:
    """sum over odd n >= 3 of d_n d_n'/(n^2 - 1) of two springs p and r: ``velocity_sum`` less Parseval's.

    >>> from sympy import Integer
    >>> spring_sum(Integer(3), Integer(3))                     # 1/8 d_3^2
    1/128
    """
    # n^2/(n^2-1) = 1 + 1/(n^2-1): from velocity_sum goes what Parseval's sum has from n = 3 on, 2 M - d_1 d_1'.
    products = moment(p + 1) * moment(r + 1)
    return velocity_sum(p, r) - 2 * moment(p + r) + 4 * products


def displacement_sum(p: Expr) -> Expr:
    """sum over odd n >= 3 of d_n/(n^2 - 1): X_1/a^p of a spring at psi = 0, in closed form.

    >>> from sympy import Integer
    >>> displacement_sum(Integer(3))
    1/32
    """
    return ((p + 3) * moment(p + 1) - 2) / (2 * (p + 1))
