"""Contact of rough surfaces: deterministic solvers, Persson's theory, contact laws.

The names of the deterministic solver are loaded when they are first used: contact laws must not wait for it.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
