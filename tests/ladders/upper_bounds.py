"""What returns an upper bound, not an enclosure, and the test of each."""

from tests.ladders.register import Names, each

BOUNDS: Names = {
    **each(
        "bounds.half_swing",
        "HalfSwingSeries.at half_swing_series",
        "test_the_motion_is_within_the_bound_and_not_within_half_of_it",
    ),
    **each("bounds.half_swing", "disc", "test_the_disc_is_where_the_motion_is_bounded"),
    **each(
        "bounds.local",
        "sizes_from",
        "tests/bounds/test_half_swing.py::test_the_motion_is_within_the_bound_and_not_within_half_of_it",
    ),
    **each("equivalent.cycle", "expanded_swing", "test_half_of_the_bound_would_be_wrong"),
    **each("numbers.extremes", "greatest least", "test_the_extremes_of_balls_hold_those_of_their_numbers"),
    **each("flow.slow_manifold.slow_curve", "short_enough", "test_the_rest_is_what_the_cut_leaves"),
    **each("flow.slow_manifold.near_equal_exponents", "residual", "test_what_is_left_is_the_residual_of_the_curve"),
    **each("flow.slow_manifold.near_equal_exponents", "Grouped.size", "test_what_is_cut_off_the_sums_is_bounded"),
    **each("flow.slow_manifold.strong_damping", "strong_damping_strip", "test_the_strip_holds_every_state_that_enters"),
    **each(
        "expansions.divergence.germ",
        "germ majorants",
        "tests/expansions/divergence/test_petal.py::test_the_numbers_of_a_petal_are_those_of_its_definition",
    ),
    **each(
        "expansions.divergence.petal",
        "petal quadratic_bound Petal.tail",
        "test_the_numbers_of_a_petal_are_those_of_its_definition",
    ),
    **each("expansions.divergence.half_step", "half_step at", "test_a_half_swing_at_complex_strength_holds_smiths_map"),
    **each(
        "expansions.divergence.half_step", "tail share", "test_the_tail_of_cauchy_is_its_formula_and_ends_at_the_circle"
    ),
    **each("expansions.divergence.abel", "odd_series at at_height later", "test_what_an_orbit_leaves_out_is_bounded"),
    **each("expansions.half_swings.nodes", "node_quarter", "test_the_balls_hold_those_of_the_sums"),
    **each("expansions.divergence.constants", "stokes_balls rough_petal", "test_another_height_gives_the_same_numbers"),
    **each(
        "bounds.local",
        "Remainder.constant Remainder.__call__ local_bounds",
        "test_the_bounds_hold_and_half_of_them_would_not",
    ),
    **each(
        "expansions.half_swings.symbolic", "cauchy_bounds", "test_the_bounds_of_cauchy_on_the_circle_hold_and_are_near"
    ),
    **each("bounds.local", "Remainder.beyond", "test_what_lies_beyond_is_a_geometric_series"),
    **each("bounds.local", "flow_majorant", "test_the_majorant_of_the_equations_is_above_them_and_not_far_above"),
    **each(
        "bounds.turning",
        "TurningBounds.log_amplitude TurningBounds.time TurningBounds.phase turning_bounds",
        "test_the_theorem_holds_for_every_n_and_its_half_would_not",
    ),
    **each("bounds.turning", "sensitivity", "test_durations_change_with_delta_as_fast_as_B_says"),
    **each("bounds.turning", "largest", "test_the_phase_runs_as_fast_as_Omega_says"),
    **each("bounds.turning", "rates", "tests/bounds/test_uniform.py::test_the_rates_are_attained_or_not_far_off"),
    **each("bounds.uniform", "displacement_bound", "test_the_constant_for_all_strengths_is_the_bound_at_its_largest"),
    **each("bounds.waveform", "waveform_bounds", "test_what_is_left_over_is_bounded_and_nearly_attained"),
    **each(
        "bounds.flow",
        "TruncatedFlow.beyond",
        "tests/bounds/test_uniform.py::test_what_is_reached_later_is_hardly_later",
    ),
    **each("bounds.turning_sequence", "turning_sequence_bounds", "test_the_bounds_hold_and_half_of_them_would_not"),
    **each(
        "expansions.half_swings.finite_majorant",
        "Majorant.final Majorant.inverse Majorant.ratio majorant widest",
        "test_the_majorant_is_above_the_function_and_not_far_above",
    ),
    **each(
        "decays.identification.certified_sets.certified_ratio",
        "CertifiedRatio.tail",
        "test_L_is_bounded_on_the_circle_of_the_tail",
    ),
    **each("flow.taylor", "TaylorStep.residual discs", "test_the_residual_of_a_step"),
    **each("flow.taylor", "TaylorStep.box", "test_the_box_of_a_step_holds_it"),
    **each("flow.damping", "Damping.largest", "tests/flow/test_taylor.py::test_the_residual_of_a_step"),
    **each(
        "return_map.quarter_majorant",
        "quarter_majorant",
        "test_quarter_swings_at_complex_strengths_obey_the_bounds_and_not_half_of_them",
    ),
    **each("return_map.chebyshev", "cut", "test_the_cut_is_attained_by_the_first_polynomial_left_out"),
    **each("return_map.coordinate", "Coordinate.bounds", "tests/return_map/test_panels.py::test_a_ladder_of_panels"),
    **each(
        "flow.damping",
        "Damping.strongest",
        "tests/flow/linear_spring/test_linear_spring_errors.py::test_what_is_uncertain_at_a_time_is_a_distance",
    ),
    **each("flow.linear_spring.expansion", "TurningExpansion.speed", "test_a_wide_time_near_a_turning_point"),
    **each("flow.linear_spring.expansion", "room", "test_half_of_the_drop_or_of_the_delay_would_be_wrong"),
    **each("flow.linear_spring.majorant", "majorant", "test_the_majorant_is_attained_without_damping"),
    **each(
        "return_map.panel_plan",
        "Ellipse.ratio_bound verified",
        "tests/return_map/test_panels.py::test_a_ladder_of_panels",
    ),
    **each("return_map.quarters", "Path.on_ellipse", "test_the_bounds_on_the_ellipse"),
    **each("return_map.quarters", "Path.drags", "test_the_drags_are_those_on_the_orbit"),
    **each("return_map.hand_overs", "largest", "tests/return_map/test_quarters.py::test_largest_is_an_upper_bound"),
    **each("return_map.quarters", "peak", "test_the_peak_is_attained"),
    **each(
        "turning.abel",
        "AbelFunction.defects AbelFunction.power_sum",
        "test_half_the_defect_or_one_coefficient_less_would_be_wrong",
    ),
    **each(
        "turning.abel_flow",
        "AbelFlow.defects DefectBound.total",
        "test_half_of_the_next_term_or_one_term_less_would_be_wrong",
    ),
    **each(
        "flow.trajectory",
        "ArrivalPiece.gap ArrivalPiece.late Piece.error",
        "test_a_landing_holds_the_orbits_of_both_ends",
    ),
    **each("flow.error_propagation", "growth distance_growth", "test_growth_is_attained_in_the_worst_direction"),
    **each(
        "flow.error_propagation", "turning_gap turning_delay", "test_the_gap_and_the_lateness_are_attained_by_free_fall"
    ),
    **each("flow.error_propagation", "state_gap", "test_the_gap_of_a_state_counts_place_and_speed"),
    **each(
        "flow.error_propagation",
        "contraction_by_energy",
        "tests/flow/test_error_propagation_contraction.py::test_turning_points_draw_together_at_most_as_the_bound_says",
    ),
    **each("flow.turning", "at_exact_place", "test_a_place_that_is_known_lies_in_its_enclosure"),
    **each(
        "flow.error_propagation",
        "ratio_growth",
        "tests/flow/test_error_propagation_ratios.py::test_ratios_part_no_faster_than_is_said",
    ),
    **each(
        "flow.error_propagation",
        "contraction_by_ratio",
        "tests/return_map/test_sequence.py::test_amplitudes_carry_their_error_by_contraction",
    ),
    **each(
        "flow.error_propagation",
        "CarriedErrors.plus CarriedErrors.times CarriedErrors.apart",
        "tests/flow/test_trajectory.py::test_the_parts_of_a_landing",
    ),
    **each("flow.sequence", "given_at", "test_turning_points_hold_those_of_every_start"),
    **each("flow.wells.force", "WellForce.strongest", "tests/flow/test_dense.py::test_an_uncertain_time_moves_a_state"),
    **each("flow.wells.expansion", "WellExpansion.rate WellExpansion.speed", "test_the_rate_next_to_a_turning_point"),
    **each("flow.wells.force", "WellForce.slope", "test_every_slope_is_in_the_ball_and_hardly_more"),
    **each("flow.wells.force", "WellForce.largest_change", "test_the_change_of_the_force_is_attained"),
    **each("flow.wells.force", "WellForce.largest", "test_the_largest_force_on_two_discs_is_attained"),
}
"""Upper bounds, not enclosures -> the test in which half of them fails or that evaluates them again."""
