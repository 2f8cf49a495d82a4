"""What returns balls and has its ladder elsewhere, or needs none, by name and with the reason."""

Names = dict[str, str]

LOCAL, TURNING, ORBIT = (
    "tests/bounds/test_local.py",
    "tests/bounds/test_turning.py",
    "tests/bounds/test_turning_sequence.py",
)
PETAL = "tests/expansions/divergence/test_bounds.py"
HEIGHTS = "tests/expansions/divergence/test_constants.py::test_another_height_gives_the_same_numbers"
ONE_LAW = "tests/expansions/half_swings/test_nodes.py"
LATE, FINITE, SLOW = (
    "tests/bounds/test_late.py",
    "tests/expansions/half_swings/test_finite_majorant.py",
    "tests/flow/slow_manifold/test_slow_curve.py",
)
UNIFORM, AT_LARGEST = (
    "tests/bounds/test_uniform.py",
    "test_the_constant_for_all_strengths_is_the_bound_at_its_largest",
)
NEAR = "tests/flow/slow_manifold/test_near_equal_exponents.py"
SETTLING, STEP = "tests/flow/slow_manifold/test_attraction.py", "tests/flow/test_taylor.py"
KEPT, DISTANCE = "tests/flow/linear_spring/test_linear_spring_errors.py", "tests/flow/wells/test_distance_bounds.py"
NEXT = "tests/flow/wells/test_force.py"
SWING, WELLS, PANELS = (
    "tests/flow/linear_spring/test_bounds.py",
    "tests/flow/wells/test_bounds.py",
    "tests/return_map/test_panels.py",
)
CHEBYSHEV, ABEL, FLOW = (
    "tests/return_map/test_chebyshev.py",
    "tests/turning/test_abel.py",
    "tests/turning/test_abel_flow.py",
)
QUARTERS = "tests/return_map/test_quarters.py"
RATIO, QUADRATIC = "tests/identification/certified_sets/test_certified_ratio.py", "tests/turning/test_quadratic_abel.py"

EXACT = "arithmetic of balls and nothing else: no truncation, no choice"
CHOICE = "a choice that claims nothing"
WAVES = "tests/expansions/multiple_scales/test_certified_waves.py"
COURSE = "tests/expansions/half_swings/test_certified_displacement.py"
MIDPOINTS = "midpoints of the asymptotic motion, which is not certified"


def _each(room: str, names: str, told: str) -> Names:
    return {f"asymptotics.{room}.{name}": told for name in names.split()}


EQUIVALENT = "tests/equivalent/test_conservative_cycle.py::test_every_rung_of_an_orbit_holds_what_is_above_it"
FULL_SWING = "tests/equivalent/test_cycle.py"
CUT = "tests/bounds/test_half_swing.py"

