"""Right digits: those of the relative error, what is marked, errors in two digits."""

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from asymptotics.decays.comparison.digits import judged, marked, right_digits

# --- digits


@given(st.fractions(min_value=Fraction(1, 10**9), max_value=10**9), st.integers(1, 15), st.sampled_from([1, -1]))
def test_right_digits_are_those_of_the_relative_error(value, digits, sign):
    off = value * (1 + sign * Fraction(1, 10**digits))
    assert right_digits(off, value, 30) == f"{digits}.00"
    assert right_digits(-off, -value, 30) == f"{digits}.00"
    assert right_digits(-off, value, 30) == "0.00"


def test_a_value_on_the_tie_has_its_last_digit_right_and_one_beyond_has_not():
    told = [marked("1.2350", Fraction(value)) for value in ("1.2345", "1.2344999999999999999999")]
    assert told == ["1.235[0]", "1.23[50]"]  # a double cannot tell them apart: integers decide


@given(st.decimals("-1e6", "1e6", allow_nan=False, places=8), st.integers(0, 7))
def test_what_is_not_marked_is_right(value, place):
    if not value:
        return
    wrong = Fraction(value) + Fraction(7, 10 ** (place + 1))
    text = f"{value:f}"
    shown = marked(text, wrong)
    assert shown.replace("[", "").replace("]", "") == text
    kept = shown.partition("[")[0]
    if "[" in shown and any(letter in "123456789" for letter in kept):
        ulp = Fraction(1) if "." not in kept else Fraction(1, 10 ** len(kept.partition(".")[2]))
        scale = ulp if "." in kept else Fraction(10 ** (len(text.partition(".")[0]) - len(kept)))
        assert abs(Fraction(text) - wrong) <= scale / 2


def test_errors_in_two_digits():
    errors = [judged("", 1 + Fraction(t), Fraction(1), 0).error for t in ("0", "0.00123", "9.96", "0.0999")]
    assert errors == ["0", "1.2e-03", "1.0e+01", "1.0e-01"]
