"""The forward problem in doubles: candidate laws, and their half-swings and turning points with exact derivatives."""
