"""Envelopes: A(tau), tau(A) and phi(tau), first order for every law, any order for one (theory page ``slow_flow``).

====================  ==================================================================================
``symbolic``          one law, first order, any exponent: Lancaster (13), Table I, phase, total lag; Lelas
``laurent``           one law, any order: tau as a Laurent polynomial in delta, and its reversal
``explicit``          several laws, first order: every family where A(tau) is elementary or Lambert's W
``hypergeometric``    two laws, first order: tau(A) by 2F1, printed and companion form, elementary form
``certified``         one or more laws, first order: tau(A), A(tau), extinction, phase as balls
``numeric``           the same for NumPy arrays: heuristic floats
``slow_flow``         any laws, any order: the truncated equations solved, in balls and for arrays (``motions``)
``large``             pendulum and Duffing, first order in the loss, exact in the spring: any amplitude inside the well
``first_order``       all of it for an oscillator in SI units
``validity``          where dA/dt << omega_0 A
====================  ==================================================================================
"""
