"""One short script per derivation: from the equation of motion to a named result, each displayed step asserted.

A derivation computes on import and asserts each step it displays; ``python -m derivations NAME`` runs one and prints
it, ``--latex`` prints it as LaTeX, and without a name the list is shown.
"""
