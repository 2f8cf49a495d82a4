"""Higher orders of one law: the differential equations hold through the order, in each ring and gauge."""

import math
from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq

from asymptotics.envelopes.laurent import envelope_of_series, laurent_envelope
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.certified_zeros import certified_half_swing
from asymptotics.expansions.half_swings.grading import may_vanish
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.expansions.normal_form.flow import flow_of
from asymptotics.expansions.normal_form.symbolic import symbolic_expansion
from asymptotics.numbers.exact import parse_real
from asymptotics.series import Series, divided
from tests.second_route.forced import quadratic_turning_points

CASES = [(0, 6), (2, 6), (3, 7), (4, 4), (5, 6)]


def derivative(series):
    return Series({(n - 1,): c * n for (n,), c in series.coefficients.items() if n}, 1, series.order - 1)


def zero(series):
    return all(may_vanish(c) for c in series.coefficients.values())


def residuals(envelope, p, Omega):
    """(alpha-1) times: dtau/ddelta . delta p + 1, and dphi/ddelta . delta p + Omega, as series."""
    q, r = envelope.q, envelope.r
    ratio = Series({(n - 1,): c for (n,), c in p.coefficients.items()}, 1, p.order - 1)  # p/delta
    time = ratio * q / envelope.p_1 - 1
    defect = Omega - ratio.extend(Omega.order) * r / envelope.p_1
    return time, defect.truncate(p.order - 1)


@pytest.mark.parametrize(("alpha", "order"), CASES)
def test_exact_laws(alpha, order):
    expansion = exact_expansion((alpha,), order)
    envelope = laurent_envelope(expansion)
    time, phase = residuals(envelope, expansion.p, expansion.Omega)
    assert zero(time)
    assert zero(phase)
    if expansion.p[3] != 0:  # near miss: a wrong q_2 is seen (alpha = 0 has none)
        wrong = envelope.q + Series({(2,): fmpq(1, 10**9)}, 1, envelope.q.order)
        assert not zero(expansion_ratio(expansion) * wrong / envelope.p_1 - 1)
    # the reversal: sigma G(delta(sigma)) = 1, multiplied by delta
    delta = envelope.reversal
    K = envelope.q.without_constant().map_keys(lambda n, c: divided(-c, n[0] - 1)) + 1  # delta G(delta)
    defect = K.extend(delta.order).compose((delta,)).shift(0).truncate(delta.order) - delta
    assert zero(defect)


def expansion_ratio(expansion):
    p = expansion.p
    return Series({(n - 1,): c for (n,), c in p.coefficients.items()}, 1, p.order - 1)


def test_dry_friction_has_no_corrections():
    envelope = laurent_envelope(exact_expansion((0,), 8))  # p = (2/pi) delta, Omega = 0 exactly
    assert list(envelope.q.coefficients) == [(0,)]
    assert not envelope.r.coefficients
    assert list(envelope.reversal.coefficients) == [(1,)]


@pytest.mark.parametrize("gauge", ["turning-point", "averaging", "no-first-harmonic"])
def test_time_and_phase_against_quadrature_in_every_gauge(gauge):
    expansion = exact_expansion((3,), 7, gauge)
    envelope = laurent_envelope(expansion).certified()
    numbers = [{n: float(c.ball().mid()) for (n,), c in f.coefficients.items()} for f in (expansion.p, expansion.Omega)]

    def p(d):
        return sum(c * d**n for n, c in numbers[0].items())

    def Omega(d):
        return sum(c * d**n for n, c in numbers[1].items())

    start, end = 0.05, 0.02
    # quadrature of the truncated laws differs from the truncated series by one order more: relative (0.05)^8
    tau = mpmath.quad(lambda d: 1 / (2 * d * p(d)), [end, start])
    phi = mpmath.quad(lambda d: Omega(d) / (2 * d * p(d)), [end, start])
    assert abs(float(envelope.time(arb(end), arb(start)).mid()) - tau) < 1e-8 * tau
    assert abs(float(envelope.phase(arb(end), arb(start)).mid()) - phi) < 1e-7 * abs(phi)
    first_order = (1 / end - 1 / start) / (2 * 3 / 8)
    assert abs(first_order - tau) > 1e-5 * tau  # near miss: the higher orders are seen


