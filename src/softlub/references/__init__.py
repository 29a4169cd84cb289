"""Closed forms, one a file, in plain numbers: what tests, benchmarks and figures compare with.

They know nothing of the solvers. Everywhere the wall at the bottom moves at speed v in +x and the film obeys
d/dx(u³/(6ηv) dp/dx) = du/dx (equation 3-2); friction is taken on that wall, ηv/u + (u/2) dp/dx (equation 3-36).
"""
