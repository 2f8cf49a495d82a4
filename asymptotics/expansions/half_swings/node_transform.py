"""Sums over the zeros of a Chebyshev polynomial and values there, even and odd degrees apart: half the products.

The K nodes x_i = cos((2i+1) pi/(2K)) lie symmetrically, x_(K-1-i) = -x_i, and T_k(-x) = (-1)^k T_k(x).  So the sums
over all nodes are sums over the first half of f_i + f_(K-1-i) for even k, f_i - f_(K-1-i) for odd k (a node x = 0 in
the middle counts once and vanishes for odd k), and a polynomial has the values even part + odd part at x_i, even part -
odd part at -x_i.

>>> transform = NodeTransform(3)
>>> [x.str(5) for (x,) in transform.sums([[arb(1)], [arb(1)], [arb(4)]])]     # 1 + 1 + 4, (1 - 4) 3^(1/2)/2, -1 + 5/2
['6.0000', '[-2.5981 +/- ...]', '1.5000']
>>> [x.str(5) for x in transform.values([arb(1), arb(2), arb(0)])]             # 1 + 2 x
['[2.7321 +/- ...]', '1.0000', '[-0.73205 +/- ...]']
"""

from collections.abc import Sequence

from flint import arb, arb_mat, fmpq


class NodeTransform:
    """Of K nodes, at the current precision; ``places``: the x_i, descending."""

    def __init__(self, nodes: int) -> None:
        # T_k at the node i is cos(k (2i + 1) pi/(2K)): one table of 4K cosines has all of them.
        table = [arb.cos_pi_fmpq(fmpq(j, 2 * nodes)) for j in range(4 * nodes)]
        self.nodes, self.half = nodes, nodes // 2
        self.places = [table[2 * i + 1] for i in range(nodes)]
        first = range(nodes - self.half)
        self.even, self.odd = (
            arb_mat([[table[k * (2 * i + 1) % (4 * nodes)] for k in range(parity, nodes, 2)] for i in places])
            for parity, places in ((0, first), (1, range(self.half)))
        )
        self.to_even, self.to_odd = self.even.transpose(), self.odd.transpose()

    def sums(self, rows: Sequence[Sequence[arb]]) -> list[list[arb]]:
        """sum_i f_i T_k(x_i) for k = 0 … K - 1 (rows) of each column of values f_i (rows)."""
        pairs = list(zip(rows[: self.half], reversed(rows)))
        middle = [list(rows[self.half])] if self.nodes % 2 else []
        even = self.to_even * arb_mat([[a + b for a, b in zip(*pair)] for pair in pairs] + middle)
        if not pairs:
            return even.table()
        odd = self.to_odd * arb_mat([[a - b for a, b in zip(*pair)] for pair in pairs])
        found = [[arb(0)]] * self.nodes
        found[::2], found[1::2] = even.table(), odd.table()
        return found

    def values(self, h: Sequence[arb]) -> list[arb]:
        """sum_k h_k T_k at the nodes."""
        even = (self.even * arb_mat([[x] for x in h[::2]])).entries()
        odd = (self.odd * arb_mat([[x] for x in h[1::2]])).entries() if self.half else []
        below = [a - b for a, b in zip(even, odd)]
        return [*(a + b for a, b in zip(even, odd)), *even[self.half :], *reversed(below)]
