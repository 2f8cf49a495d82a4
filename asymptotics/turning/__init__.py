"""Turning points and their times: every route is asked its cost, and the cheapest that serves is followed.

They are the iterates of the return map of the section v = 0 (Poincare); far out, at a parabolic fixed point, an Abel
function counts them.  Digits are rounded from balls or rational numbers (``result``).
"""
