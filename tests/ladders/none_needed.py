"""What returns balls and needs no ladder, each with the reason."""

from tests.ladders.register import Names, each

EXACT = "arithmetic of balls and nothing else: no truncation, no choice"
CHOICE = "a choice that claims nothing"
MIDPOINTS = "midpoints of the asymptotic motion, which is not certified"
TRIED = "midpoints that claim nothing: the checker of certificates, in integers, finds out how good they are"

NONE_NEEDED: Names = {
    **each("expansions.multiple_scales.certified_waves", "half_turns", EXACT),
    **each("bounds.local", "Remainder.largest_term LocalBounds.limit", CHOICE),
    **each("bounds.local", "Remainder.known", EXACT),
    **each("envelopes.slow_flow", "ExponentialSum.of Rate.terms SlowLaw.solve", MIDPOINTS),
    **each("expansions.half_swings.odd_abel", "odd_solution", EXACT),
    **each("expansions.half_swings.certified_moments", "divide", EXACT),
    **each("expansions.half_swings.certified_orders", "dot integrate_series", EXACT),
    **each(
        "decays.identification.certified_sets.certified_ratio",
        "CertifiedRatio.areas CertifiedRatio.gradient",
        EXACT,
    ),
    **each(
        "decays.identification.certified_sets.certified_ratio",
        "followed",
        "ln of return_map.half_swing_map.integrated, which has a ladder, at 53 bits",
    ),
    **each("decays.identification.certified_sets.table_rows", "RatioInequality.local exact rows_of", EXACT),
    **each("motions.doubles", "Doubles.of", MIDPOINTS),
    **each(
        "motions.truncation",
        "Truncation.of Truncation.terms Truncation.monomial Truncation.start Truncation.turning_point Truncation.reach",
        MIDPOINTS,
    ),
    **each("motions.truncation", "Truncation.neglected Truncation.state State.turning_point State.point", MIDPOINTS),
    **each("motions.stopping", "friction_arc", MIDPOINTS),
    **each("motions.waveform", "waveform_at", MIDPOINTS),
    **each("flow.linear_spring.turning_point", "reach_at", CHOICE),
    **each("flow.damping", "Damping.of_law", "Damping.of for a law"),
    **each("flow.balls", "dyadic", CHOICE),
    **each("flow.balls", "upper", "rounds up, by arb.upper"),
    **each("expansions.divergence.result", "pole_of action_of", EXACT),
    **each(
        "limit_cycles.force",
        "PolynomialForce.of PolynomialForce.restoring_powers PolynomialForce.loss_powers PolynomialForce.largest "
        "PolynomialForce.at PolynomialForce.slopes PolynomialForce.bends",
        EXACT,
    ),
    **each("certificates.series", "PowerSeries.at from_rest in_motion", TRIED),
    **each("certificates.layout", "landing", TRIED),
    **each("certificates.known", "known_before known_turning_points", TRIED),
    **each("flow.times", "NearRest.reach NearRest.state NearRest.acceleration NearRest.moved", "abstract"),
    **each(
        "flow.force",
        "Smooth.rate Smooth.restoring_powers Smooth.loss_powers Smooth.largest HasSlopes.slopes",
        "abstract",
    ),
    **each("flow.force", "Force.viscous Force.least_power Force.restoring Force.drag Force.strongest", "abstract"),
    **each("flow.damping", "Damping.restoring_powers Damping.loss_powers", EXACT),
    **each("flow.times", "exact_sum later", "exact by its precision"),
    **each("return_map.half_swings", "Quarters.place", EXACT),
    **each("driven.drive", "Balls.in_units Drive.balls Drive.balls_at_resonance", EXACT),
    **each("driven.expansion", "grid", EXACT),
    **each("driven.trial", "grids", EXACT),
    **each("return_map.quarters", "found moved", CHOICE),
    **each("flow.slow_manifold.attraction", "ForceCurve.sums spread", EXACT),
    **each("flow.slow_manifold.near_equal_exponents", "Scale.t Grouped.exponent", EXACT),
    **each("flow.slow_manifold.slow_curve", "Barrier.place Barrier.clock", "abstract"),
    **each("return_map.panels", "Panels.half_swing", "hands out what laid_out made"),
    **each("return_map.panels", "Panels.course", "Course.of, which is registered, from two quarters"),
    **each("return_map.course", "TimedQuarter.near TimedQuarter.time", "abstract"),
    **each(
        "return_map.sequence",
        "OnCourse.own OnCourse.all_at Interpolated.read_off",
        "Course.states, which is registered",
    ),
    **each("flow.trajectory", "CertifiedFlow.read_off", "abstract"),
    **each("flow.dense", "KnownPiece.all_at", "abstract"),
    **each("return_map.sequence", "Interpolated.arrive", "TurningExpansion.at, which is registered"),
    **each("flow.trajectory", "after", "midpoints, and their radii as errors"),
    **each("return_map.half_swings", "HalfSwings.half_swing", "HalfSwings.__call__, which is registered"),
    **each("return_map.panels", "Readable.half_swing", "abstract"),
    **each("return_map.ray", "Ray.terms", EXACT),
    **each(
        "turning.jump",
        "jumped jumped_by_flow",
        "the jumps of abel and abel_flow, which have ladders, in Turnings",
    ),
    **each("bounds.remainder", "remainder", "local_bounds and displacement_bound, both registered, side by side"),
    **each("turning.jump", "head_end", CHOICE),
    **each("turning.abel", "polydiscs", "finite_majorant.majorant, which is registered, at some shares"),
    **each("turning.abel", "least_beyond", CHOICE),
    **each("turning.energy_primitive", "swings", "PrimitiveWell.work, which has a ladder, half-swing by half-swing"),
    **each("turning.enclosing", "damping_of first_of", "Damping.of and flow.sequence.first_from for a request"),
    **each("turning.table", "size", EXACT),
    **each(
        "flow.composition",
        "ExponentGrid.product ExponentGrid.product_from_1 ExponentLine.product ExponentLine.product_from_1 "
        "ComposedSeries.restoring",
        EXACT,
    ),
    **each("flow.composition", "Simplex.product Simplex.product_from_1", EXACT),
    **each(
        "flow.trajectory",
        "Piece.own LocalExpansion.speed CertifiedFlow.shift CertifiedFlow.unit CertifiedFlow.along_slow_curve "
        "CertifiedFlow.leap CertifiedFlow.closed",
        "abstract",
    ),
    **each("flow.trajectory", "CertifiedFlow.place CertifiedFlow.back", "a sum with the place of rest"),
    **each("flow.wells.even_well", "EvenWell.unit unit_for", CHOICE),
    **each("flow.wells.force", "WellForce.slopes", "WellForce.slope, and 0"),
    **each("flow.linear_spring.linear_spring", "LinearSpring.shift LinearSpring.unit", EXACT),
    **each(
        "flow.linear_spring.linear_spring",
        "LinearSpring.closed LinearSpring.along_slow_curve",
        "pieces, whose own orbits have ladders",
    ),
    **each("flow.wells.even_well", "EvenWell.of", "Force.of for a law"),
    **each("flow.damping", "Damping.slopes Damping.least_power", EXACT),
    **each("flow.wells.expansion", "reach_at", CHOICE),
    **each("flow.wells.expansion", "WellExpansion.gathered", "itself"),
    **each("flow.secant", "secant", CHOICE),
    **each("flow.wells.turning_point", "without_loss", CHOICE),
    **each("flow.taylor", "sizes", EXACT),
    **each("flow.growing_product", "GrowingProduct.last", EXACT),
}
"""Function -> the reason."""
