"""Large orders of the normal form of one law: the factorial divergence is a theorem, by Cauchy-Heine.

A map that is not a flow has a divergent formal flow.  With c, c_1, d_1, e_1 of ``expansions.divergence`` and
f = 4 pi^2 e_1 c the laws are proved (derivation ``large-orders``), each with a factor 1 + f/n + O(n^-2), n! being the
factorial:

    V_k     = -(-1)^(k/2)     (2 c_1/(pi c))     (k-3)!/(2 pi c)^(k-2),     k even,
    p_k/p_1 = -(-1)^((k-1)/2) 2 (c_1 + d_1/pi)   (k-2)!/(2 pi c)^(k-1),     k odd,
    Omega_k = -(-1)^(k/2)     (2 d_1/pi)         (k-1)!/(2 pi c)^k,         k even,

so V_(k+2)/V_k -> -(k-1)(k-2) (|alpha - 1| p_1/2)^2, 2 pi |c| = 2/(|alpha - 1| p_1), unless the constant vanishes.  The
O(n^-2) goes on as a series (``abel_rows``), and where to stop is measured (``truncation``).  At alpha = 0 and
alpha = 1 the series of U and W end or converge, and nothing here applies.
"""

from collections.abc import Sequence

import mpmath


def large_order(
    k: int, row: str, c: mpmath.mpf, f: mpmath.mpf, c_1: mpmath.mpf, d_1: mpmath.mpf, further: Sequence[mpmath.mpf] = ()
) -> mpmath.mpf:
    """The proved law of ``row`` "V", "p" (over p_1) or "Omega" at k with its first correction; 0 where k has no term.

    ``further``: g_2, g_3, … of ``abel_rows.corrections``, each of which takes a power of k from what is left.

    >>> c, f, d_1 = map(mpmath.mpf, ("0.75", "3.948", "0.4125"))
    >>> print(mpmath.nstr(large_order(40, "Omega", c, f, mpmath.mpf(0), d_1), 6))
    -6.93621e+18
    """
    size, n, power, odd = {
        "V": (2 * c_1 / (mpmath.pi * c), k - 3, k - 2, 0),
        "p": (2 * (c_1 + d_1 / mpmath.pi), k - 2, k - 1, 1),
        "Omega": (2 * d_1 / mpmath.pi, k - 1, k, 0),
    }[row]
    if n < 1 or k % 2 != odd:
        return mpmath.mpf(0)
    factor = 1 + sum(g / mpmath.ff(n, j) for j, g in enumerate((f, *further), 1))
    return -((-1) ** (k // 2)) * size * mpmath.factorial(n) / (2 * mpmath.pi * c) ** power * factor
