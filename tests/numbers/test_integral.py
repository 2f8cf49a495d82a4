"""What goes wrong inside an integrand comes out of the integral as it is, at once."""

import pytest
from flint import arb

from asymptotics.errors import LimitError
from asymptotics.numbers.integral import integral
from asymptotics.running.budget import budget


@pytest.mark.parametrize("error", [LimitError("time", "is over", "more"), ZeroDivisionError("x"), KeyboardInterrupt()])
def test_an_error_in_the_integrand_is_the_error_of_the_integral(error):
    calls = []

    def integrand(r, analytic):
        calls.append(r)
        if len(calls) == 3:
            raise error
        return r.exp()

    # The answer before: FLINT called back to its limit, each time with an error, or an answer with an error set.
    with pytest.raises(type(error)) as caught:
        integral(integrand, arb(0), arb(40), "a test")
    assert caught.value is error and len(calls) == 3
    assert integral(lambda r, _: r.exp(), arb(0), arb(1), "e - 1").overlaps(arb(1).exp() - 1)


def test_a_time_that_is_over_ends_an_integral_without_asking_the_integrand_again():
    calls = []
    with pytest.raises(LimitError), budget(1e-9):
        integral(lambda r, _: calls.append(r) or r, arb(0), arb(1), "a test")
    assert calls == []
