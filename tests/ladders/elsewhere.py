"""What returns balls and has its ladder in a test of its own."""

from tests.ladders.register import Names, each

ELSEWHERE: Names = {
    **each(
        "driven.first_order",
        "amplitude damping peak phase quality resistance",
        "tests/driven/test_response.py::test_every_rung_holds_what_is_above_it",
    ),
    **each(
        "driven.orbit",
        "Orbit.amplitude Orbit.harmonic Orbit.state orbit",
        "tests/driven/test_response.py::test_every_rung_holds_what_is_above_it",
    ),
    **each(
        "driven.linear",
        "coefficient exact",
        "tests/driven/test_response.py::test_the_orbit_in_balls_is_the_closed_form_of_viscous_damping",
    ),
    **each(
        "driven.expansion",
        "Arc.harmonic Arc.state piece",
        "tests/driven/test_response.py::test_the_defect_of_every_piece_is_bounded",
    ),
    **each("driven.trial", "march trial", "tests/driven/test_response.py::test_the_defect_of_every_piece_is_bounded"),
    **each(
        "driven.turn", "turn", "tests/driven/test_turn.py::test_the_factor_of_a_period_is_no_less_than_that_of_its_map"
    ),
    **each(
        "driven.contraction",
        "factor",
        "tests/driven/test_response.py::test_the_contraction_is_no_less_than_the_true_one",
    ),
    **each(
        "return_map.sequence", "Interpolated.leap following", "tests/return_map/test_panels.py::test_a_ladder_of_panels"
    ),
    **each(
        "curves.waves",
        "Waveforms.balls Waveforms.enclosed",
        "tests/expansions/multiple_scales/test_certified_waves.py::test_more_digits_are_narrower_and_overlap",
    ),
    **each(
        "expansions.half_swings.certified_displacement",
        "DisplacementSeries.slopes displacement_series",
        "test_few_terms_are_enclosed_by_many",
    ),
    **each(
        "expansions.multiple_scales.certified_waves",
        "waves_at wave_source",
        "test_more_digits_are_narrower_and_overlap",
    ),
    **each(
        "expansions.multiple_scales.ring",
        "Wave.at",
        "tests/expansions/multiple_scales/test_certified_waves.py"
        "::test_the_balls_hold_the_polynomials_of_integer_exponents",
    ),
    **each(
        "equivalent.conservative_cycle",
        "ConservativeCycle.of ConservativeCycle.zeta ConservativeCycle.quality ConservativeCycle.decrement "
        "ConservativeCycle.coefficient ConservativeCycle.period",
        "test_every_rung_of_an_orbit_holds_what_is_above_it",
    ),
    **each(
        "equivalent.conservative_cycle",
        "Spring.of Spring.potential Spring.force Spring.stiffness",
        "test_the_spring_of_an_orbit_is_its_potential",
    ),
    **each(
        "equivalent.rows",
        "cycle_of",
        "tests/equivalent/test_conservative_cycle.py::test_every_rung_of_an_orbit_holds_what_is_above_it",
    ),
    **each(
        "equivalent.cycle",
        "full_swing FullSwing.zeta_log FullSwing.quality",
        "test_the_certified_swing_is_that_of_an_integrator",
    ),
    **each(
        "bounds.flow",
        "TruncatedFlow.of TruncatedFlow.time TruncatedFlow.phase TruncatedFlow.turning_point",
        "tests/bounds/test_late.py::test_the_truncated_equations_are_enclosed_at_every_precision",
    ),
    **each("bounds.late", "late_state", "test_the_jump_holds_the_motion_and_is_not_wide"),
    **each("bounds.late", "late_turning", "test_the_turning_point_after_the_jump_is_held_and_its_errors_are_attained"),
    **each("bounds.motion", "enclosure", "test_the_bound_covers_the_distance_and_hardly_more"),
    **each("numbers.digits", "ball_of", "test_a_decimal_is_every_number_that_rounds_to_it"),
    **each(
        "numbers.value", "Coefficient.ball", "tests/numbers/test_digits.py::test_the_ball_of_digits_reaches_its_ends"
    ),
    **each("numbers.root", "verified_root", "test_the_root_may_stand_at_the_end_of_the_ball"),
    **each(
        "numbers.integral",
        "integral",
        "tests/bounds/test_flow.py::test_an_integral_that_runs_out_of_evaluations_is_wide_not_wrong",
    ),
    **each("motions.reference", "reference_states", "test_a_ladder_of_digits"),
    **each("return_map.chebyshev", "interpolant Interpolant.__call__", "test_rounded_coefficients_are_paid_for"),
    **each(
        "flow.linear_spring.linear_spring",
        "Creep.own",
        "tests/flow/slow_manifold/test_slow_curve.py::test_a_ladder_of_precisions",
    ),
    **each("return_map.half_swings", "HalfSwings.__call__ HalfSwings.up_to", "test_half_swings_contain_the_pieces"),
    **each(
        "return_map.half_swings", "HalfSwings.between", "test_half_swings_over_a_stretch_of_ln_a_contain_the_pieces"
    ),
    **each(
        "return_map.quarters",
        "NodeGrid.of NodeGrid.rates NodeGrid.slowness Path.along Path.errors Path.enclosed quarter_swings",
        "test_a_ladder_of_closed_forms",
    ),
    **each("return_map.hand_overs", "Bundle.of", "tests/return_map/test_quarters.py::test_a_ladder_of_closed_forms"),
    **each(
        "return_map.hand_overs", "Bundle.together", "tests/return_map/test_courses.py::test_states_contain_the_pieces"
    ),
    **each(
        "return_map.half_swings",
        "HalfSwings.mirrored Quarters.of",
        "tests/return_map/test_courses.py::test_half_swings_from_the_ends_of_courses_are_those_of_a_map_of_their_own",
    ),
    **each(
        "return_map.courses",
        "Along.of Along.at QuarterCourse.ln_r QuarterCourse.time QuarterCourse.near Courses.up_to Courses.quarter",
        "test_states_contain_the_pieces",
    ),
    **each(
        "return_map.course",
        "Course.of Course.states",
        "tests/return_map/test_courses.py::test_states_contain_the_pieces",
    ),
    **each("return_map.spectral", "analysis integrals of_the_integral", "test_the_matrices_of_integration"),
    **each(
        "flow.linear_spring.linear_spring",
        "ToSlowCurve.own",
        "tests/flow/slow_manifold/test_attraction.py::test_a_ladder_of_precisions",
    ),
    **each(
        "flow.slow_manifold.attraction", "ForceCurve.place ForceCurve.clock attracted", "test_a_ladder_of_precisions"
    ),
    **each(
        "flow.slow_manifold.near_equal_exponents",
        "StretchCurve.of StretchCurve.place StretchCurve.clock Scale.slope Grouped.slope Grouped.value grouped stretch",
        "test_a_ladder_of_precisions",
    ),
    **each("return_map.panels", "Panel.half_swing laid_out", "test_a_ladder_of_panels"),
    **each(
        "return_map.panels",
        "Panels.place",
        "test_half_swings_of_a_map_contain_the_pieces_of_every_law_of_its_ray",
    ),
    **each(
        "return_map.coordinate",
        "Coordinate.unit",
        "tests/return_map/test_ray.py::test_the_strengths_at_the_place_of_an_amplitude_are_those_of_the_law",
    ),  # fmt: skip
    **each(
        "flow.slow_manifold.slow_curve",
        "SlowCurve.a SlowCurve.place SlowCurve.clock FencedStrip.state solve caught",
        "test_a_ladder_of_precisions",
    ),
    **each(
        "turning.abel",
        "AbelFunction.advance AbelFunction.time_between Approximant.__call__ Approximant.slope abel_function "
        "from_series of_coefficients",
        "test_a_ladder_of_jumps_lands_where_the_steps_do",
    ),
    **each(
        "turning.abel_flow",
        "AbelFlow.advance AbelFlow.weights abel_flow",
        "test_a_ladder_of_jumps_lands_where_the_steps_do",
    ),
    **each("turning.quadratic_abel", "quadratic_abel", "test_a_jump_lands_where_the_steps_do"),
}
"""Function -> the test that is its ladder."""
