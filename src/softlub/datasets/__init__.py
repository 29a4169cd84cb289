"""Datasets: the one table of variables, and the one reader and writer."""
