"""What the front door hands out: each function takes a law or an oscillator and answers in its units."""
