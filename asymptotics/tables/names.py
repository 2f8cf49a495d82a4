"""The reference tables by name.

>>> table_names()["moments"]
'The averages M_p = <|sin|^p> that the first orders need'
"""

from asymptotics.numbers.policy import Number
from asymptotics.running.public import public
from asymptotics.tables import registry


@public
def table_names(*, max_seconds: Number = 60) -> dict[str, str]:
    """The names of the tables and their titles, as ``asymptotics table --list`` has them."""
    return registry.names()
