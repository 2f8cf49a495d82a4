"""Presentation: how a result shows itself, reproducible figures, MathML, atomic files; nothing is computed here."""
