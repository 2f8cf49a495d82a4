"""Many cases in one test: every one is tried, and those that fail are named."""

import pytest

from tests.each import each


def test_every_case_that_fails_is_named_with_what_it_says():
    tried = []

    @each("n", range(5))
    def odd(n, extra):
        tried.append((n, extra))
        assert n % 2, f"{n} is even"

    with pytest.raises(AssertionError, match="3 of 5 cases") as caught:
        odd(extra="fixture")
    assert tried == [(n, "fixture") for n in range(5)]
    assert all(f"{n}: AssertionError: {n} is even" in str(caught.value) for n in (0, 2, 4))
    assert "1: " not in str(caught.value)


def test_another_error_and_a_failure_of_pytest_are_failures_of_their_case():
    @each(("kind", "of"), [(ValueError, "a"), (pytest.fail.Exception, "b"), (None, "c")])
    def raised(kind, of):
        if kind:
            raise kind(of)

    with pytest.raises(AssertionError, match="2 of 3 cases"):
        raised()


def test_no_case_at_all_is_a_failure():
    with pytest.raises(AssertionError, match="0 of 0 cases"):
        each("n", [])(lambda n: None)()


@each("n", [1, 2])
def test_a_fixture_is_handed_to_every_case(n, tmp_path):
    (tmp_path / str(n)).touch()
    assert len([*tmp_path.iterdir()]) == n
