"""The command line: one module per command, loaded only when its command is called, so that starting stays fast."""