BOUNDS: Names = {
    **_each(
        "bounds.half_swing",
        "HalfSwingSeries.at half_swing_series",
        f"{CUT}::test_the_motion_is_within_the_bound_and_not_within_half_of_it",
    ),
    **_each("bounds.half_swing", "disc", f"{CUT}::test_the_disc_is_where_the_motion_is_bounded"),
    **_each("bounds.local", "sizes_from", f"{CUT}::test_the_motion_is_within_the_bound_and_not_within_half_of_it"),
    **_each("equivalent.cycle", "expanded_swing", f"{FULL_SWING}::test_half_of_the_bound_would_be_wrong"),
    **_each(
        "numbers.extremes",
        "greatest least",
        "tests/test_chosen_in_doubles.py::test_the_extremes_of_balls_hold_those_of_their_numbers",
    ),
    **_each("flow.slow_manifold.slow_curve", "short_enough", f"{SLOW}::test_the_rest_is_what_the_cut_leaves"),
    **_each(
        "flow.slow_manifold.near_equal_exponents", "residual", f"{NEAR}::test_what_is_left_is_the_residual_of_the_curve"
    ),
    **_each(
        "flow.slow_manifold.near_equal_exponents", "Grouped.size", f"{NEAR}::test_what_is_cut_off_the_sums_is_bounded"
    ),
    **_each(
        "flow.slow_manifold.strong_damping",
        "strong_damping_strip",
        "tests/flow/slow_manifold/test_strong_damping.py::test_the_strip_holds_every_state_that_enters",
    ),
    **_each(
        "expansions.divergence.germ",
        "germ majorants",
        f"{PETAL}::test_the_numbers_of_a_petal_are_those_of_its_definition",
    ),
    **_each(
        "expansions.divergence.petal",
        "petal quadratic_bound Petal.tail",
        f"{PETAL}::test_the_numbers_of_a_petal_are_those_of_its_definition",
    ),
    **_each(
        "expansions.divergence.half_step",
        "half_step at",
        f"{PETAL}::test_a_half_swing_at_complex_strength_holds_smiths_map",
    ),
    **_each(
        "expansions.divergence.half_step",
        "tail share",
        f"{PETAL}::test_the_tail_of_cauchy_is_its_formula_and_ends_at_the_circle",
    ),
    **_each(
        "expansions.divergence.abel",
        "odd_series at at_height later",
        f"{PETAL}::test_what_an_orbit_leaves_out_is_bounded",
    ),
    **_each("expansions.half_swings.nodes", "node_quarter", f"{ONE_LAW}::test_the_balls_hold_those_of_the_sums"),
    **_each("expansions.divergence.constants", "stokes_balls rough_petal", HEIGHTS),
    **_each(
        "bounds.local",
        "Remainder.constant Remainder.__call__ local_bounds",
        f"{LOCAL}::test_the_bounds_hold_and_half_of_them_would_not",
    ),
    **_each(
        "expansions.half_swings.symbolic",
        "cauchy_bounds",
        "tests/expansions/half_swings/test_symbolic.py::test_the_bounds_of_cauchy_on_the_circle_hold_and_are_near",
    ),
    **_each("bounds.local", "Remainder.beyond", f"{LOCAL}::test_what_lies_beyond_is_a_geometric_series"),
    **_each(
        "bounds.local", "flow_majorant", f"{LOCAL}::test_the_majorant_of_the_equations_is_above_them_and_not_far_above"
    ),
    **_each(
        "bounds.turning",
        "TurningBounds.log_amplitude TurningBounds.time TurningBounds.phase turning_bounds",
        f"{TURNING}::test_the_theorem_holds_for_every_n_and_its_half_would_not",
    ),
    **_each(
        "bounds.turning",
        "sensitivity",
        "tests/bounds/test_constants.py::test_durations_change_with_delta_as_fast_as_B_says",
    ),
    **_each("bounds.turning", "largest", "tests/bounds/test_constants.py::test_the_phase_runs_as_fast_as_Omega_says"),
    **_each("bounds.turning", "rates", f"{UNIFORM}::test_the_rates_are_attained_or_not_far_off"),
    **_each("bounds.uniform", "displacement_bound", f"{UNIFORM}::{AT_LARGEST}"),
    **_each(
        "bounds.waveform",
        "waveform_bounds",
        "tests/bounds/test_waveform.py::test_what_is_left_over_is_bounded_and_nearly_attained",
    ),
    **_each("bounds.flow", "TruncatedFlow.beyond", f"{UNIFORM}::test_what_is_reached_later_is_hardly_later"),
    **_each(
        "bounds.turning_sequence",
        "turning_sequence_bounds",
        f"{ORBIT}::test_the_bounds_hold_and_half_of_them_would_not",
    ),
    **_each(
        "expansions.half_swings.finite_majorant",
        "Majorant.final Majorant.inverse Majorant.ratio majorant widest",
        f"{FINITE}::test_the_majorant_is_above_the_function_and_not_far_above",
    ),
    **_each(
        "identification.certified_sets.certified_ratio",
        "CertifiedRatio.tail",
        f"{RATIO}::test_L_is_bounded_on_the_circle_of_the_tail",
    ),
    **_each("flow.taylor", "TaylorStep.residual discs", f"{STEP}::test_the_residual_of_a_step"),
    **_each("flow.taylor", "TaylorStep.box", f"{STEP}::test_the_box_of_a_step_holds_it"),
    **_each("flow.damping", "Damping.largest", f"{STEP}::test_the_residual_of_a_step"),
    **_each("return_map.chebyshev", "cut", f"{CHEBYSHEV}::test_the_cut_is_attained_by_the_first_polynomial_left_out"),
    **_each("return_map.coordinate", "Coordinate.bounds", f"{PANELS}::test_a_ladder_of_panels"),
    **_each("flow.damping", "Damping.strongest", f"{KEPT}::test_what_is_uncertain_at_a_time_is_a_distance"),
    **_each(
        "flow.linear_spring.expansion", "TurningExpansion.speed", f"{SWING}::test_a_wide_time_near_a_turning_point"
    ),
    **_each(
        "flow.linear_spring.expansion",
        "room",
        "tests/flow/linear_spring/test_expansion.py::test_half_of_the_drop_or_of_the_delay_would_be_wrong",
    ),
    **_each("flow.linear_spring.majorant", "majorant", f"{SWING}::test_the_majorant_is_attained_without_damping"),
    **_each("return_map.panel_plan", "Ellipse.ratio_bound verified", f"{PANELS}::test_a_ladder_of_panels"),
    **_each("return_map.quarters", "Path.on_ellipse", f"{QUARTERS}::test_the_bounds_on_the_ellipse"),
    **_each("return_map.quarters", "Path.drags", f"{QUARTERS}::test_the_drags_are_those_on_the_orbit"),
    **_each("return_map.quarters", "largest", f"{QUARTERS}::test_largest_is_an_upper_bound"),
    **_each("return_map.quarters", "peak", f"{QUARTERS}::test_the_peak_is_attained"),
    **_each(
        "turning.abel",
        "AbelFunction.defects AbelFunction.power_sum",
        f"{ABEL}::test_half_the_defect_or_one_coefficient_less_would_be_wrong",
    ),
    **_each(
        "turning.abel_flow",
        "AbelFlow.defects DefectBound.total",
        f"{FLOW}::test_half_of_the_next_term_or_one_term_less_would_be_wrong",
    ),
    **_each(
        "flow.trajectory",
        "ArrivalPiece.gap ArrivalPiece.late Piece.error",
        "tests/flow/wells/test_distance_bounds.py::test_a_landing_holds_the_orbits_of_both_ends",
    ),
    **_each(
        "flow.error_propagation", "growth distance_growth", f"{WELLS}::test_growth_is_attained_in_the_worst_direction"
    ),
    **_each(
        "flow.error_propagation",
        "turning_gap turning_delay",
        f"{WELLS}::test_the_gap_and_the_lateness_are_attained_by_free_fall",
    ),
    **_each(
        "flow.error_propagation",
        "state_gap",
        "tests/flow/wells/test_distance_bounds.py::test_the_gap_of_a_state_counts_place_and_speed",
    ),
    **_each(
        "flow.error_propagation",
        "contraction_by_energy",
        f"{WELLS}::test_turning_points_draw_together_at_most_as_the_bound_says",
    ),
    **_each(
        "flow.turning",
        "at_exact_place",
        "tests/numbers/test_exact_ties.py::test_a_place_that_is_known_lies_in_its_enclosure",
    ),
    **_each(
        "flow.error_propagation",
        "ratio_growth",
        "tests/flow/test_error_propagation_ratios.py::test_ratios_part_no_faster_than_is_said",
    ),
    **_each(
        "flow.error_propagation", "contraction_by_ratio", f"{SWING}::test_amplitudes_carry_their_error_by_contraction"
    ),
    **_each(
        "flow.error_propagation",
        "CarriedErrors.plus CarriedErrors.times CarriedErrors.apart",
        "tests/flow/wells/test_distance_bounds.py::test_the_parts_of_a_landing",
    ),
    **_each("flow.sequence", "given_at", f"{DISTANCE}::test_turning_points_hold_those_of_every_start"),
    **_each("flow.wells.force", "WellForce.strongest", f"{DISTANCE}::test_an_uncertain_time_moves_a_state"),
    **_each(
        "flow.wells.expansion",
        "WellExpansion.rate WellExpansion.speed",
        f"{NEXT}::test_the_rate_next_to_a_turning_point",
    ),
    **_each("flow.wells.force", "WellForce.slope", f"{NEXT}::test_every_slope_is_in_the_ball_and_hardly_more"),
    **_each("flow.wells.force", "WellForce.largest_change", f"{NEXT}::test_the_change_of_the_force_is_attained"),
    **_each("flow.wells.force", "WellForce.largest", f"{NEXT}::test_the_largest_force_on_two_discs_is_attained"),
}
"""Upper bounds, not enclosures -> the test in which half of them fails or that evaluates them again."""

