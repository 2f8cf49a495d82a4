"""|x - x_N| for the explicit form of one law, A and phi polynomials in D = A_0^(alpha-1), at all times: a theorem.

The differential inequality of ``uniform`` along the nonexpansive flow, for another approximate solution and its defect.

What ``envelopes.slow_time`` hands out solves the equations of order N up to terms that are cut off.  With r = A/A_0,
w = alpha - 1, delta = epsilon A^w = epsilon D r^w, p and Omega through N + 1 and A_0' = -p_1 epsilon D A_0, it leaves

    f_A   = (A'/A + p)/(epsilon D)     = -p_1 (1 + w D r_D/r) + sum_k p_k (epsilon D)^(k-1) r^(k w),
    f_phi = (phi' - Omega)/(epsilon D) = -w p_1 D phi_D - sum_k Omega_k (epsilon D)^(k-1) r^(k w),

power series in epsilon that begin with epsilon^N.  So z~ = A e^(i psi) Z(psi, delta), psi = tau + phi, with the
waveform through N + 2, solves the equations of motion up to, per unit of tau, A e^(i psi) times

    (1 + Omega) R + epsilon D [f_A (Z + E Z) + f_phi (i Z + Z_psi)],       E = w delta d/d delta,

R being that of ``waveform`` at order N + 1.  Two motions never part, so |z - z~| is at most the integral of its modulus
(derivation ``explicit-bound``).  With u = A_0, d tau = du/(p_1 epsilon D u), a start at rest and x_N, which omits the
terms N to N + 2 of the waveform:

    |x - x_N|/A(0)  <=  int_0^1 (r/p_1) [(1 + Omega) r^w |R|/delta + |f_A + i f_phi| + |f_A| sum_k |1 + k w| z_k delta^k
                        + |f_phi| sum_k y_k delta^k] du  +  sup_u u r sum_(k=N)^(N+2) xi_k delta^k,

|Z_k| <= z_k, |Z_k' + i Z_k| <= y_k, |Re e^(i psi) Z_k| <= xi_k; all on pieces of 0 <= u <= 1, where D is a ball.  For
alpha >= 1 this holds for every tau >= 0; below, D grows, and it holds up to a stated time.  The coefficients of f_A and
f_phi below epsilon^N vanish identically and are left out; those through J are computed, and Cauchy's inequality on
|epsilon| <= rho, where |r - 1| <= 1/2, bounds what is beyond.

>>> explicit_bound(Oscillator({2: "1/10"}), 3)
|x - x_N| <= 0.000043 for ever: proved
>>> explicit_bound(Oscillator({"1/2": "1/50"}), 3, until=40)
|x - x_N| <= 7.8e-7 for 0 <= t <= 40: proved
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from flint import acb, arb, arb_series

from asymptotics.bounds.local import NEXT
from asymptotics.bounds.reach import Reach
from asymptotics.bounds.uniform import MAX_ORDER, largest_strength, uniform_bound
from asymptotics.bounds.waveform import BITS, WaveformBounds, waveform_bounds
from asymptotics.envelopes.laurent import envelope_of_series
from asymptotics.envelopes.slow_time import explicit
from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.normal_form.tau_polynomial import TauPolynomial
from asymptotics.law import Oscillator
from asymptotics.numbers.context import cached_property, ctx
from asymptotics.numbers.decimals import directed_decimal
from asymptotics.numbers.extremes import greatest
from asymptotics.numbers.policy import Number, exact_integer, exact_number
from asymptotics.numbers.rationals import bounds
from asymptotics.series import Series
from asymptotics.terms import Term

# Pieces of u, which decide how sharp the integral is, and radii that are tried.
_PIECES, _TRIES = 128, 60
Rows = list[list[arb]]
Degrees = dict[int, arb]


def explicit_bound(oscillator: Oscillator, order: int = 3, *, until: Number | None = None) -> Reach:
    """The bound for x_N of order N as ``solution`` hands it out, from rest, before rounding; in m and s.

    InputError for several laws, springs, a start in motion, or an order out of range; LimitError where the local
    strength is beyond the range of the theorem.
    """
    order = exact_integer(order, "order", 1, MAX_ORDER)
    acting = _one_law(oscillator)
    last = None if until is None else exact_number(until, "until")
    if last is not None and not last > 0:
        raise InputError("until", f"{last} leaves no time", "a time > 0 in s")
    if not acting:
        return Reach("oo", "0", "proved")
    (term,) = acting
    # D = A_0^0 = 1: nothing is cut off in the explicit form, and the bound is that of the truncated equations.
    if term.velocity == 1:
        found = uniform_bound(oscillator, order, until=until)
        return Reach(found.until or "oo", found.bound, "proved")
    # Of order N + 1, so that the waveform goes through N + 2 and R begins with delta^(N+2), beyond what f_A and f_phi
    # leave.
    waves = waveform_bounds((term.velocity,), order + 1)
    with ctx.workprec(BITS):
        omega = oscillator.omega_0()
        theorem = _ExplicitTheorem.of(waves, order, term.strength.ball())
        x, end = theorem.bound(None if last is None else last.ball() * omega)
        if not x.is_finite():
            raise LimitError("law", "the explicit form is not bounded by these balls", "an exponent farther from 1")
        if last is not None:
            stated = str(last)
        else:
            # The time is rounded down and the bound up: both to the safe side.
            stated = "oo" if end is None else directed_decimal(min(bounds(end / omega)), 2, -1)
        return Reach(stated, directed_decimal(max(bounds(x * oscillator.length())), 2, 1), "proved")


def _one_law(oscillator: Oscillator) -> list[Term]:
    """The one loss that acts, or none; InputError for what the theorem does not cover."""
    law = oscillator.law
    law.require_dissipative("error bound")
    if not law.is_pure or len(law.terms) > 1:
        raise InputError("law", "the explicit form is that of one power of x'", "one law, or proved_until of a sum")
    if not oscillator.v0.is_zero:
        raise InputError("v0", "the theorem of the explicit form begins at rest", "v0 = 0, or a bound at one time")
    return [term for term in oscillator.dimensionless.terms if term.strength.sign > 0]


@dataclass(frozen=True, eq=False)
class _Piece:
    """A range of u = A_0: its width and its end, D, r and delta on it."""

    width: arb
    end: arb
    D: arb
    r: arb
    delta: arb


@dataclass(frozen=True, eq=False)
class _ExplicitTheorem:
    """``amplitude`` and ``phase``: r and phi, rows of coefficients of epsilon^n D^j; ``strength`` is epsilon."""

    waves: WaveformBounds
    order: int
    strength: arb
    amplitude: Rows
    phase: Rows
    p: Degrees
    Omega: Degrees

    @classmethod
    def of(cls, waves: WaveformBounds, order: int, strength: arb) -> "_ExplicitTheorem":
        """p has odd and Omega even degrees only (derivation ``parity-of-flow``)."""
        p = {k: arb(c) for (k,), c in waves.p.coefficients.items() if k % 2}
        Omega = {k: arb(c) for (k,), c in waves.Omega.coefficients.items() if k % 2 == 0}
        cut, detuning = (Series({(k,): c for k, c in f.items() if k <= order}, 1, order) for f in (p, Omega))
        alpha = waves.alphas[0]
        found = explicit(envelope_of_series(alpha.ball(), cut, detuning), order - 1, 1 / (alpha - 1).ball())
        amplitude, phase = (_rows(series, order) for series in found)
        return cls(waves, order, strength, amplitude, phase, p, Omega)

    @cached_property
    def w(self) -> arb:
        """alpha - 1, exact first."""
        return (self.waves.alphas[0] - 1).ball()

    @property
    def fades(self) -> bool:
        """Whether D = A_0^(alpha-1) falls."""
        return bool(self.waves.alphas[0] > 1)

    def bound(self, until: arb | None) -> tuple[arb, arb | None]:
        """The bound of x in units of the start, and the time up to which it is proved; None: for ever."""
        last = self._last(until)
        pieces = self._pieces(last)
        largest = greatest(piece.delta for piece in pieces)
        # The hypothesis of the waveform's bounds, on every piece.
        if not largest <= self._limit:
            reason = f"a local strength of {largest.str(3, radius=False)} is beyond the range of the theorem"
            raise LimitError("law", reason, f"at most {self._limit.str(2, radius=False)} at order {self.order}")
        rest = self._rest(greatest(piece.D for piece in pieces))
        r = self.waves.residual
        beyond = r.power + len(r.coefficients)
        rows = [*((c, r.power + k) for k, c in enumerate(r.coefficients))]
        # Cauchy's part as one more term c delta^J: c is taken at the largest delta, with which it grows.
        rows.append((r.beyond(largest, beyond) / largest**beyond, beyond))
        # The integral over u by its largest values on the pieces: all that enters is a ball that holds its range there.
        left_over = sum((one.width * self._left_over(one, rows, rest) for one in pieces), arb(0)) / self.p[1]
        return left_over + greatest(self._omitted(one) for one in pieces), self._time(last)

    def _left_over(self, one: _Piece, rows: Sequence[tuple[arb, int]], rest: tuple[arb, arb]) -> arb:
        """p_1 times the integrand on a piece."""
        d, (f_A, f_phi) = one.delta, self._defects(one, rest)
        Omega = sum((abs(c) * d**k for k, c in self.Omega.items()), arb(0))
        R = (1 + Omega) * one.r**self.w * sum((c * d ** (k - 1) for c, k in rows), arb(0))
        sizes = sum((abs(1 + k * self.w) * z * d**k for k, z in enumerate(self.waves.sizes) if k), arb(0))
        turns = sum((y * d**k for k, y in enumerate(self.waves.turns) if k), arb(0))
        return one.r * (R + abs(acb(f_A, f_phi)) + f_A * sizes + f_phi * turns)

    def _omitted(self, one: _Piece) -> arb:
        """The terms N to N + 2 of the waveform, which z~ has and x_N has not."""
        known = self.waves.displacements
        return one.end * one.r * sum((known[k] * one.delta**k for k in range(self.order, len(known))), arb(0))

    def _defects(self, one: _Piece, rest: tuple[arb, arb]) -> tuple[arb, arb]:
        """|f_A| and |f_phi|: the degrees N to J, and what is beyond."""
        found = []
        for series, beyond in zip(self._series(one.D), rest):
            # Below epsilon^N the coefficients vanish identically; their balls are left out.
            late = sum((series[n] * self.strength**n for n in range(self.order, self._length)), arb(0))
            found.append(abs(late) + beyond)
        return found[0], found[1]

    def _series(self, D: arb) -> tuple[arb_series, arb_series]:
        """f_A and f_phi in powers of epsilon through J; those below N are 0 by construction."""
        length, w = self._length, self.w
        with ctx.workcap(length):
            r, slope = (arb_series(values, length) for values in _both(self.amplitude, D))
            _, turn = (arb_series(values, length) for values in _both(self.phase, D))
            log_r = r.log()

            def force(rates: Degrees) -> arb_series:
                """sum_k c_k (epsilon D)^(k-1) r^(k w)."""
                total = arb_series([0], length)
                for k, c in rates.items():
                    shifted = arb_series([0] * (k - 1) + [c * D ** (k - 1)], length)
                    total = total + shifted * (log_r * (k * w)).exp()
                return total

            return force(self.p) - self.p[1] * (1 + w * slope / r), -(w * self.p[1] * turn) - force(self.Omega)

    def _rest(self, D: arb) -> tuple[arb, arb]:
        """What f_A and f_phi have beyond epsilon^J, D being at most this: M x^(J+1)/(1 - x), x = epsilon/rho."""
        # The largest radius tried on which |r - 1| <= 1/2: there ln r and the real powers of r are analytic in epsilon.
        rho = next((rho for rho in self._radii(D) if self._swing(rho, D) <= arb(1) / 2), arb(0))
        if not self.strength < rho:
            raise LimitError("law", "the explicit form is not bounded at this strength", "weaker damping")
        q, x, w = self._swing(rho, D), self.strength / rho, abs(self.w)
        slope, turn = (_absolute(rows, rho, D, sloped=True) for rows in (self.amplitude, self.phase))
        # |r^(k w)| <= (1 + q)^(k w) for w > 0, and (1 - q)^(-k |w|) for w < 0.
        base = 1 + q if self.fades else 1 / (1 - q)
        p, Omega = (
            sum((abs(c) * (rho * D) ** (k - 1) * base ** (k * w) for k, c in rates.items()), arb(0))
            for rates in (self.p, self.Omega)
        )
        share = x**self._length / (1 - x)
        return (p + self.p[1] * (1 + w * slope / (1 - q))) * share, (w * self.p[1] * turn + Omega) * share

    def _swing(self, rho: arb, D: arb) -> arb:
        """|r - 1| <= this for complex |epsilon| <= rho."""
        return _absolute(self.amplitude, rho, D) - 1

    def _radii(self, D: arb) -> Iterator[arb]:
        # Down to 4 (4/5)^59 = 10^-5 over D, in steps of a fifth; a finer list would find a radius up to a fifth larger.
        return (arb(4) / D * (arb(4) / 5) ** j for j in range(_TRIES))

    @property
    def _length(self) -> int:
        return self.order + NEXT

    @cached_property
    def _limit(self) -> arb:
        limit = largest_strength(self.waves, fades=self.fades)
        return arb(limit.numerator) / limit.denominator

    def _pieces(self, last: arb) -> list[_Piece]:
        """[``last``, 1], equal parts of u down to 0 and of ln u else."""
        parts = [arb(k) / _PIECES for k in range(_PIECES + 1)]
        # Where A_0 may fall by powers of ten, equal parts of ln u keep D narrow on each piece.
        cuts = parts if last.is_zero() else [last ** (1 - k) for k in parts]
        found = []
        for low, high in zip(cuts, cuts[1:]):
            D = self._slow(low).union(self._slow(high))
            r = sum((c * self.strength**n for n, c in enumerate(_both(self.amplitude, D)[0])), arb(0))
            found.append(_Piece(high - low, high, D, r, self.strength * D * r**self.w))
        return found

    def _slow(self, u: arb) -> arb:
        """D at A_0 = u."""
        return u if u.is_zero() else u**self.w

    def _last(self, until: arb | None) -> arb:
        """A_0 at the end: at the time ``until``, 0 for ever, or for alpha < 1 where delta may leave the range."""
        if until is not None:
            grown = 1 + self.w * self.p[1] * self.strength * until
            if not grown > 0:
                raise LimitError("until", "A_0 has vanished before", "an earlier time")
            # A_0 at the end, rounded down: a longer way has a larger integral.
            return arb((grown ** (-1 / self.w)).lower())
        if self.fades:
            return arb(0)
        # D grows for alpha < 1: the largest D, three per cent apart, at which the theorem seems to hold.
        farthest = (self._limit / self.strength * (arb(97) / 100) ** j for j in range(1, _TRIES))
        D = next((D for D in farthest if D > 1 and self._holds(D)), arb(1))
        return arb((D ** (1 / self.w)).mid())

    def _holds(self, D: arb) -> bool:
        """Whether the theorem seems to reach so far: no claim, ``bound`` decides."""
        r = sum((c * self.strength**n for n, c in enumerate(_both(self.amplitude, D)[0])), arb(0))
        near = any(self._swing(rho, D) <= arb(1) / 2 for rho in self._radii(D) if rho > 2 * self.strength)
        return bool(r > arb(1) / 2) and bool(self.strength * D * r**self.w <= self._limit) and near

    def _time(self, u: arb) -> arb | None:
        """The time at which A_0 = u."""
        if u.is_zero():
            return None
        return (1 / self._slow(u) - 1) / (self.w * self.p[1] * self.strength)


def _rows(series: Series, order: int) -> Rows:
    """The coefficients of epsilon^n D^j, n < N."""
    lifted = [TauPolynomial.lift(series.coefficients.get((n,), 0)) for n in range(order)]
    return [[arb(c) for c in row.coefficients] for row in lifted]


def _both(rows: Rows, D: arb) -> tuple[list[arb], list[arb]]:
    """Each coefficient of epsilon^n, and D times its derivative, at D."""
    values = [sum((c * D**j for j, c in enumerate(row)), arb(0)) for row in rows]
    return values, [sum((j * c * D**j for j, c in enumerate(row)), arb(0)) for row in rows]


def _absolute(rows: Rows, rho: arb, D: arb, *, sloped: bool = False) -> arb:
    """sum_(n, j) |c_nj| rho^n D^j, or j |c_nj|."""
    return sum(
        ((j if sloped else 1) * abs(c) * rho**n * D**j for n, row in enumerate(rows) for j, c in enumerate(row)), arb(0)
    )
