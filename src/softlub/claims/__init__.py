"""Claims: what the source states, and whether the numbers of our studies bear it out.

`config/claims.csv` holds the statements as facts (`table` reads it); the chapters' files hold one small check per
statement, `evaluate` runs them, `caption` says what came of those that name a figure.
"""
