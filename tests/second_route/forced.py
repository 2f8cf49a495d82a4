"""One route by name, whatever the ladder would choose."""

from asymptotics.law import Law
from asymptotics.turning.choose import turning_points


def quadratic_turning_points(epsilon, count, digits=30, **rest):
    return turning_points(Law({2: epsilon}), count, digits, route="quadratic", **rest)


def drag_turning_points(law, x0, count, digits):
    return turning_points(law, count, digits, x0=x0, route="closed-primitive")


def stepping_turning_points(law, x0, count, digits, **rest):
    return turning_points(law, count, digits, x0=x0, route="stepping", **rest)
