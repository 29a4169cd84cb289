"""Deterministic contact of a rough surface with an elastic half-space, by conjugate gradients on the free set."""
