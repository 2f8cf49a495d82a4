"""One half-swing, from a turning point to the next, as power series in the local strengths delta_i."""
