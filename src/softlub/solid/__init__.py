"""The soft solid: shapes, materials, finite elements, reduced stiffness.

The names below are loaded when they are first used: the study reader needs the parameters alone, and no elements.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
