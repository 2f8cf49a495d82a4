"""Printed decrements with a resolution: the strengths that meet every value, as proved sets, or the proof of none."""
