"""One file a question; the name of the file is that of the command."""
