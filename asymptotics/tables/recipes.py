"""The list of the tables: what each is, by which route, checked by which other one, and what it costs."""

from asymptotics.tables.bounds import error_bounds
from asymptotics.tables.coefficients import half_swing, normal_form
from asymptotics.tables.driven import resonances
from asymptotics.tables.moments import moments, squaring_ratios
from asymptotics.tables.quadratic import smith_c, smith_f, smith_table_1, transit_time
from asymptotics.tables.recipe import Recipe
from asymptotics.tables.slow import extinction_times, lancaster_table_1, phase_lags, two_law_times
from asymptotics.tables.stokes import constants
from asymptotics.tables.turning import half_periods, stops, turning

RECIPES = {
    "moments": Recipe(
        "The averages M_p = <|sin|^p> that the first orders need",
        ("alpha", "M_(alpha+1)", "M_(2 alpha)", "M_(3 alpha+1)"), ("alpha",), ("1",) * 4,
        "quotient of Gamma functions in balls; rational values exactly",
        "the integral of |sin|^p by the double exponential rule",
        "milliseconds", moments, "alpha",
    ),
    "normal-form": Recipe(
        "Coefficients p_k and Omega_k of the amplitude and phase equations, turning-point gauge",
        ("alpha", "coefficient", "value", "exact"), ("alpha", "coefficient"), ("1", "", "1", ""),
        "power series of the half-swing and its flow: exact for integer exponents, else in balls with proved tails",
        "the half-swing by integrals over theta, the flow by its exponential; at each order, for sums too",
        "a second for order 4; --rows is the order", normal_form, "alpha law rows",
    ),
    "half-swing": Recipe(
        "Coefficients of the half-swing: log ratio L, map F, duration T and the flow U, V, W",
        ("alpha", "coefficient", "value", "exact"), ("alpha", "coefficient"), ("1", "", "1", ""),
        "the quarter-swing as a power series and the reversal identity: exact or in balls with proved tails",
        "the half-swing by integrals over theta, the flow by its exponential; at each order, for sums too",
        "a second for order 4; --rows is the order", half_swing, "alpha law rows",
    ),
    "error-bounds": Recipe(
        "Error bounds of the expansion of order N on a half-swing: |L - L_N| <= C_L d^m_L, |T - T_N| <= C_T d^m_T",
        ("alpha", "order", "delta_max", "C_L", "m_L", "C_T", "m_T"), ("alpha", "order"), ("1",) * 7,
        "the next coefficients in balls and Cauchy's inequality beyond; constants rounded up, two digits",
        "the equations of each order integrated, against the half-swing by integrals over theta",
        "seconds; --rows is the highest order", error_bounds, "alpha rows",
    ),
    "turning-points": Recipe(
        "Turning points x_n (units of x0) and times tau_n = omega_0 t",
        ("law", "n", "x", "tau", "certified", "ended"), ("law", "n"), ("1", "1", "1", "1", "", ""),
        "half-swing after half-swing from rest at X = 1; the column certified says which rows are proved",
        "each half-swing by integrals over theta; its end by an integrator of another library",
        "seconds; --rows is the number of points of each law", turning, "alpha law epsilon rows",
    ),
    "half-periods": Recipe(
        "The first half-swing from amplitude 1: ratio of amplitudes |x_1|, and its duration T (delta = epsilon)",
        ("law", "ratio", "T", "certified", "ended"), ("law",), ("1", "1", "1", "", ""),
        "one half-swing from rest; the column certified says which rows are proved",
        "integrals over theta; an end by an integrator of another library",
        "seconds", half_periods, "alpha law epsilon",
    ),
    "stops": Recipe(
        "Dry friction: the turning point at which the mass sticks, where and when",
        ("epsilon", "N", "x_N", "tau_N"), ("epsilon",), ("1", "1", "1", "1"),
        "closed form: x_n = (-1)^n (1 - 2 n epsilon), tau_n = n pi, decided exactly",
        "half-swing by half-swing in rationals",
        "milliseconds", stops, "epsilon",
    ),
    "extinction-times": Recipe(
        "The end of the averaged law for alpha < 1 (fictitious: the mass creeps or sticks instead)",
        ("alpha", "epsilon", "tau_e"), ("alpha", "epsilon"), ("1", "1", "1"),
        "closed form 1/((1-alpha) M_(alpha+1) epsilon) in balls",
        "quadrature of dA/(kappa A^alpha) by another library, kappa by quadrature too",
        "milliseconds", extinction_times, "alpha epsilon",
    ),
    "phase-lags": Recipe(
        "The phase lost for ever, -phi(infinity), for alpha > 1, to second order in epsilon",
        ("alpha", "epsilon", "lag"), ("alpha", "epsilon"), ("1", "1", "1"),
        "closed form (alpha/(alpha+1))^2 M_(2 alpha) epsilon/((alpha-1) M_(alpha+1)) in balls",
        "integrals over theta; n pi - tau_n of certified turning points for weak quadratic damping",
        "milliseconds", phase_lags, "alpha epsilon",
    ),
    "two-law-times": Recipe(
        "When the averaged amplitude of two laws has fallen to A, by 2F1 (Lancaster 2020, footnote 22)",
        ("law", "A", "tau"), ("law", "A"), ("1", "1", "1"),
        "2F1(1, a; a+1; z) by logarithms for rational a, else by Arb, in balls",
        "quadrature of dA/(kappa A^alpha + kappa' A^alpha') by another library",
        "milliseconds", two_law_times, "law epsilon",
    ),
    "resonance": Recipe(
        "The driven response to first order at omega_0 (force 1, m = k = 1), Q of the decay and of the width",
        ("law", "amplitude", "Q_decay", "Q_width"), ("law",), ("1",) * 4,
        "the root A of sum 2 epsilon M_(alpha+1) A^alpha = 1, proved in balls; Q = A, and A/sqrt(2 - 2 R(A/sqrt 2)^2)",
        "the root by bisection in doubles, its moments by quadrature",
        "milliseconds", resonances, "alpha law epsilon",
    ),
    "lelas-ratios": Recipe(
        "Lelas' squaring trick: its damping over the averaged one, 2^(-(alpha+1)/2)/M_(alpha+1)",
        ("alpha", "ratio"), ("alpha",), ("1", "1"),
        "quotient of Gamma functions in balls; rational values exactly",
        "the integral of |sin|^(alpha+1) by the double exponential rule",
        "milliseconds", squaring_ratios, "alpha",
    ),
    "stokes.constants": Recipe(
        "Why the series diverge: pole c, action 2 pi |c|, Stokes constants c_1 (amplitude) and d_1 (time) of one law",
        ("alpha", "pole", "action", "c_1", "d_1"), ("alpha",), ("1",) * 5,
        "Abel functions of the half-swing at one height of the z-plane, in balls; alpha = 0 by theorem",
        "another height, with another germ; the pole by quadrature",
        "seconds; longer near alpha = 1, which is refused", constants, "alpha",
    ),
    "lancaster2020.table1": Recipe(
        "Lancaster 2020, Table I: the first-order amplitude, and (13) for any alpha",
        ("alpha", "A"), ("alpha",), ("1", "m"),
        "exact: the averaged law dA/dtau = -M_(alpha+1) epsilon A^alpha solved in closed form and put into SI units",
        "the averaged law put back, by differentiation, its moment by quadrature",
        "a second", lancaster_table_1, "alpha",
    ),
    "smith2012.table1": Recipe(
        "Smith 2012, Table I: the constants S_n and the turning points u_n",
        ("u_0", "half_cycle", "S_hat", "u"), ("u_0", "half_cycle"), ("1", "1", "1", "1"),
        "turning-point equation (43) by the Lambert W map in ball arithmetic; S_n = S - S^-(|u_n|) by (47)",
        "the Lambert W function of another library; the printed table",
        "milliseconds; --epsilon is u_0, --rows the length", smith_table_1, "epsilon rows",
    ),
    "smith2012.transit-time": Recipe(
        "Transit time between turning points, omega T / pi = sum of c_i u^i",
        ("i", "c_i"), ("i",), ("1", "1"),
        "exact: c_i = H_i(pi)/pi from the closed forms of Smith's sums",
        "the series of the level integral",
        "a second", transit_time, "rows",
    ),
    "smith2012.c": Recipe(
        "Smith 2012, (62): the coefficients C_i^n",
        ("n", "i", "C", "value"), ("n", "i"), ("1", "1", "1", "1"),
        "exact: the recurrence in integers without a division",
        "the polynomials by integration; a closed sum",
        "milliseconds; --rows is the last n", smith_c, "rows",
    ),
    "smith2012.f": Recipe(
        "Smith 2012, (60): the polynomials f_n(w)",
        ("n", "f"), ("n",), ("1", "1"),
        "exact: the recurrence in integers without a division",
        "the polynomials by integration",
        "milliseconds; --rows is the last n", smith_f, "rows",
    ),
}  # fmt: skip
