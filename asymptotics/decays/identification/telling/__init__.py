"""The answer: the verdict in words, what a law means at the amplitudes, pictures, pages, the result object."""
