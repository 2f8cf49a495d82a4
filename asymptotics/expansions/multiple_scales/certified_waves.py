"""X_k(psi) of the turning-point gauge at any phase as proved balls, for any exponents, and a(0), psi(0) of any start.

The amplitude a at the phase psi stands on the orbit that began at psi = 0 with a e^lambda and has taken the time psi +
beta; both are finite sums along the flow U = d ln a/d psi, W = d tau/d psi of the half-swing (``normal_form.flow``),

    lambda = int_0^(-psi) U,      psi + beta = -int_0^(-psi) W,

so that with X_n(tau) of that orbit at a fixed time (``half_swings.certified_displacement``), weights w_n and X_0 = cos,

    X(a, psi)/a = sum_n delta^n e^((1 + w_n) lambda) sum_j (beta/psi)^j [psi^j X_n^(j)(psi)]/j!.

Beyond pi/2 reversal does it, x_k(pi - psi) = -(-1)^l(k) x_k(psi), and X(psi + pi) = -X(psi).  No integral is made by
quadrature, no hierarchy is used: a route of its own to the named integrals of ``open_orders``.

>>> from asymptotics.expansions.half_swings.forces import Forces
>>> with ctx.workprec(80):
...     found = waves_at(wave_source(Forces.losses((2,)), 2, 80), arb(1))
>>> found[1,].str(12), found[2,].str(12)
('[0.299752077311 +/- ...]', '[-0.000568482964091 +/- ...]')
"""

from dataclasses import dataclass
from math import factorial

from flint import arb

from asymptotics.expansions.half_swings.certified_arc import arc
from asymptotics.expansions.half_swings.certified_displacement import DisplacementSeries, displacement_series
from asymptotics.expansions.half_swings.certified_zeros import certified_half_swing
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.normal_form.flow import Flow, flow_of
from asymptotics.numbers.context import ctx
from asymptotics.series import Key, Series

Waves = dict[Key, arb]
# With eight bits an order beside it, for the derivatives along the flow: a choice, of which the radii tell the rest.
_GUARD = 40


@dataclass(frozen=True, eq=False)
class WaveSource:
    """What all phases share: the forces, their flow with the derivatives D^j U, D^j W along it, the orbits in time."""

    forces: Forces
    flow: Flow
    U: tuple[Series, ...]
    W: tuple[Series, ...]
    displacement: DisplacementSeries
    bits: int

    @property
    def order(self) -> int:
        """The order through which all is known."""
        return self.flow.order


def wave_source(forces: Forces, order: int, bits: int) -> WaveSource:
    """Flow and displacement of the forces, with some bits more than asked: high orders lose some."""
    with ctx.workprec(bits + _GUARD + 8 * order):
        flow = flow_of(certified_half_swing(forces, order))
        U, W = ([f] for f in (flow.U, flow.W))
        for _ in range(order):
            # D raises the degree, so that as many derivatives as orders are all there are.
            U.append(flow.derivative(U[-1]))
            W.append(flow.derivative(W[-1]))
        return WaveSource(forces, flow, tuple(U), tuple(W), displacement_series(forces, order, bits), ctx.prec)


def waves_at(source: WaveSource, psi: arb) -> Waves:
    """x_k(psi) for 1 <= |k| <= order, X = a (cos psi + sum delta^k x_k); any psi, at the precision of the source."""
    with ctx.workprec(source.bits):
        side, chi = half_turns(psi)
        late, losses = bool(chi.mid() > (arb.pi() / 2).mid()), source.flow.grading.loss_degree
        found = _on_quarter(source, arb.pi() - chi if late else chi)
        # Reversal: x_k(pi - psi) = -(-1)^l(k) x_k(psi).
        return {k: x * side * (-((-1) ** losses(k)) if late else 1) for k, x in found.items()}


def half_turns(psi: arb) -> tuple[int, arb]:
    """(side, chi): psi less the half-turns below it, X(psi) = side X(chi)."""
    # The midpoint chooses the half-turn; psi - turns pi keeps the radius.
    turns = int(str((psi / arb.pi()).mid().floor().unique_fmpz()))
    return (-1) ** (turns % 2), psi - turns * arb.pi()


