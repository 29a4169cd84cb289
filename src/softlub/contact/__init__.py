"""Contact of rough surfaces: deterministic solvers, Persson's theory, contact laws."""
