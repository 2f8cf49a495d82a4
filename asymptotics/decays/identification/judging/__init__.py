"""One law against the data and against the others: consistent, adequate to p % of the loss, refuted."""
