"""The return map from one turning point to the next, interpolated in the amplitude: beside the linear spring.

Derivation ``quarter-collocation``.
"""
