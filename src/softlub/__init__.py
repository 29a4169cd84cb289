"""Friction and film thickness of lubricated soft contacts, over the whole Stribeck curve.

Conventions, stated once: SI units inside; pressures are positive in compression; the smooth rigid wall moves
in +x at speed v below the body at rest; the gap is called separation (its mean over the roughness);
``modulus`` without a further word is the plane-strain modulus E* = E/(1 - nu²) of the one elastic body.
"""

__version__ = "0.1.0"
