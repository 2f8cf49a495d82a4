"""Limit cycles of anti-damped laws: where losses and gains of energy balance (van der Pol, Rayleigh, ...)."""
