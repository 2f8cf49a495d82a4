"""Envelopes: A(tau), tau(A) and phi(tau), first order for every law, any order for one (theory page ``slow_flow``).

First order is the averaging of Krylov and Bogoliubov; any order is the normal form of ``expansions.normal_form``.
"""
