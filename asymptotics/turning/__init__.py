"""Turning points and the times between them."""
