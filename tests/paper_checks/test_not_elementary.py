"""The two motions of Smith's equation that are elementary: rest was taken for one that is not, until it was asked."""

import inspect

import pytest
import sympy

from paper_checks.smith2012.section_3_law import TAU, not_elementary


@pytest.mark.parametrize("form", [sympy.Integer(0), TAU**2 / 4 - sympy.Rational(1, 2), sympy.cos(TAU), sympy.log(TAU)])
def test_an_elementary_motion_has_s_0_or_rests(form):
    """No expression is confirmed: 0 and the parabola are the motions with an exception, the others are no motions."""
    assert str(inspect.unwrap(not_elementary)(form)) == "refuted"
    assert str(inspect.unwrap(not_elementary)(None)) == "confirmed"
