"""The inverse problem: from a measured decay to the damping law, its strengths, and how sure they are.

The field's word is system identification (Ljung 1999): candidate models, fits by likelihood, selection among them, and
a test on swings that no fit has seen.

All numbers here are doubles and all intervals statistical, none of them a certificate; the exception is the room
``certified_sets``, where doubles propose and balls decide.
"""