ELSEWHERE: Names = {
    **_each("return_map.sequence", "Interpolated.leap following", f"{PANELS}::test_a_ladder_of_panels"),
    **_each("api.waves", "Waveforms.balls Waveforms.enclosed", f"{WAVES}::test_more_digits_are_narrower_and_overlap"),
    **_each(
        "expansions.half_swings.certified_displacement",
        "DisplacementSeries.slopes",
        f"{COURSE}::test_few_terms_are_enclosed_by_many",
    ),
    **_each(
        "expansions.half_swings.certified_displacement",
        "displacement_series",
        f"{COURSE}::test_few_terms_are_enclosed_by_many",
    ),
    **_each(
        "expansions.multiple_scales.certified_waves",
        "waves_at wave_source",
        f"{WAVES}::test_more_digits_are_narrower_and_overlap",
    ),
    **_each(
        "expansions.multiple_scales.ring",
        "Wave.at",
        f"{WAVES}::test_the_balls_hold_the_polynomials_of_integer_exponents",
    ),
    **_each(
        "equivalent.conservative_cycle",
        "ConservativeCycle.of ConservativeCycle.zeta ConservativeCycle.quality ConservativeCycle.decrement "
        "ConservativeCycle.coefficient",
        EQUIVALENT,
    ),
    **_each(
        "equivalent.conservative_cycle",
        "Spring.of Spring.potential Spring.force Spring.stiffness",
        "tests/equivalent/test_conservative_cycle.py::test_the_spring_of_an_orbit_is_its_potential",
    ),
    **_each("equivalent.rows", "cycle_of", EQUIVALENT),
    **_each(
        "equivalent.cycle",
        "full_swing FullSwing.zeta FullSwing.quality",
        f"{FULL_SWING}::test_the_certified_swing_is_that_of_an_integrator",
    ),
    **_each(
        "bounds.flow",
        "TruncatedFlow.of TruncatedFlow.time TruncatedFlow.phase TruncatedFlow.turning_point",
        f"{LATE}::test_the_truncated_equations_are_enclosed_at_every_precision",
    ),
    **_each("bounds.late", "late_state", f"{LATE}::test_the_jump_holds_the_motion_and_is_not_wide"),
    **_each(
        "bounds.late",
        "late_turning",
        f"{LATE}::test_the_turning_point_after_the_jump_is_held_and_its_errors_are_attained",
    ),
    **_each(
        "bounds.motion", "enclosure", "tests/bounds/test_motion.py::test_the_bound_covers_the_distance_and_hardly_more"
    ),
    **_each(
        "numbers.digits",
        "ball_of",
        "tests/comparison/test_si_start.py::test_a_decimal_is_every_number_that_rounds_to_it",
    ),
    **_each(
        "numbers.value", "Coefficient.ball", "tests/numbers/test_digits.py::test_the_ball_of_digits_reaches_its_ends"
    ),
    **_each(
        "numbers.root", "verified_root", "tests/numbers/test_root.py::test_the_root_may_stand_at_the_end_of_the_ball"
    ),
    **_each(
        "numbers.integral",
        "integral",
        "tests/bounds/test_flow.py::test_an_integral_that_runs_out_of_evaluations_is_wide_not_wrong",
    ),
    **_each("motions.reference", "reference_states", "tests/motions/test_reference.py::test_a_ladder_of_digits"),
    **_each(
        "return_map.chebyshev",
        "interpolant Interpolant.__call__",
        f"{CHEBYSHEV}::test_rounded_coefficients_are_paid_for",
    ),
    **_each("flow.linear_spring.linear_spring", "Creep.own", f"{SLOW}::test_a_ladder_of_precisions"),
    **_each(
        "return_map.half_swings",
        "HalfSwings.__call__ HalfSwings.up_to",
        f"{QUARTERS}::test_half_swings_contain_the_pieces",
    ),
    **_each(
        "return_map.half_swings",
        "HalfSwings.between",
        f"{QUARTERS}::test_half_swings_over_a_stretch_of_ln_a_contain_the_pieces",
    ),
    **_each(
        "return_map.quarters",
        "Bundle.of NodeGrid.of NodeGrid.rates NodeGrid.slowness Path.along Path.enclosed quarter_swings",
        f"{QUARTERS}::test_a_ladder_of_closed_forms",
    ),
    **_each(
        "return_map.spectral", "analysis integrals of_the_integral", f"{QUARTERS}::test_the_matrices_of_integration"
    ),
    **_each("flow.linear_spring.linear_spring", "ToSlowCurve.own", f"{SETTLING}::test_a_ladder_of_precisions"),
    **_each(
        "flow.slow_manifold.attraction",
        "ForceCurve.place ForceCurve.clock attracted",
        f"{SETTLING}::test_a_ladder_of_precisions",
    ),
    **_each(
        "flow.slow_manifold.near_equal_exponents",
        "StretchCurve.of StretchCurve.place StretchCurve.clock Scale.slope Grouped.slope Grouped.value grouped stretch",
        f"{NEAR}::test_a_ladder_of_precisions",
    ),
    **_each("return_map.panels", "Panel.passage laid_out", f"{PANELS}::test_a_ladder_of_panels"),
    **_each(
        "flow.slow_manifold.slow_curve",
        "SlowCurve.a SlowCurve.place SlowCurve.clock FencedStrip.state solve caught",
        f"{SLOW}::test_a_ladder_of_precisions",
    ),
    **_each(
        "turning.abel",
        "AbelFunction.advance AbelFunction.time_between Approximant.__call__ Approximant.slope",
        f"{ABEL}::test_a_ladder_of_jumps_lands_where_the_steps_do",
    ),
    **_each(
        "turning.abel",
        "abel_function from_series of_coefficients",
        f"{ABEL}::test_a_ladder_of_jumps_lands_where_the_steps_do",
    ),
    **_each(
        "turning.abel_flow",
        "AbelFlow.advance AbelFlow.weights abel_flow",
        f"{FLOW}::test_a_ladder_of_jumps_lands_where_the_steps_do",
    ),
    **_each("turning.quadratic_abel", "quadratic_abel", f"{QUADRATIC}::test_a_jump_lands_where_the_steps_do"),
}
"""Function -> the test that is its ladder."""

