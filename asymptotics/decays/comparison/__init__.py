"""One's own values beside certified ones: how many digits are right, and what the errors look like."""

from asymptotics.decays.comparison.run import ComparedValue, Comparison, compare_file
from asymptotics.decays.comparison.tabled import compare_table

__all__ = ["Comparison", "ComparedValue", "compare_file", "compare_table"]
