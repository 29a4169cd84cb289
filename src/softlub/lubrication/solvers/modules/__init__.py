"""What the source's three modules share: their grid, sweeps, residuals, relaxation factors and acceleration."""
