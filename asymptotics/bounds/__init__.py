"""Error bounds of the expansions that are theorems: constants and ranges, computed in balls and rounded up."""