NONE_NEEDED: Names = {
    **_each("expansions.multiple_scales.certified_waves", "half_turns", EXACT),
    **_each("bounds.local", "Remainder.largest_term LocalBounds.limit", CHOICE),
    **_each("bounds.local", "Remainder.known", EXACT),
    **_each("envelopes.slow_flow", "ExponentialSum.of Rate.terms SlowLaw.solve", MIDPOINTS),
    **_each("expansions.half_swings.odd_abel", "odd_solution", EXACT),
    **_each("expansions.half_swings.certified_moments", "divide", EXACT),
    **_each("expansions.half_swings.certified_orders", "dot integrate_series", EXACT),
    **_each("identification.certified_sets.certified_ratio", "CertifiedRatio.areas CertifiedRatio.gradient", EXACT),
    **_each(
        "identification.certified_sets.certified_ratio",
        "followed",
        "ln of return_map.half_swing_map.integrated, which has a ladder, at 53 bits",
    ),
    **_each("identification.certified_sets.table_rows", "RatioInequality.local exact rows_of", EXACT),
    **_each("motions.doubles", "Doubles.of", MIDPOINTS),
    **_each(
        "motions.frame", "Frame.of Frame.terms Frame.monomial Frame.start Frame.turning_point Frame.reach", MIDPOINTS
    ),
    **_each("motions.frame", "Frame.neglected Frame.state State.turning_point State.point", MIDPOINTS),
    **_each("motions.stopping", "friction_arc", MIDPOINTS),
    **_each("motions.waveform", "waveform_at", MIDPOINTS),
    **_each("flow.linear_spring.turning_point", "reach_at", CHOICE),
    **_each("flow.damping", "Damping.of_law", "Damping.of for a law"),
    **_each("flow.balls", "dyadic", CHOICE),
    **_each("flow.balls", "upper", "rounds up, by arb.upper"),
    **_each("expansions.divergence.result", "pole_of action_of", EXACT),
    **_each(
        "limit_cycles.force",
        "PolynomialForce.of PolynomialForce.restoring_powers PolynomialForce.loss_powers PolynomialForce.largest "
        "PolynomialForce.at PolynomialForce.slopes PolynomialForce.bends",
        EXACT,
    ),
    **_each("flow.times", "NearRest.reach NearRest.state NearRest.acceleration NearRest.moved", "abstract"),
    **_each(
        "flow.force",
        "Smooth.rate Smooth.restoring_powers Smooth.loss_powers Smooth.largest HasSlopes.slopes",
        "abstract",
    ),
    **_each("flow.force", "Force.viscous Force.least_power Force.restoring Force.drag Force.strongest", "abstract"),
    **_each("flow.damping", "Damping.restoring_powers Damping.loss_powers", EXACT),
    **_each("flow.times", "exact_sum later", "exact by its precision"),
    **_each("return_map.half_swings", "Quarters.place", EXACT),
    **_each("return_map.quarters", "found moved", CHOICE),
    **_each("flow.slow_manifold.attraction", "ForceCurve.sums spread", EXACT),
    **_each("flow.slow_manifold.near_equal_exponents", "Scale.t Grouped.exponent", EXACT),
    **_each("flow.slow_manifold.slow_curve", "Barrier.place Barrier.clock", "abstract"),
    **_each("return_map.panels", "Panels.serving panels_of", "hands out what laid_out made"),
    **_each(
        "turning.jump",
        "jumped jumped_by_flow",
        "the jumps of abel and abel_flow, which have ladders, in Turnings",
    ),
    **_each("bounds.remainder", "remainder", "local_bounds and displacement_bound, both registered, side by side"),
    **_each("turning.jump", "head_end", CHOICE),
    **_each("turning.abel", "polydiscs", "finite_majorant.majorant, which is registered, at some shares"),
    **_each("turning.abel", "least_beyond", CHOICE),
    **_each("turning.energy_primitive", "swings", "PrimitiveWell.work, which has a ladder, half-swing by half-swing"),
    **_each("turning.enclosing", "damping_of first_of", "Damping.of and flow.sequence.first_from for a request"),
    **_each("turning.table", "size", EXACT),
    **_each(
        "flow.composition",
        "ExponentGrid.product ExponentGrid.product_from_1 ExponentLine.product ExponentLine.product_from_1 "
        "ComposedSeries.restoring",
        EXACT,
    ),
    **_each("flow.composition", "Simplex.product Simplex.product_from_1", EXACT),
    **_each(
        "flow.trajectory",
        "Piece.own LocalExpansion.speed CertifiedFlow.shift CertifiedFlow.unit CertifiedFlow.along_slow_curve "
        "CertifiedFlow.leap CertifiedFlow.closed",
        "abstract",
    ),
    **_each("flow.trajectory", "CertifiedFlow.place CertifiedFlow.back", "a sum with the place of rest"),
    **_each("flow.wells.even_well", "EvenWell.unit unit_for", CHOICE),
    **_each("flow.wells.force", "WellForce.slopes", "WellForce.slope, and 0"),
    **_each("flow.linear_spring.linear_spring", "LinearSpring.shift LinearSpring.unit", EXACT),
    **_each(
        "flow.linear_spring.linear_spring",
        "LinearSpring.closed LinearSpring.along_slow_curve",
        "pieces, whose own orbits have ladders",
    ),
    **_each("flow.wells.even_well", "EvenWell.of", "Force.of for a law"),
    **_each("flow.damping", "Damping.slopes Damping.least_power", EXACT),
    **_each("flow.wells.expansion", "reach_at", CHOICE),
    **_each("flow.secant", "secant", CHOICE),
    **_each("flow.wells.turning_point", "without_loss", CHOICE),
    **_each("flow.taylor", "sizes", EXACT),
}
