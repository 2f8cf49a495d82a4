"""The moments M_p = <|sin|^p>: the one family of averages everything is made of (theory page ``closed_forms``).

==============  ==========================================================================================
``symbolic``    M_p as a SymPy expression, rational or rational/pi for integer p; Lelas' replacement
``certified``   M_p as a ball, for any real p > -1
==============  ==========================================================================================
"""
