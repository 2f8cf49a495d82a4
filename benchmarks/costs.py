"""What the estimates of ``asymptotics.costs`` say beside what is taken: every route to turning points that serves."""

from functools import partial

from asymptotics.law import Law
from asymptotics.turning.choose import offers, turning_points
from asymptotics.turning.table import PointsRequest
from benchmarks.table import Table, best_time, seconds_text

REQUESTS: list[tuple[Law, int, int]] = [
    (Law({0: "1/1000"}), 400, 30),
    (Law({1: "1/1000"}), 400, 30),
    (Law({2: "1/10"}), 60, 30),
    (Law({"3/2": "1/10"}), 60, 30),
    (Law({1: "1/50", "3/2": "1/10"}), 60, 30),
    (Law({"3/2": "1/10"}, spring="pendulum"), 30, 30),
    (Law({0: "1/1000", 2: "1/10"}, spring={3: "1/2"}), 60, 30),
]
DEAR = 20.0


def run(size: int = 60) -> Table:
    """A row for each request and route: at most ``size`` points, and none that is said to take more than 20 s."""
    rows = []
    for law, count, digits in REQUESTS:
        request = PointsRequest.read(law, min(count, size), digits)
        for route, said in offers(request):
            if said is not None and said < DEAR:
                taken = best_time(partial(turning_points, law, request.count, digits, route=route.name), 1)
                numbers = (seconds_text(said), seconds_text(taken), f"{said / taken:.2g}")
                rows.append((str(law), str(request.count), route.name, *numbers))
    return Table(
        "Estimates of costs beside processor time",
        ("law", "points", "route", "said", "taken", "said/taken"),
        tuple(rows),
    )
