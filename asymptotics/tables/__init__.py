"""Reference tables: exact or certified rows as strings, with provenance, to any number of digits, in any rounding.

>>> from asymptotics.tables.registry import build
>>> table = build("smith2012.table1", digits=6)
>>> table.rows[1]
('2', '0.0987650', '-0.410720')
"""
