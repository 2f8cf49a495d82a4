"""Error bounds of the expansions that are theorems: constants and ranges, computed in balls and rounded up.

================  ====================================================================================
``local``         one half-swing: the truncated equations against the motion, |error| <= C delta^m
``half_swing``    the series of ln(A'/A) of one half-swing, cut after delta^N
``turning``       all turning points: how these errors add up, for every n
``orbit``         the same half-swing by half-swing, for alpha < 1 as well, as far as it holds
``flow``          the truncated equations over any number of half-swings at once, in balls
``late``          x at a late time, by the theorem for all turning points
``waveform``      how large the waveform is, and what an expansion leaves over in the motion, on every piece
``uniform``       |x - x_N| for all times at once, A and psi solving the truncated equations
``explicit``      the same for the explicit form of one law
``reach``         until when |x - x_N| is proved below a size that is stated
``motion``        |x - x_N| at a given time, by an enclosure of x
================  ====================================================================================
"""
