from .displacement_control import solve_at_approach as solve_at_approach
from .displacement_control import solve_at_mean_gap as solve_at_mean_gap
from .load_sweep import descend as descend
from .load_sweep import sweep as sweep
from .polonsky_keer import solve_polonsky_keer as solve_polonsky_keer
from .rough_contact import RoughContact as RoughContact
from .rough_contact import solve as solve
from .solution import ContactSolution as ContactSolution
