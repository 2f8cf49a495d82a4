"""What is formal and exact: power series in the local strengths, and the equations and solutions made of them.

Equalities, no numbers with errors, except where a file says ``certified`` in its name or its first line.
"""