def _on_quarter(source: WaveSource, psi: arb) -> Waves:
    """The same for 0 <= psi <= pi/2."""
    order, variables, grading = source.order, source.flow.U.variables, source.flow.grading
    zero: Key = (0,) * variables
    # The turning point itself: x_k = 0 there by the gauge, and 1/psi below would be infinite.
    if psi.is_zero():
        return dict.fromkeys(source.displacement.series, psi)
    lam, beta = _along(source.U, -psi), -_along(source.W, -psi) - psi
    # beta has no constant term, so that its j-th power begins with degree j and the Taylor polynomial in time ends.
    turn, powers = beta.without_constant() * (1 / psi), [Series.constant(arb(1), variables, order)]
    while len(powers) <= order and powers[-1].coefficients:
        powers.append(powers[-1] * turn)
    total = Series({}, variables, order)
    for n in [zero, *source.displacement.series]:
        left = order - sum(n)
        # A wave of order n needs the shift in time through the orders that are left.
        near = [p for p in (p.truncate(left) for p in powers) if p.coefficients]
        slopes = _cosines(psi, len(near)) if n == zero else source.displacement.slopes(n, psi, len(near))
        moved = sum((p * (s / factorial(j)) for j, (p, s) in enumerate(zip(near, slopes))), Series({}, variables, left))
        grown = moved * (lam.truncate(left) * (1 + grading.weight(n))).exp()
        total = total + Series({_plus(n, k): c for k, c in grown.coefficients.items()}, variables, order)
    return {k: arb(c) for k, c in total.coefficients.items() if any(k)}


def _along(derivatives: tuple[Series, ...], psi: arb | Series) -> Series:
    """int_0^psi f along the flow: sum_j psi^(j+1)/(j+1)! D^j f."""
    total, power = Series({}, derivatives[0].variables, derivatives[0].order), psi
    for j, f in enumerate(derivatives):
        total = total + f * power
        power = power * psi * (arb(1) / (j + 2))
    return total


def _cosines(psi: arb, count: int) -> list[arb]:
    """The functions psi^j cos^(j)(psi), from which a Taylor polynomial in psi is made."""
    return [(psi + j * arb.pi() / 2).cos() * psi**j for j in range(count)]


def _plus(n: Key, k: Key) -> Key:
    return tuple(i + j for i, j in zip(n, k))


def start_series(source: WaveSource, theta: arb) -> tuple[Series, Series]:
    """ln(a(0)/r) and psi(0) - theta in rho_i = epsilon_i r^(d_i-1): X = r cos theta, X' = -r sin theta, 0 < theta < pi.

    From its turning point, an amplitude a_0 before, the orbit has ln r = ln a_0 + R and time tau at theta
    (``half_swings.certified_arc``); psi solves int_0^psi W = tau, a = a_0 exp(int_0^psi U), and rho_i = delta_i
    e^(w_i R) is inverted.  Beyond pi/2 by reversal: the signs of the losses changed, pi - theta, pi - psi.
    """
    with ctx.workprec(source.bits):
        late, grading = bool(theta.mid() > (arb.pi() / 2).mid()), source.flow.grading
        angle = arb.pi() - theta if late else theta
        R, tau = arc(source.forces, source.order, angle)
        psi = tau
        for _ in range(source.order):
            # W = 1 + O(delta^2): each pass makes one order more right, and so does the next fixed point.
            psi = tau - (_along(source.W, psi) - psi)
        size, turn = _along(source.U, psi) - R, psi - angle
        back = -R
        for _ in range(source.order):
            back = (-R).compose(grading.strengths(back))
        images = grading.strengths(back)
        size, turn = (f.without_constant().compose(images) for f in (size, turn))
        # Reversal of time: the signs of the losses, pi - theta, pi - psi.
        return (grading.flip(size), -grading.flip(turn)) if late else (size, turn)
