"""Functions of time, and what is read off them, as results in units: turning points in metres and seconds."""
