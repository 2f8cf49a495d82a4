"""Error bounds of the expansions that are theorems: constants and ranges, computed in balls and rounded up.

================  ====================================================================================
``local``         one half-swing: the truncated equations against the motion, |error| <= C delta^m
``turning``       all turning points: how these errors add up, for every n
``orbit``         the same half-swing by half-swing, for alpha < 1 as well, as far as it holds
``flow``          the truncated equations over any number of half-swings at once, in balls
``late``          x at a late time, by the theorem for all turning points
``motion``        |x - x_N| at a given time, by an enclosure of x
================  ====================================================================================
"""
