"""What the contact with the plate adds to the body's stiffness, the plate at rest.

A node that moves up by du opens its gap and is pushed by N' du less, N' = -dN/dg, and in steady sliding dragged by
μN' du less: the contact's part of the tangent has the entries -∂N/∂u_y = N' and -∂(μN)/∂u_y = μN'. A reduced stiffness
that keeps them answers as if the plate were part of the body (the source's figure 5-10).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from scipy import sparse

if TYPE_CHECKING:
    from softlub.solid.mesh import BodyMesh
    from softlub.solid.plate import PlateForces


def contact_stiffness(mesh: BodyMesh, contact: PlateForces) -> sparse.csr_array:
    """Tangent of the plate's forces on the edge.

    Parameters
    ----------
    mesh : BodyMesh
    contact : PlateForces
        In the state wanted, of `PlateContact.forces`.

    Returns
    -------
    csr_array, shape (2n, 2n)
        Minus the derivative of the plate's forces by the nodes' displacement [N/m²], for
        `ReducedStiffness.of`.
    """
    along, upwards = 2 * mesh.edge, 2 * mesh.edge + 1
    rows = np.concatenate([upwards, along])
    entries = np.concatenate([contact.stiffness, contact.friction * contact.stiffness])
    size = 2 * len(mesh.points)
    return sparse.csr_array((entries, (rows, np.concatenate([upwards, upwards]))), shape=(size, size))
