"""The product of two series that become known one coefficient after the other: long sums by blocks of polynomials.

A sum of k products costs Python k balls; the product of two polynomials costs a few nanoseconds a pair.  When a block
of b coefficients is complete its products with all that is known go into one polynomial, which holds what they add to
later coefficients.  What is left for the k-th coefficient, k = s + i in the block from s >= b on, are the pairs with a
factor in that block:

    (A B)_k = carried_k + sum_(s<=j<=k) (A_j B_(k-j) + B_j A_(k-j)).

The same products in another order, so that balls in give balls out that hold the truth.  Source: van der Hoeven, Relax,
but don't be too lazy, J. Symbolic Comput. 34 (2002) 479-542, section 4, with blocks of one size.

>>> a, b = [arb(1)], [arb(1)]
>>> product, found = GrowingProduct(a, b, 9, block=3), []
>>> for _ in range(9):  # 1/(1 - t) squared
...     found.append(int(product.last().unique_fmpz()))
...     a.append(arb(1))
...     b.append(arb(1))
>>> found
[1, 2, 3, 4, 5, 6, 7, 8, 9]
"""

from itertools import islice
from math import isqrt
from operator import mul

from flint import arb, arb_poly

_NONE = arb(0)
_FEW = 60
"""Coefficients below which one sum is as cheap.  The step of x'|x'|^(1/2)/10 in 80, 160, 300 and 1000 bits has 39, 73,
132 and 426: by blocks its coefficients take 1.1, 0.8, 0.6 and 0.33 times as long as by sums.  A pair costs 130 to 250
ns in Python and 15 to 40 in a polynomial, which costs 1 microsecond besides; blocks of 6 to 33 differ by 10 %.

What is out of reach by these calls: in 80 bits the pairs are 5 of the 7 microseconds of a coefficient, in 300 two whole
products take 0.3 of the 2 ms of a step, in 1000 2.1 of 20 ms.  Sizes of blocks that double (the source's section 4.1)
took 1.0 to 1.1 times as long, as short products cost 40 ns a pair in 300 bits and 190 in 1000; Newton's method for all
coefficients at once, whose variational equation (u', w') and its Wronskian solve, 0.85 times in 80 bits, 1.25 in 300
and 1000, and its balls had half of the bits; with 1/w and w^-alpha kept and led on by products, without logarithm and
exponential, 1.4 in 80 to 300; sums of integers at a fixed point, 0.8 in 80, 0.9 in 150 and 1.1 in 300 without a proof.

What pays beside the linear spring is one step of Newton's method from the first half, whose variational equation is
solved by its recurrence, in the bits that the second half needs (``taylor``).  A whole step takes, of what it took by
sums in all bits (first row) and by the blocks above (second):

    bits      68     80     110    150    220    300    500    1000
    by sums   0.81   0.76   0.51   0.49   0.53   0.51   0.43   0.31
    by blocks                                    0.84   0.86   0.95

In 300 bits logarithm, exponential and quotient of the last half are 0.65 of its 1.9 ms, in 182 bits."""


def block_for(order: int) -> int:
    """The length of a block for so many coefficients: as many coefficients as blocks."""
    return order if order < _FEW else isqrt(order) + 1


class GrowingProduct:
    """A B for lists that grow outside; ``order``: how many coefficients of it will be asked for, each once."""

    def __init__(self, A: list[arb], B: list[arb], order: int, block: int | None = None) -> None:
        self.A, self.B, self.order = A, B, order
        self.block = block_for(order) if block is None else block
        self.known, self.start = 0, 0  # coefficients given, and the first one of the block that is filled
        self.later = arb_poly([])  # what complete blocks add from ``start`` on
        self.carried: list[arb] = []

    def last(self) -> arb:
        """The next coefficient k = 0, 1, ...; A and B must be known through their k-th."""
        k, A, B = self.known, self.A, self.B
        self.known += 1
        if k - self.start == self.block:
            self._complete()
        start = self.start
        if not start:
            return sum(map(mul, A, reversed(B)), _NONE)
        i = k - start
        # The indices k - j <= i < b <= s: no pair has both factors in the block, so that none is counted twice.
        some = sum(map(mul, islice(A, start, None), B[i::-1]), self.carried[i])
        return sum(map(mul, islice(B, start, None), A[i::-1]), some)

    def _complete(self) -> None:
        """Add the products of the block that is complete with all that is known."""
        A, B, old = self.A, self.B, self.start
        new, room = old + self.block, self.order - old
        # From t^old on; beyond the order nothing is needed, which leaves the first ``room`` terms of each factor.
        found = arb_poly(A[old:new]) * arb_poly(B[: min(new, room)])
        if old:
            found += arb_poly(B[old:new]) * arb_poly(A[: min(old, room)])
        self.later, self.start = (self.later + found).right_shift(self.block), new
        self.carried = [self.later[i] for i in range(self.block)]
