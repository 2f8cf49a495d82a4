"""Certificates beside the report, with the page that checks them: turning points that anybody can prove again.

>>> sorted(certificates_of("smith2012:table1.u3"))
['certificate-quadratic.json']
>>> certificates_of("smith2012:43")
()
"""

from pathlib import Path

from asymptotics.certificates.of_results import of_turning_points
from asymptotics.law import Law
from asymptotics.testing import check_certificate
from asymptotics.turning.choose import turning_points

CHECKER = Path(check_certificate.__file__)
MADE = {  # the file, its law, the points and the digits: Table I of Smith 2012 is the first one
    "certificate-quadratic.json": (Law({2: 1}), 6, 20),
    "certificate-three-halves.json": (Law({"3/2": "1/10"}), 6, 30),
}
_TABLE = ":".join(("smith2012", "table1.u"))  # with a number: the ids of its turning points


def certificates_of(statement: str) -> tuple[str, ...]:
    """The files that prove what a statement tabulates."""
    return ("certificate-quadratic.json",) if statement.startswith(_TABLE) else ()


def certificate_files() -> dict[str, str]:
    """The checker as it is, and each certificate with times."""
    made = {CHECKER.name: CHECKER.read_text(encoding="utf-8")}
    for name, (law, count, digits) in MADE.items():
        table = turning_points(law, count, digits, times=True)
        made[name] = of_turning_points(law, table).to_json() + "\n"
    return made
