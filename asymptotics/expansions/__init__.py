"""What is formal and exact: power series in the local strengths, and the equations and solutions made of them.

====================  ============================================================================================
``moments``           the moments M_beta of |sin|^beta: closed forms and balls
``half_swings``       one half-swing as a power series in the local strengths (the formal return map)
``divergence``        why these series diverge: Stokes constants, large orders, the best truncation (resurgence)
``normal_form``       amplitude and phase equations from the half-swing (the formal flow), in any gauge
``straightening``     other springs: the coordinate in which their phase runs evenly (action-angle variables)
``equations``         amplitude and phase equations as a result object
``multiple_scales``   the method of multiple scales: waveforms, rates and solutions, order by order
====================  ============================================================================================

Equalities, no numbers with errors, except where a file says ``certified`` in its name or its first line.
"""
