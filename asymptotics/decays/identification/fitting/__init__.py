"""The fit of one law: starting values, least squares on turning points or on the waveform, profiles, correlation."""
