"""Records as people have them: text tables of any layout, spreadsheets, arrays; what was read is said, never guessed.

``text``      packed or not, in which encoding: lines
``layout``    separator, decimal mark, first row of numbers; ``header``: the names above it
``rates``     samples without times: the rate in the header (``one_column``, ``clocked``); ``levels``: decibels
``cells``     the number in a cell, strictly
``units``     units in the names of columns
``columns``   which column is what, by its name; ``uncertainties``: those of errors
``choosing``  and by what stands in it (``main_axis``); where two could be meant, it is asked
``body``      the numbers, in blocks of lines
``formats``   spreadsheets, parquet, npz, npy, mat
``sources``   a path, an open file, a data frame, a mapping
``clock``     repeated, restarted and reversed times, and those of a buffer (``bursts``)
``table``     all of it: ``read_table``
"""
