"""Whole numbers, as a toy of a question that test_one_file puts beside those of the package."""

from dataclasses import dataclass
from typing import Annotated

from asymptotics.ask.answers import Offers
from asymptotics.ask.kinds import SECONDS, digits, whole
from asymptotics.ask.laws import law_with_strengths
from asymptotics.ask.question import question
from asymptotics.law import LawLike
from asymptotics.numbers.decimals import rational_decimal
from asymptotics.numbers.policy import Number
from asymptotics.present.inputs import csv_text
from asymptotics.present.shown import Shown


@dataclass(frozen=True)
class Toys(Shown):
    """The numbers."""

    values: tuple[str, ...]

    def to_dict(self) -> dict[str, object]:
        """Plain data."""
        return {"values": list(self.values), "arithmetic": "exact"}

    def __str__(self) -> str:
        return f"{', '.join(self.values)}, exact"


@question(
    Offers(
        table="n, value",
        as_csv=lambda found, _: csv_text(["n", "value"], [(str(n), v) for n, v in enumerate(found.values)]),
        lacks={
            "gauge": "a toy has no gauge",
            "latex": "toys are numbers",
            "plot": "toys are no curve",
            "points": "`--count` says how many",
        },
    ),
    swept=True,
    example="--law 2:1/10 --count 2 --digits 5",
    rests="exact rational arithmetic",
)
def toy(
    law: Annotated[LawLike, law_with_strengths("its strength", springs=False)],
    *,
    count: Annotated[int, whole(1, 9, "K")] = 1,
    digits: Annotated[int, digits(50)] = 10,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> Toys:
    """The multiples of the number of laws, a toy.

      asymptotics toy --law 2:1/10 --count 2

    Parameters
    ----------
    law
        a law
    count
        how many
    digits
        significant digits, correctly rounded
    max_seconds
        the time the request may take, in seconds

    Examples
    --------
    >>> toy({2: "1/10"}, count=2, digits=5).values
    ('1.0000', '2.0000')
    """
    return Toys(tuple(rational_decimal((n + 1) * len(law.terms), digits) for n in range(count)))
