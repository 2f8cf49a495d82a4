"""What a route to the turning points is: whether it serves a request, at what cost, and what it finds.

A route is one file of ``routes/`` and one line of ``routes/__init__.py``.  Costs are estimates in seconds (``costs``):
they choose, and claim nothing; whichever route is taken, its digits are proved.
"""

from collections.abc import Callable
from dataclasses import dataclass

from asymptotics.turning.result import TurningPoints
from asymptotics.turning.table import PointsRequest, Progress


@dataclass(frozen=True)
class Route:
    """``serves(request)``: the seconds it would take, or None; ``points(request, progress)``: the table it finds.

    ``domain`` and ``way`` say in words what it serves and how; what of ``motions`` states (x, v) at a time in the same
    way names its route (``motions.state_route``).
    """

    name: str
    domain: str
    way: str
    serves: Callable[[PointsRequest], float | None]
    points: Callable[[PointsRequest, Progress], TurningPoints]
