"""Reference tables: exact or certified rows as strings, with provenance, to any number of digits.

>>> table = build("smith2012.table1", digits=6)
>>> table.columns
('half_cycle', 'S_hat', 'u')
>>> table.rows[1]
('2', '0.0987650', '-0.410720')
"""

from asymptotics.tables.registry import Table, build, names

__all__ = ["Table", "build", "names"]
