"""What is formal and exact: power series in the local strengths, and the equations and solutions made of them.

Equalities, and balls where exponents are no whole numbers; which file has which arithmetic is in
``docs/maintainers/arithmetics.md``.
"""
