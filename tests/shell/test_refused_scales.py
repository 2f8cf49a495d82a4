"""What `multiple-scales` and `solution` refuse: the argument, the reason, and what is accepted, in one line."""

import pytest

from asymptotics.shell.main import main

NUMBERS = "accepted: a real number from 0 to 1000"
REFUSED = [
    ("solution --alpha 2 --order 0", "--order", "accepted: an integer from 1 to 12"),
    ("solution --alpha 2 --order 13", "--order", "accepted: an integer from 1 to 12"),
    ("solution --alpha symbolic --order 13", "--order", "accepted: an integer from 1 to 12"),
    ("solution --alpha=-1", "--alpha", NUMBERS),
    ("solution --alpha 2 --epsilon=-1/10", "--epsilon", "accepted: a strength >= 0"),
    ("solution --alpha symbolic --epsilon 1/10", "--alpha", "accepted: --alpha symbolic alone"),
    ("multiple-scales --alpha 2 --order 0", "--order", "accepted: an integer from 1 to 60"),
    ("multiple-scales --alpha 2 --order 61", "--order", "accepted: an integer from 1 to 60"),
    ("multiple-scales --alpha 3/2 --order 13", "--order", "accepted: 1 to 12, or integer exponents"),
    ("multiple-scales --alpha symbolic --order 13", "--order", "accepted: 1 to 12, or integer exponents"),
    ("multiple-scales --alpha=-1", "--alpha", NUMBERS),
    ("multiple-scales --law 2 --law=-1/2", "--law", NUMBERS),
    ("multiple-scales --alpha 2 --gauge no-first-harmonic", "--gauge", "accepted: turning-point"),
    ("multiple-scales --alpha symbolic --gauge no-first-harmonic", "--gauge", "accepted: turning-point"),
    ("multiple-scales --alpha 3 --gauge averaging", "--gauge", "accepted: turning-point for any law"),
    ("multiple-scales --alpha 2 --gauge wrong", "--gauge", "accepted: turning-point, averaging"),
    ("multiple-scales --alpha 3/2 --order 3 --start", "--order", "accepted: 1 to 2 for these exponents"),
    ("multiple-scales --alpha 3 --order 2 --start", "--start", "accepted: gauge turning-point"),
]


@pytest.mark.parametrize(("line", "argument", "accepted"), REFUSED, ids=[row[0] for row in REFUSED])
def test_it_is_refused_by_name_with_what_is_accepted(capsys, line, argument, accepted):
    assert main(line.split()) == 2
    told = capsys.readouterr()
    assert told.out == "" and told.err.count("\n") == 1
    assert f"argument {argument}: " in told.err and accepted in told.err
