from .body import Body as Body
from .compliance import MeshedCompliance as MeshedCompliance
from .equivalence import fit_coefficient as fit_coefficient
from .mesh import BodyMesh as BodyMesh
from .reduced_stiffness import ReducedStiffness as ReducedStiffness
from .reduction import condense as condense
from .steps import run as run
