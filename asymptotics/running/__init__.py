"""Time, alarms, rows that are done, progress, little memory: what carries a computation."""
