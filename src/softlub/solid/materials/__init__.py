"""Materials of soft bodies; one material a file."""
