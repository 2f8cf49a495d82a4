"""Equivalent damping: what a loss is at an amplitude, in the words of linear damping.

Theory page ``equivalent_damping``.

==============  ==========================================================================================
``symbolic``    zeta(A), Q(A), decrement, energy loss, c_eq and half-life as formulas, first order
``orbit``       the same as balls, on the orbit without loss, beside any spring that depends on the place
``cycle``       what the motion itself does in one full swing, and the expansion of order N with its bound
``conversions`` the strengths under the names of other tools
``inverse``     from (A, zeta), (A, Q) or (A, decrement) to candidate laws with intervals, in doubles
``found_law``   that answer: the verdict in words, grades
``result``      the table, the curve, LaTeX and JSON
==============  ==========================================================================================
"""
