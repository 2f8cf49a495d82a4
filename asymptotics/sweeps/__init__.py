"""Sweeps: one computation at many points, on one core or a cluster, stopped and resumed at will."""

from asymptotics.sweeps.grid import Grid, values
from asymptotics.sweeps.run import SweepResult, sweep

__all__ = ["Grid", "SweepResult", "sweep", "values"]
