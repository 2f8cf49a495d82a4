"""Smith 2012: constants of the motion of the quadratically damped oscillator."""
