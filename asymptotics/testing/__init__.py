"""For tests of one's own code: random laws and oscillators that seek out trouble, and certified answers to hold it to.

A recurrence, an integrator or an expansion is tested like this (the averaged law has five right digits, not nine):

>>> from asymptotics.law import Law
>>> from asymptotics.testing.oracles import check_turning_points
>>> def first_order(law, count):                              # the averaged law of alpha = 2, (2/pi) M_3 pi = 4/3
...     eps = 0.01
...     return [(-1) ** n / (1 + n * 4 / 3 * eps) for n in range(count)]
>>> check_turning_points(first_order, Law({2: "1/100"}), count=3, digits=5)
>>> check_turning_points(first_order, Law({2: "1/100"}), count=3, digits=9)
Traceback (most recent call last):
    ...
AssertionError: turning point 1: -0.986842... has ... right digits, 9 are wanted (certified: -0.98684...)
"""
