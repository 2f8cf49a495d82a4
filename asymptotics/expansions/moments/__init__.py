"""The moments M_p = <|sin|^p>: the one family of averages everything is made of (theory page ``closed_forms``)."""
