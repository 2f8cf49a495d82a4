"""Turning points for any alpha >= 0 and any sum of laws, certified: the one ladder that chooses a route.

Every route of ``routes`` is asked what the request would cost; the cheapest one that serves is taken, unless one is
named.  All of them prove their digits, so the choice changes nothing but the time and ``method``.

``ended`` names the last turning point if the sequence has ended before or at the last number asked for:

``sticks``      dry friction holds the mass there;
``creeps``      some alpha < 1: the mass approaches its place of rest without passing it (derivation ``creep``);
``overdamped``  linear damping with epsilon >= 2;
``rotates``, ``escapes``  the start has the energy to leave the well, and does.

For alpha > 1 alone the sequence never ends, however strong the damping (derivation ``no-overdamping``).

>>> table = turning_points(Law({"3/2": "1/10"}), 2, 20, times=True)
>>> table.points[1].x, table.points[1].tau, table.certified
('-0.87019329198866231436', '3.1460821722171718997', True)
>>> half = turning_points(Law({"1/2": "1"}), 4, 10)
>>> [p.x for p in half.points], half.ended
(['1.000000000'], {'n': 0, 'reason': 'creeps'})
>>> turning_points(Law({2: 1}), 2, 10, route="stepping").points == turning_points(Law({2: 1}), 2, 10).points
True
"""

from asymptotics.errors import InputError, require_choice
from asymptotics.law import Law
from asymptotics.numbers.policy import Number
from asymptotics.running.budget import DEFAULT_SECONDS, budget, tick
from asymptotics.turning.enclosing import require_soon
from asymptotics.turning.result import TurningPoints
from asymptotics.turning.route import Route
from asymptotics.turning.routes import ROUTES
from asymptotics.turning.table import MAX_DIGITS, PointsRequest, Progress


def turning_points(
    law: Law,
    count: int,
    digits: int = 30,
    *,
    start: int = 0,
    times: bool = False,
    x0: Number = 1,
    v0: Number = 0,
    route: str | None = None,
    max_seconds: float = DEFAULT_SECONDS,
    most: int = MAX_DIGITS,
    progress: Progress = lambda done: None,
) -> TurningPoints:
    """Turning points n = start ... start + count - 1 as far as they exist, for the strengths epsilon_i of ``law``.

    With springs or losses that depend on the place the start is at ``x0`` in the units of the strengths.  With ``v0``
    (dimensionless, as ``x0``) the start is in motion: n = 0 is the first turning point, see ``table``.  ``route``: the
    name of one that serves, else the cheapest.  ``progress`` is called with the number of points finished.  ``most``:
    as in `PointsRequest.read`.  InputError for a negative strength or a route that does not serve, LimitError for
    more work than the stated limits or ``max_seconds``, UndecidedError where balls cannot tell how it goes on.
    """

    def finished(done: int) -> None:
        tick(f"turning point {done} of {count}")
        progress(done)

    request = PointsRequest.read(law, count, digits, start=start, times=times, x0=x0, v0=v0, most=most)
    with budget(max_seconds):
        require_soon(request)
        return choose(request, route).points(request, finished)


def choose(request: PointsRequest, name: str | None = None) -> Route:
    """The cheapest route that serves, or the one named; InputError for one that is unknown or does not serve."""
    if name is not None:
        return _named(request, name)
    costs = {i: seconds for i, (_, seconds) in enumerate(offers(request)) if seconds is not None}
    # Equal costs: the order of ``ROUTES``, so that the choice does not depend on the machine.
    return ROUTES[min(costs, key=lambda i: (costs[i], i))]


def offers(request: PointsRequest) -> list[tuple[Route, float | None]]:
    """Every route, with the seconds it would take for the request, None where it does not serve."""
    return [(route, route.serves(request)) for route in ROUTES]


def _named(request: PointsRequest, name: str) -> Route:
    require_choice(name, "route", (route.name for route in ROUTES))
    serving = {route.name: route for route, seconds in offers(request) if seconds is not None}
    if name not in serving:
        raise InputError("route", f"{name} does not serve this request", ", ".join(serving))
    return serving[name]