def test_symbolic_agrees_with_exact_at_integers():
    source = symbolic_expansion()
    p, Omega = (Series({(n,): c for n, c in source[name].items()}, 1, 4) for name in ("p", "Omega"))
    symbolic = envelope_of_series(next(iter(source["p"][1].free_symbols)), p, Omega)
    for n in (2, 3, 4):
        exact = laurent_envelope(exact_expansion((n,), 4))
        for name, k in (("q", 2), ("r", 2), ("reversal", 3)):
            ours, theirs = (getattr(e, name)[k] for e in (symbolic, exact))
            assert (ours.subs(symbolic.alpha, n) - theirs.to_sympy()).equals(0)


def test_certified_ring_and_the_explicit_amplitude():
    alpha = parse_real("3/2", "alpha")
    flow = flow_of(certified_half_swing([alpha], 6))
    envelope = envelope_of_series(alpha.ball(), flow.p, flow.Omega)
    time, phase = residuals(envelope, flow.p, flow.Omega)
    assert zero(time)
    assert zero(phase)
    numeric = envelope.numeric()
    # explicit against implicit: the defect falls like delta^6 relative (order 6: p_5, next p_7)
    defects = []
    for start in (0.4, 0.2):
        tau = 2 / start
        delta = numeric.delta(tau, start)
        defects.append(abs(numeric.time(delta, start) - tau) / tau)
    assert 2**5.5 < defects[0] / defects[1] < 2**6.5
    assert defects[1] < 1e-7


def test_extinction_below_one():
    flow = flow_of(certified_half_swing([parse_real("1/2", "alpha")], 4))
    envelope = envelope_of_series(arb(1) / 2, flow.p, flow.Omega).numeric()
    first = 1 / (0.5 * envelope.p_1 * 0.05)
    assert abs(envelope.extinction_time(0.05) / first - 1) < 0.05**2
    with pytest.raises(InputError, match="alpha"):
        laurent_envelope(exact_expansion((3,), 3)).extinction_time(fmpq(1, 10))


def test_refusals():
    with pytest.raises(InputError, match="delta is constant"):
        laurent_envelope(exact_expansion((1,), 3))
    with pytest.raises(InputError, match="law"):
        laurent_envelope(exact_expansion((1, 2), 3))


def test_latex():
    assert r"\tau" in laurent_envelope(exact_expansion((2,), 3))._repr_latex_()
    flow = flow_of(certified_half_swing([parse_real("3/2", "alpha")], 4))
    assert r"\varphi" in envelope_of_series(arb(3) / 2, flow.p, flow.Omega)._repr_latex_()


def test_against_the_certified_turning_points_of_the_quadratic_law():
    """Observable: A and tau at turning points, where phi = n pi - tau exactly; orders 1, 3, 5 against Lambert W."""
    errors = {}
    for epsilon in ("1/20", "1/40"):
        e = float(Fraction(epsilon))
        points = quadratic_turning_points(parse_real(epsilon, "epsilon"), 1, 25, start=20, times=True).points
        A, tau = abs(float(points[0].x)), float(points[0].tau)
        for order in (1, 3, 5):
            envelope = laurent_envelope(exact_expansion((2,), order + 1)).numeric()
            time = abs(envelope.time(e * A, e) - tau)
            phase = abs(envelope.phase(e * A, e) - (20 * math.pi - tau))
            explicit = abs(envelope.delta(tau, e) / e - A)
            errors[epsilon, order] = (time, phase, explicit)
    for order in (1, 3, 5):
        halved = [math.log2(a / b) for a, b in zip(errors["1/20", order], errors["1/40", order])]
        # p_N, Omega_(N+1) kept: tau misses the change of delta^N along the way, which is eps^(N+1) n for n eps << 1
        # and eps^N for n eps >> 1; phi that of delta^(N+2); A misses A delta times the error of tau.
        for exponent, low, high in zip(halved, (0, 2, -1), (1, 3, 2)):
            assert order + low - 0.1 < exponent < order + high + 0.1
    assert errors["1/40", 5][0] < 1e-9
    assert errors["1/40", 5][1] < 1e-12
    assert errors["1/40", 5][2] < 1e-11
