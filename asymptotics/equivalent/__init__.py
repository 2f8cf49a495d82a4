"""Equivalent damping: what a loss is at an amplitude, in the words of linear damping.

Theory page ``equivalent_damping``.
"""
