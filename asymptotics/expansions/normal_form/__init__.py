"""The flow behind the half-swing map: amplitude and frequency series in three gauges."""
