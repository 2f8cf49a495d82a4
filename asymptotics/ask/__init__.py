"""What can be asked: the kinds of values, the question, what an answer offers; one file a question in ``questions``."""
