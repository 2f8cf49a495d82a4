"""A file in SI that begins at t = 0, from an amplitude that is no binary fraction."""

import pytest
from flint import arb, fmpq

from asymptotics.comparison.run import compare_file
from asymptotics.law import Oscillator
from asymptotics.numbers.digits import ball_of


def test_a_record_in_si_may_begin_at_the_start(tmp_path):
    path = tmp_path / "lab.csv"
    path.write_text("t,x\n0,0.2\n0.1,0.18\n")
    found = compare_file(path, Oscillator({2: "1/10"}, mass="3/2", stiffness=30, x0="1/5"), si=True)
    assert found.certified
    assert found.rows[0].digits == "20.00"


@pytest.mark.parametrize(
    ("text", "middle", "half"),
    [("0.25", fmpq(1, 4), fmpq(1, 200)), ("-1.5e3", fmpq(-1500), fmpq(50)), ("7", 7, fmpq(1, 2))],
)
def test_a_decimal_is_every_number_that_rounds_to_it(text, middle, half):
    """Both ends of the interval are in the ball, and a number a thousandth farther out is not."""
    ball = ball_of(text)
    assert all(ball.contains(arb(middle + side * half)) for side in (-1, 0, 1))
    assert not any(ball.contains(arb(middle + side * half * fmpq(1001, 1000))) for side in (-1, 1))
    assert ball_of("0").is_zero()
