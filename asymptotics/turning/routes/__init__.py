"""The routes to the turning points, one file and one line each; of equal costs the first one is taken."""

from asymptotics.turning.route import Route
from asymptotics.turning.routes import (
    abel_flow,
    abel_series,
    closed_primitive,
    dry,
    interpolated,
    linear,
    quadratic,
    stepping,
)

ROUTES: tuple[Route, ...] = (
    dry.ROUTE,
    linear.ROUTE,
    quadratic.ROUTE,
    closed_primitive.ROUTE,
    abel_series.ROUTE,
    abel_flow.ROUTE,
    interpolated.ROUTE,
    stepping.ROUTE,
)
