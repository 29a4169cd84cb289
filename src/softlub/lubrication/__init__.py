"""The lubricated line contact: problem, solvers, friction, sweeps over load and speed."""
