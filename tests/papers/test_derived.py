"""The derivations as installed data: listed with their titles by paper, and found by words."""

from importlib import import_module

import pytest

from asymptotics.errors import InputError
from asymptotics.papers.derived import derivations, grouped
from asymptotics.papers.lookup import paper
from derivations.__main__ import names


def test_every_derivation_is_listed_once_with_its_title():
    assert sorted(d.name for d in derivations()) == names()
    assert [d for found in grouped().values() for d in found] == list(derivations())
    for name in ("smith-integrating-factor", "lelas-line-end", "no-overdamping"):
        own = import_module("derivations." + name.replace("-", "_")).derivation
        (record,) = (d for d in derivations() if d.name == name)
        assert (record.title, record.source) == (own.title, own.source)
        assert all(paper(key).derivation == name for key in record.statements)


@pytest.mark.parametrize(
    ("words", "first"),
    [("closed sum", "smith-closed-sum"), ("Lelas friction", "lelas-friction"), ("no-overdamping", "no-overdamping"),
     ("smith2012:62b", "smith-closed-sum"), ("overdamping", "no-overdamping")],
)  # fmt: skip
def test_found_by_words_a_name_or_the_id_of_a_statement(words, first):
    assert derivations(words)[0].name == first


def test_a_derivation_belongs_to_the_paper_of_its_name():
    for d in derivations():
        author = d.name.partition("-")[0]
        if author in ("lancaster", "lelas", "smith") and d.statements:
            assert d.paper.startswith(author), d
        assert not d.paper or any(i.startswith(d.paper) for i in d.statements)


@pytest.mark.parametrize("words", ["zzzz", "", "  ", 3])
def test_what_is_not_found_is_said(words):
    with pytest.raises(InputError, match="argument words"):
        derivations(words)
