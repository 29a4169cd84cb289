"""The equivalent stress of von Mises."""

from __future__ import annotations

import numpy as np

from softlub.solid.mesh import FloatArray


def von_mises(stress: FloatArray) -> FloatArray:
    """√(3/2 s : s) with s the deviator of the stress.

    Parameters
    ----------
    stress : ndarray, shape (..., 3, 3)
        Cauchy stress [Pa].

    Returns
    -------
    ndarray, shape (...)
        [Pa]
    """
    mean = np.trace(stress, axis1=-2, axis2=-1)[..., None, None] / 3
    deviator = stress - mean * np.eye(3)
    return np.asarray(np.sqrt(1.5 * np.sum(deviator**2, axis=(-2, -1))))
