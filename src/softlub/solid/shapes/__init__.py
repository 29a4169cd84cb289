"""Shapes of soft bodies; one shape a file."""
