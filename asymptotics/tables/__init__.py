"""Reference tables: exact or certified rows as strings, with provenance, to any number of digits, in any rounding.

================  ==================================================================================
``registry``      ``build(name, inputs, digits, rounding)``
``recipes``       the list of the tables: columns, units, routes, cost
``inputs``        exponents, laws, strengths, rows
``cells``         what stands in a cell, and its rounding
``table``         text, CSV, JSON (``schema.json``), LaTeX, Parquet
``provenance``    inputs, code, versions, commit, SHA-256
``moments`` ...   the rows: moments, coefficients, turning, slow, stokes, quadratic
``standard_set``  ``python -m asymptotics.tables FOLDER``: every table in three forms
================  ==================================================================================

>>> from asymptotics.tables.registry import build
>>> table = build("smith2012.table1", digits=6)
>>> table.rows[1]
('2', '0.0987650', '-0.410720')
"""
