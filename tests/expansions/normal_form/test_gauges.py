import pytest
from flint import fmpq

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.exact import exact_quarter_swing
from asymptotics.expansions.half_swings.fourier_flow import fourier_flow
from asymptotics.expansions.half_swings.pi_ring import PI
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.expansions.normal_form.flow import flow_of
from asymptotics.expansions.normal_form.gauges import gauge_map
from asymptotics.gauges import AVERAGING, GAUGES, NO_FIRST_HARMONIC, TURNING_POINT
from tests.second_route.gauge_observables import observables

# x'^3: Omega_2 and p_3 in the three gauges (45/4096 from the closed form of p_3)
CUBIC = {
    TURNING_POINT: (fmpq(-45, 256), fmpq(45, 4096)),
    AVERAGING: (fmpq(-27, 256), fmpq(567, 8192)),
    NO_FIRST_HARMONIC: (fmpq(9, 256), fmpq(351, 8192)),
}


@pytest.mark.parametrize("gauge", GAUGES)
def test_cubic_damping(gauge):
    expansion = exact_expansion((3,), 3, gauge)
    assert (expansion.Omega[2], expansion.p[3]) == CUBIC[gauge]
    assert expansion.p[1] == fmpq(3, 8)


@pytest.mark.parametrize("gauge", GAUGES)
@pytest.mark.parametrize(("alphas", "order"), [((3,), 7), ((5,), 5), ((1,), 6), ((1, 3), 4)])
def test_waveform_moments_against_the_fourier_waveform(gauge, alphas, order):
    """The bracket from quarter-swing integrals, and the homological equation solved in each gauge: same flow."""
    quarter = exact_quarter_swing(alphas, order, moments=True)
    flow = flow_of(half_swing(quarter))
    converted, direct = gauge_map(flow, quarter.K, gauge).apply(flow), fourier_flow(alphas, order, gauge)
    assert (converted.U - direct.U).coefficients == {} and (converted.W - direct.W).coefficients == {}


@pytest.mark.parametrize("alpha", range(7))
def test_omega_2_of_both_gauges(alpha):
    # turning-point value plus (alpha-1)/(alpha+1) p_1^2 and (alpha-1)(alpha+3)/(2(alpha+1)) p_1^2
    base, averaging, harmonic = (exact_expansion((alpha,), 2, g) for g in GAUGES)
    p_squared = base.p[1] * base.p[1]
    assert averaging.Omega[2] - base.Omega[2] == p_squared * fmpq(alpha - 1, alpha + 1)
    assert harmonic.Omega[2] - base.Omega[2] == p_squared * fmpq((alpha - 1) * (alpha + 3), 2 * (alpha + 1))


@pytest.mark.parametrize("alphas", [(0,), (2,), (3,), (0, 1)])
@pytest.mark.parametrize("gauge", [AVERAGING, NO_FIRST_HARMONIC])
def test_maps_invert_and_compose(alphas, gauge):
    change = exact_expansion(alphas, 4, gauge).gauge_map
    there_and_back = change.then(change.inverse())
    assert there_and_back.log_modulus.coefficients == {} and there_and_back.argument.coefficients == {}
    assert change.log_modulus.coefficients != {}
    with pytest.raises(InputError):
        change.then(change)


@pytest.mark.parametrize("alphas", [(0,), (1,), (2,), (3,), (0, 1), (1, 2)])
def test_observables_do_not_depend_on_the_gauge(alphas):
    first, *others = (observables(exact_expansion(alphas, 4, g)) for g in GAUGES)
    for other in others:
        for name in ("amplitude_ratio", "half_period", "energy_loss", "log_decrement"):
            assert (getattr(first, name) - getattr(other, name)).coefficients == {}


@pytest.mark.parametrize("gauge", GAUGES)
def test_total_lag_of_cubic_damping_is_15_over_64(gauge):
    """T_n - n pi -> 15/64 eps: psi lag int Omega d tau plus the initial phase arg c, the same in every gauge.

    d delta/d tau = -2 p_1 delta^2, so psi - tau -> -w int delta^2 d tau + arg c(eps) = -w eps/(2 p_1) + chi_1 eps, w =
    -Omega_2; at the turning point number n -> infinity the gauge phase is n pi again, hence tau_n - n pi is minus that.
    """
    expansion = exact_expansion((3,), 2, gauge)
    chi = expansion.gauge_map.argument
    start = chi[1] if (1,) in chi.coefficients else fmpq(0)
    lag = -(expansion.Omega[2] / (expansion.p[1] * 2) + start)
    assert lag == fmpq(15, 64)


def test_unknown_gauge_and_missing_moments():
    quarter = exact_quarter_swing((2,), 3)
    flow = flow_of(half_swing(quarter))
    with pytest.raises(InputError):
        gauge_map(flow, quarter.K, "energy")
    with pytest.raises(ValueError, match="waveform moments"):
        gauge_map(flow, quarter.K, AVERAGING)


def test_quadratic_coulomb_values_keep_their_powers_of_pi():
    # alpha = 0: Omega_2 = -p_1^2 = -4/pi^2 in the averaging gauge
    assert exact_expansion((0,), 2, AVERAGING).Omega[2] == -4 / (PI * PI)
