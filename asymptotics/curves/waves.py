"""The waveforms x_k(psi) of the turning-point gauge as numbers, for any exponents and springs: the response of the fast
phase at each order of multiple scales, in balls (interval arithmetic) or tabulated.

    X = a (cos psi + sum_k delta^k x_k(psi)),      delta_i = epsilon_i a^(d_i-1),

x_k of integer exponents are polynomials; all others are integrals, in balls (``multiple_scales.certified_waves``)
and tabulated in doubles (``motions.waveform``).

>>> waves = waveforms("5/2", order=4)
>>> waves.at(1, digits=12)[3], waves.at(1, digits=12)[4]
('0.0141947515195', '0.0171230234815')
>>> waves.sample([0.0, 1.0])[3].round(10).tolist()
[0.0, 0.0141947515]
>>> waves.integral(3).rhs.has(Integral), waves.integral(1).rhs.has(Integral)
(True, False)
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from flint import arb
from numpy.typing import ArrayLike
from sympy import Eq
from sympy import Integral as Integral  # for the examples

from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.equations.given import terms_of
from asymptotics.expansions.half_swings.certified_zeros import certified_half_swing
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.multiple_scales.certified_waves import WaveSource, half_turns, wave_source, waves_at
from asymptotics.expansions.multiple_scales.hierarchy import MAX_OPEN_ORDER, multiple_scales
from asymptotics.expansions.multiple_scales.orders import order_letters
from asymptotics.expansions.multiple_scales.ring import Wave
from asymptotics.expansions.multiple_scales.symbolic import MultipleScales
from asymptotics.expansions.multiple_scales.turning import turning_hierarchy
from asymptotics.expansions.normal_form.flow import flow_of
from asymptotics.gauges import TURNING_POINT
from asymptotics.law import Law, LawLike, SpringLike
from asymptotics.motions.waveform import WaveformTable
from asymptotics.numbers.arrays import real_array
from asymptotics.numbers.context import cached_property, ctx, lru_cache
from asymptotics.numbers.decimals import bits_for, certified_decimal
from asymptotics.numbers.policy import Number, exact_integer, exact_number, require_one
from asymptotics.present.shown import Page, Shown
from asymptotics.running.public import public
from asymptotics.series import Key
from asymptotics.terms import Term

# As ``solution`` and ``motion`` serve; more only takes longer.
MAX_DIGITS = 300
MAX_BALLS = 10_000
"""Phases at once: a ball at a time, not an array of doubles."""
# 160 bits for the flow behind a table of doubles: 53 are needed, the rest is for what high orders lose.  Ten seconds
# for the exact polynomials, of which balls are the substitute: either choice is one of time, not of what is claimed.
_BITS, _SECONDS = 160, 10.0
Label = int | Key


@dataclass(frozen=True, repr=False)
class Waveforms(Shown):
    """x_k, 1 <= |k| <= ``order``, by k: an integer for one force, else a tuple in the order of ``terms``."""

    terms: tuple[Term, ...]
    order: int
    notes: tuple[str, ...] = field(default=(), compare=False)

    @public
    def at(self, psi: Number, *, digits: int = 30, max_seconds: Number = 60) -> dict[Label, str]:
        """x_k at one phase ``psi`` (rad), to ``digits``, correctly rounded and proved to be; "0" where it is 0."""
        require_one(psi, "psi", "sample(psi)")
        phase, D = exact_number(psi, "psi"), exact_integer(digits, "digits", 1, MAX_DIGITS)
        return {
            _label(k): certified_decimal(lambda k=k: self.enclosed(phase.ball())[k], D)  # type: ignore[misc]
            for k in self.keys
        }

    @public
    def balls(self, psi: ArrayLike, *, digits: int = 30, max_seconds: Number = 60) -> dict[Label, list[arb]]:
        """x_k at a sequence of exact phases ``psi`` (rad) as balls of FLINT, absolute radius about 10^-``digits``."""
        D = exact_integer(digits, "digits", 1, MAX_DIGITS)
        if isinstance(psi, str) or not isinstance(psi, Sequence | np.ndarray):
            raise InputError("psi", f"{type(psi).__name__} is no sequence of phases", "a list of exact numbers")
        if len(psi) > MAX_BALLS:
            raise InputError("psi", f"{len(psi)} phases", f"at most {MAX_BALLS} at once")
        phases = [exact_number(p, "psi") for p in psi]
        with ctx.workprec(bits_for(D)):
            found = [self.enclosed(p.ball()) for p in phases]
        return {_label(k): [row[k] for row in found] for k in self.keys}

    @public
    def sample(self, psi: ArrayLike, *, max_seconds: Number = 60) -> dict[Label, Any]:
        """x_k at an array of phases ``psi`` (rad) in doubles, to about 1e-13: an array of the same shape for each k."""
        phases = real_array(psi, "psi")
        if not np.all(np.isfinite(phases)):
            raise InputError("psi", "a phase is not finite", "phases in rad")
        # X(psi + pi) = -X(psi) brings every phase to the one half-swing that is tabulated.
        turns = np.floor(phases / np.pi)
        chi, side = (phases - np.pi * turns).ravel(), 1.0 - 2.0 * np.mod(turns, 2.0)
        rows, c, s = self.table.at(chi), np.cos(chi), np.sin(chi)
        waves = zip(self.table.keys, rows[::2], rows[1::2])
        return {_label(k): (c * P - s * Q).reshape(phases.shape) * side for k, P, Q in waves}

    @public
    def integral(self, n: int, *, max_seconds: Number = 60) -> Eq:
        """X_n of order ``n`` as the hierarchy has it: a polynomial, a form by 2F1, or the integral of lower orders."""
        found = self.scales.orders[exact_integer(n, "n", 1, self.order)].solution
        assert found is not None
        return found

    @property
    def keys(self) -> list[Key]:
        """The exponents k for which x_k is there, ordered by their degree."""
        return list(self.table.keys)

    @cached_property
    def scales(self) -> MultipleScales:
        """The multiple-scale hierarchy from which the waveforms are taken."""
        return multiple_scales(Law.from_terms(self.terms), order=self.order, gauge=TURNING_POINT)

    @cached_property
    def table(self) -> WaveformTable:
        """The waveforms x_k as a table of doubles over the phase."""
        return wave_table(self.terms, self.order)

    def enclosed(self, psi: arb) -> dict[Key, arb]:
        """x_k at the phase ``psi`` (rad, a ball): polynomials where the forces of a key are such, else by orbits."""
        # x_k(0) = 0 by the gauge: a turning point has the amplitude a.  The orbit of ``waves_at`` begins there and
        # would divide by psi.
        if psi.is_zero():
            return dict.fromkeys(self.keys, arb(0))
        side, chi = half_turns(psi)
        known = {k: side * wave.at(chi) for k, wave in _polynomials(self.terms, self.order).items()}
        if len(known) < len(self.keys):
            # Ziv's loop asks for x_k at several precisions; the source is the costly part, and one of more bits serves.
            bits = -(-ctx.prec // 64) * 64  # few sources for many precisions
            # Where both routes have x_k the polynomial stands: it is exact, and knows its zeros.
            known = waves_at(_source(self.terms, self.order, bits), psi) | known
        return known

    def _page(self) -> Page:
        shapes = ", ".join(t.shape() for t in self.terms)
        return Page(
            f"x_k(psi) of {shapes}, through order {self.order}",
            ("turning-point gauge; certified: at, balls; doubles: sample", *self.notes),
        )

    def _formula(self) -> str:
        return r"X = a\,(\cos\psi + \sum_{k} \delta^{k} x_{k}(\psi))"

    def _letters(self) -> dict[str, str]:
        return order_letters(TURNING_POINT) | {"x": "waveform of order k", r"\delta": "local strength", "k": "order"}


@public
def waveforms(law: LawLike, *, order: int = 4, spring: SpringLike | None = None, max_seconds: Number = 60) -> Waveforms:
    """The waveforms x_k(psi) of the turning-point gauge, x = A cos psi + A sum_k delta^k x_k(psi), certified or arrays.

    Parameters
    ----------
    law
        an exponent, a list of exponents, a law or an oscillator: its exponents, which are numbers
    order
        the last k, 1 to 12
    spring
        springs beside the linear one, {P: c} or {(P, Q): c} for c x|x|^(P-1) |x'|^Q, or "pendulum"
    max_seconds
        the time the call may take, in s

    Returns
    -------
    Waveforms
        ``at`` a phase (certified digits), ``balls``, ``sample`` for arrays of phases, ``integral`` as the hierarchy has
        it

    Raises
    ------
    InputError
        for a symbolic exponent, an order out of range, and |x|^M of odd M where it is no function to this order

    Examples
    --------
    >>> waveforms(2, order=1).at("1/2", digits=12)
    {1: '0.191224146646'}
    """
    N = exact_integer(order, "order", 1, MAX_OPEN_ORDER)
    terms, _, _, notes = terms_of(law, spring)
    return Waveforms(tuple(terms), N, notes)


def wave_table(terms: tuple[Term, ...], order: int) -> WaveformTable:
    """The waveforms as splines: P_k, Q_k with X - i X' = a e^(i psi) (1 + sum delta^k (P_k + i Q_k))."""
    # The balls are made at that precision and read as doubles afterwards; a table is one quadrature for all phases.
    forces = Forces.of(terms, order)
    with ctx.workprec(_BITS):
        return WaveformTable.of(flow_of(certified_half_swing(forces, order)), forces, order)


