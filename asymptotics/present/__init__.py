"""Presentation: reproducible figures, MathML, atomic files.  Nothing in the library imports this folder."""
