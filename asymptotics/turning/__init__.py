"""Turning points and their times: every route is asked its cost, and the cheapest that serves is followed.

Digits are rounded from balls or rational numbers (``result``).
"""
