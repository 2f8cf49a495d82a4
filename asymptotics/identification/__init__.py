"""The inverse problem: from a measured decay to the damping law, its strengths, and how sure they are.

All numbers here are doubles and all intervals statistical, none of them a certificate; the exception is the room
``certified_sets``, where doubles propose and balls decide.
"""
