"""Statements of K. Lelas, Decay of amplitude of a harmonic oscillator with weak nonlinear damping (2024)."""
