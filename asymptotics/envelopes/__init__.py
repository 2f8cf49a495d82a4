"""Envelopes: A(tau), tau(A) and phi(tau), first order for every law, any order for one (theory page ``slow_flow``)."""
