"""The reference tables by name.

>>> table_names()["moments"]
'The averages M_p = <|sin|^p> that the first orders need'
"""

from asymptotics.numbers.policy import Number
from asymptotics.running.public import public
from asymptotics.tables import registry


@public
def table_names(*, max_seconds: Number = 60) -> dict[str, str]:
    """The names of the tables of ``table`` and their titles, as ``asymptotics table --list`` has them.

    Parameters
    ----------
    max_seconds
        the time the call may take, in s

    Returns
    -------
    dict
        name -> title

    Examples
    --------
    >>> table_names()["smith2012.f"]
    'Smith 2012, (60): the polynomials f_n(w)'
    """
    return registry.names()
