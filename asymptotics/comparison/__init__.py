"""One's own values beside certified ones: how many digits are right, and what the errors look like.

============  ====================================================================================
``digits``    right digits of a value: -log10 of the relative error, and its wrong digits marked
``reading``   a CSV file with its columns: what is a key, what is a value, in which unit
``truth``     the certified values: turning points, motion, named tables
``errors``    errors of amplitude and of time, half-swing by half-swing, from either kind of file
``quick_look`` what the errors look like: rounding, truncation, phase drift or a wrong law
``run``       all of it: ``compare_file``
``tabled``    the same for a named table: ``compare_table``
``order``     whether the rows are in the order of their keys
``stated``    what the head of one of our own files says that it is
============  ====================================================================================
"""

from asymptotics.comparison.run import ComparedValue, Comparison, compare_file
from asymptotics.comparison.tabled import compare_table

__all__ = ["Comparison", "ComparedValue", "compare_file", "compare_table"]
