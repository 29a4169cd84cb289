"""Solvers of the lubricated contact; one solver a folder or file.

Each is a frozen dataclass of its settings with two methods: ``solve(problem, start=None)`` returns a
`LubricatedContact`, ``sweep(problem, speeds)`` a list of them, continued along speed.
"""
