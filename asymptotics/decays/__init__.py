"""Measured decays: their files, what they are compared with, and the law behind them."""
