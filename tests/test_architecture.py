"""The page for maintainers: its table of routes and its journeys are what the code does."""

import re

import pytest

from tests.journeys import JOURNEYS, PAGE, ROOT, listed, routes, told, traced


def test_the_table_of_routes_is_that_of_the_code():
    assert told("routes") == routes(), "python -m tests.journeys rewrites it"


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
