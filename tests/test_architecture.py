"""The page for maintainers: its table of routes and its journeys are what the code does."""

import re

import pytest

from asymptotics.errors import InputError
from asymptotics.law import Law
from asymptotics.turning.choose import turning_points
from tests.journeys import FILES, JOURNEYS, PAGE, ROOT, listed, map_of_files, routes, told, traced


def test_the_table_of_routes_is_that_of_the_code():
    assert told("routes") == routes(), "python -m tests.journeys rewrites it"


def test_the_page_of_files_is_that_of_the_code():
    assert FILES.read_text(encoding="utf-8") == map_of_files(), "python -m tests.journeys rewrites it"


@pytest.mark.slow
@pytest.mark.parametrize("name", JOURNEYS)
def test_a_journey_visits_the_files_that_the_page_lists(name, tmp_path):
    assert told(name) == listed(traced(name, tmp_path)), "python -m tests.journeys rewrites it"


def test_the_files_that_the_page_names_exist():
    named = set(re.findall(r"`((?:\w+/)+\w+\.(?:py|json))`", PAGE.read_text(encoding="utf-8")))
    assert len(named) > 10
    known = [
        path.as_posix() for folder in ("asymptotics", "tests", "benchmarks") for path in (ROOT / folder).rglob("*")
    ]
    for file in named:
        assert any(path.endswith(f"/{file}") for path in known), file


def test_where_the_two_forces_of_place_and_velocity_go_is_as_the_page_says():
    """c x|x'| is a spring that no enclosure takes; c |x|x' is a loss, and is enclosed."""
    spring, loss = Law({2: "1/10"}, spring={(1, 1): "1/10"}), Law({(1, 1): "1/10"})
    assert spring.terms[-1].shape() == "x |x'|^(1)" and loss.terms[0].shape() == "|x| x'"
    assert turning_points(loss, 2, 10).certified
    with pytest.raises(InputError, match="not enclosed"):
        turning_points(spring, 2, 10)
