"""Motion: x(t) and v(t) in SI units, for any law, any start, at a chosen order or to any number of digits."""
