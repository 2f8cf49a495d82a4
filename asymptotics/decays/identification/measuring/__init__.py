"""From a table to observations: turning points and times of a record, its noise, its sensors, its second modes."""
