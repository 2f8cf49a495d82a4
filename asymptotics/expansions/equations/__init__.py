"""The amplitude and phase equations as one result: evaluated, converted, shown, compared, observed."""
