"""Values at Chebyshev points, coefficients and integrals of the polynomial through them: matrices.

Through values at the m ``nodes`` of ``chebyshev`` goes sum b_k T_k, k < m.  Its integral from -1 is sum b_k I_k,

    I_0 = T_1 + 1,    I_1 = (T_2 - 1)/4,    I_k = T_(k+1)/(2(k+1)) - T_(k-1)/(2(k-1)) - (-1)^k/(k^2 - 1).

>>> from asymptotics.return_map.chebyshev import nodes
>>> with ctx.workprec(80):
...     values = arb_mat([[t.exp()] for t in nodes(20)])
...     (integrals(20, 80) * (analysis(20, 80) * values))[20, 0].str(12), (arb(1).exp() - arb(-1).exp()).str(12)
('[2.35040238729 +/- ...]', '[2.35040238729 +/- ...]')
"""

from flint import arb, arb_mat, fmpq

from asymptotics.numbers.context import ctx, lru_cache


@lru_cache(maxsize=2)
def analysis(m: int, bits: int) -> arb_mat:
    """From the values to b_0, ..., b_(m-1)."""
    with ctx.workprec(bits):
        cosines = _cosines(m)
        first, rest = arb(1) / m, arb(2) / m
        scaled = [(rest * c) for c in cosines]
        return arb_mat([[scaled[k * (2 * j + 1) % (4 * m)] if k else first for j in range(m)] for k in range(m)])


@lru_cache(maxsize=2)
def integrals(m: int, bits: int) -> arb_mat:
    """I_0, ..., I_(m-1) at the nodes and, in the last row, at 1."""
    with ctx.workprec(bits):
        cosines = _cosines(m)
        shares = [arb(1) / (2 * k) for k in range(1, m + 1)]
        # What makes each I_k vanish at -1: T_k(-1) = (-1)^k.
        starts = [arb(0), arb(1) / 4, *(arb((-1) ** k) / (k * k - 1) for k in range(2, m))]
        rows = []
        for j in range(m + 1):
            T = [cosines[k * (2 * j + 1) % (4 * m)] if j < m else arb(1) for k in range(m + 1)]
            row = [T[1] + 1, (T[2] - 1) / 4][:m]
            row += [T[k + 1] * shares[k] - T[k - 1] * shares[k - 2] - starts[k] for k in range(2, m)]
            rows.append(row)
        return arb_mat(rows)


def _cosines(m: int) -> list[arb]:
    return [arb.cos_pi(arb(fmpq(i, 2 * m))) for i in range(4 * m)]


def of_the_integral(b: list[arb]) -> list[arb]:
    """The coefficients of T_1, T_2, ... in the integral of sum b_k T_k.

    >>> of_the_integral([arb(1), arb(0), arb(3)])
    [-0.500000000000000, 0, 0.500000000000000]
    """
    # (b_(k-1) - b_(k+1))/(2k) with b_0 counted twice, the usual convention of a Chebyshev sum.
    padded = [2 * b[0], *b[1:], arb(0), arb(0)]
    return [(padded[k - 1] - padded[k + 1]) / (2 * k) for k in range(1, len(b) + 1)]
