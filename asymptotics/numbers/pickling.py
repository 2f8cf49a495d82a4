"""Pickling of FLINT numbers, for process pools: the round trip is exact, whatever precision the receiver works at.

>>> import pickle, flint
>>> x = flint.arb(2).sqrt()
>>> y = pickle.loads(pickle.dumps(x))
>>> y.mid() == x.mid() and y.rad() == x.rad()
True

Types that python-flint pickles by itself keep their own method.
"""

import copyreg
from typing import Any

from flint import (
    Ordering,
    acb,
    acb_poly,
    acb_series,
    arb,
    arb_mat,
    arb_poly,
    arb_series,
    fmpq,
    fmpq_mpoly,
    fmpq_mpoly_ctx,
    fmpq_poly,
    fmpq_series,
    fmpz,
    fmpz_poly,
)

_Pair = tuple[int, int]


def _pair(x: arb) -> _Pair | None:
    if not x.is_finite():
        # Not a finite ball: it comes back as nan, the enclosure of everything.
        return None
    # Exact: integers and a power of 2, which the receiver puts together without rounding.
    mantissa, exponent = x.man_exp()
    return int(mantissa), int(exponent)


def _make_arb(middle: _Pair | None, radius: _Pair | None) -> arb:
    if middle is None or radius is None:
        return arb.nan()
    x = arb(middle, radius)
    if _pair(x.rad()) == radius:
        return x
    # FLINT rounds up a radius that it is handed, some by a unit though they fit in 30 bits.  Half a unit less is
    # rounded up to the radius itself; that is looked at, and else the wider ball stands.
    shift = 30 - radius[0].bit_length()
    exact = arb(middle, (2 * (radius[0] << shift) - 1, radius[1] - shift - 1)) if shift >= 0 else x
    return exact if _pair(exact.rad()) == radius else x


def _reduce_arb(x: arb) -> tuple[Any, ...]:
    return _make_arb, (_pair(x.mid()), _pair(x.rad()))


def _make_acb(real: arb, imag: arb) -> acb:
    return acb(real, imag)


def _make_fmpz_poly(coefficients: list[int]) -> fmpz_poly:
    return fmpz_poly([fmpz(c) for c in coefficients])


def _make_fmpq_poly(numerators: list[int], denominator: int) -> fmpq_poly:
    return fmpq_poly([fmpz(c) for c in numerators], fmpz(denominator))


def _make_fmpq_series(coefficients: list[tuple[int, int]], precision: int) -> fmpq_series:
    return fmpq_series([fmpq(p, q) for p, q in coefficients], prec=precision)


def _make_fmpq_mpoly(
    names: tuple[str, ...], ordering: Ordering, terms: dict[tuple[int, ...], tuple[int, int]]
) -> fmpq_mpoly:
    # FLINT has one ring for the same names in the same order: what comes back belongs to that of the receiver.
    return fmpq_mpoly_ctx.get(names, ordering).from_dict({powers: fmpq(p, q) for powers, (p, q) in terms.items()})


def _reduce_fmpq_mpoly(f: fmpq_mpoly) -> tuple[Any, ...]:
    ring = f.context()
    terms = {tuple(map(int, powers)): (int(c.p), int(c.q)) for powers, c in f.to_dict().items()}
    return _make_fmpq_mpoly, (ring.names(), ring.ordering(), terms)


_REDUCERS: dict[type, Any] = {
    arb: _reduce_arb,
    acb: lambda z: (_make_acb, (z.real, z.imag)),
    arb_poly: lambda p: (arb_poly, (list(p),)),
    acb_poly: lambda p: (acb_poly, (list(p),)),
    arb_series: lambda s: (arb_series, (list(s), s.prec)),
    arb_mat: lambda m: (arb_mat, (m.nrows(), m.ncols(), m.entries())),
    acb_series: lambda s: (acb_series, (list(s), s.prec)),
    fmpq_mpoly: _reduce_fmpq_mpoly,
    fmpz_poly: lambda p: (_make_fmpz_poly, ([int(c) for c in p],)),
    fmpq_poly: lambda p: (_make_fmpq_poly, ([int(c) for c in p.numer()], int(p.denom()))),
    fmpq_series: lambda s: (_make_fmpq_series, ([(int(c.p), int(c.q)) for c in s], s.prec)),
}


def _has_native_pickling(kind: type) -> bool:
    # Cython gives each class a ``__reduce__`` that only raises: that one counts as none.
    return "__reduce__" in vars(kind) and "reduce_cython" not in getattr(kind.__reduce__, "__name__", "reduce_cython")


for _kind, _reducer in _REDUCERS.items():
    if not _has_native_pickling(_kind):
        copyreg.pickle(_kind, _reducer)
