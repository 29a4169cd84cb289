"""The soft solid: shapes, materials, finite elements, reduced stiffness."""
