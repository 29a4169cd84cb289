"""Contact laws: asperity pressure over mean separation, real contact area over pressure; one law a file."""
