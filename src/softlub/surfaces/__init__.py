"""Rough surfaces: spectra, synthesis, measured topographies, statistics.

The names below are loaded when they are first used: the study reader needs the spectrum's parameters at every start of
the workflow, and must not wait for transforms and readers of files.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
