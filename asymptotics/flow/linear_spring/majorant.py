"""The local expansion at a turning point is bounded, coefficient by coefficient, by an algebraic function.

With z_0 = w^2, z_i = w^alpha_i, D = w d/dw and P = y - N(w) = P_0 (1 - r), the equation dy/dw = -w/P reads

    D r = (z_0/P_0^2)/(1 - r) + sum_i alpha_i (epsilon_i/P_0) z_i.

D multiplies the monomial z^n by its exponent 2 n_0 + sum alpha_i n_i, which is at least 2 if z_0 divides it.  So with

    a = z_0/(2 P_0^2),    b = sum_i |epsilon_i z_i/P_0|,                     coefficientwise in the z,

    r << R = ((1+b) - sqrt((1-b)^2 - 4a))/2,     the solution of R = a/(1-R) + b, and
    r << S = 1 - sqrt(1 - 2a - 2b),              the solution of S = S^2/2 + a + b

(for S: D (r - r^2/2) = z_0/P_0^2 + (1-r) sum alpha_i beta_i z_i, where for beta_i > 0 all coefficients of r are >= 0,
so the product with r only takes away; beta_i -> -beta_i is z_i -> -z_i, which leaves absolute values).  Whichever is
smaller is used.  For 1/P = (1/P_0)/(1-r) the majorant is 1/(1-R).  Derivation ``turning-point-majorant``.

Tail: if every z_i is made e^(g_i) times larger and the majorant still converges there, to R*, then the monomials with
sum n_i g_i >= G add up to at most e^(-G) R* at the smaller z.

>>> majorant(arb("0.02"), arb("0.1")).str(8)
'[0.12279981 +/- ...]'
>>> majorant(arb(1), arb(0)) is None
True
"""

from flint import arb


def majorant(a: arb, b: arb) -> arb | None:
    """The smaller of R and S at a, b >= 0 as an upper bound below 1; None where neither certainly converges."""
    found: list[arb] = []
    under = (1 - b) ** 2 - 4 * a  # the root of R
    # The branch with R = 0 at z = 0, the smaller root: it is the majorant as long as the square root has not vanished
    # on the way.
    if b < 1 and under > 0:
        found.append(((1 + b - under.sqrt()) / 2).upper())
    under = 1 - 2 * (a + b)  # the root of S
    if under > 0:
        found.append((1 - under.sqrt()).upper())
    # r < 1 is what the geometric series of 1/(1 - r) needs.  Both are upper bounds coefficient by coefficient, so the
    # smaller one may be taken.
    found = [bound for bound in found if bound < 1]
    return min(found, default=None)
