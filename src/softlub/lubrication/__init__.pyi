from .face import solve as solve
from .face import sweep as sweep
from .film import Lubricant as Lubricant
from .meshed_body import MeshedBody as MeshedBody
from .problem import HalfSpaceCylinder as HalfSpaceCylinder
from .problem import Problem as Problem
from .result import LubricatedContact as LubricatedContact
