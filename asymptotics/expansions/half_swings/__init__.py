"""One half-swing, from a turning point to the next, as power series in the local strengths delta_i.

===================  ======================================================================================
``forces``           which monomial of the strengths stands before which function of the phase: losses, springs
``grading``          weights and signs: all that the series know of the forces
``quarter``          the data of a quarter-swing, and the half-swing from it by the reversal identity
``exact``            integer exponents: rationals, and polynomials in pi
``certified``        any real exponents, and sums of laws: balls (``certified_orders``, ``certified_moments``)
``finite_majorant``  bounds of the half-swing on a polydisc of complex strengths, for Cauchy's inequality
``finite_result``    one half-swing at a given strength as a result object, correctly rounded
``symbolic``         one law with a symbolic exponent: moments and one named integral, through fourth order
``orbit``            the recurrence in delta shared by the exact routes
``fourier_flow``     polynomial forces: the flow and the waveform by rational Fourier polynomials, in each gauge
``theta_algebra``    polynomials in theta, sin(theta), cos(theta), closed under integration
``pi_ring``          exact numbers of Q[pi, 1/pi]
===================  ======================================================================================
"""
