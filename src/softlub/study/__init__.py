"""Studies: from a study file to the plan of what is to be computed.

Nothing here solves anything or imports what does: the workflow imports this at every start. The names below are loaded
when they are first used: a job takes parts of a study's vocabulary and reads no study.
"""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
