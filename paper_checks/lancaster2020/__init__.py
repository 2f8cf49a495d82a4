"""Lancaster 2020: slow-dissipation limit of the harmonic oscillator with general power-law damping."""