# Kept: certified half-swings through the order, seconds each.  Eight are the precisions of a few laws at once.
@lru_cache(maxsize=8)
def _source(terms: tuple[Term, ...], order: int, bits: int) -> WaveSource:
    return wave_source(Forces.of(terms, order), order, bits)


@lru_cache(maxsize=8)
def _polynomials(terms: tuple[Term, ...], order: int) -> dict[Key, Wave]:
    """x_k of the keys whose forces are polynomials on a half-swing: exact, zeros among them; none if that is long."""
    # x_k depends on the forces alone whose index in k is not 0, so that a sum has the polynomials of its polynomial
    # part.
    places = [i for i, t in enumerate(terms) if Forces.of([t], order).is_closed]
    if not places:
        return {}
    try:
        closed = turning_hierarchy([terms[i] for i in places], order, max_seconds=_SECONDS)
    # Too dear exactly (estimated before the work): balls serve, only a 0 is then not told apart from a small number.
    except LimitError:
        return {}
    found: dict[Key, Wave] = {}
    for part in closed.X[1:]:
        for key, wave in part.items():
            full = [0] * len(terms)
            for i, n in zip(places, key):
                full[i] = n
            found[tuple(full)] = wave
    return found


def _label(key: Key) -> Label:
    return key[0] if len(key) == 1 else key
