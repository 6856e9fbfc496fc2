"""Limits of line contact with full slip over the traction coefficient, in terms of the shear yield stress k.

Plane strain, Poisson's ratio 0.3, von Mises' yield condition. Elastic limit: the first yield under the stresses of
the elastic half-space (Johnson, Contact Mechanics, 1985, sections 4.2 and 7.1). Shakedown: the largest load for which
residual stresses that equilibrium admits (along and across, of depth alone) keep all points within the yield condition
(Melan's theorem; section 9.2), the least over depth. Up to a traction of about 0.3 that is where the shear stress below
the surface reaches k, from there on the surface governs.
"""

import style

TRACTION = [0, 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45, 0.5, 0.55, 0.6]
ELASTIC = [3.107, 3.096, 3.063, 3.009, 2.936, 2.843, 2.598, 2.342, 2.123, 1.937, 1.777, 1.640, 1.521]
SHAKEDOWN = [4.000, 3.772, 3.564, 3.375, 3.202, 3.044, 2.900, 2.615, 2.316, 2.077, 1.882, 1.720, 1.583]


def draw(axes):
    """The limits and what lies between them."""
    axes.plot(TRACTION, ELASTIC, color=style.GREEN, label="first yield")
    axes.plot(TRACTION, SHAKEDOWN, color=style.ORANGE, label="shakedown")
    axes.fill_between(TRACTION, ELASTIC, SHAKEDOWN, color=style.ORANGE, alpha=0.12)
    axes.text(0.02, 1.5, "elastic", color=style.GREY)
    axes.text(0.02, 3.2, "shakes down", color=style.GREY)
    axes.text(0.36, 3.6, "ratchets, or alternating plasticity", color=style.GREY)
    axes.set_xlabel("traction coefficient (longitudinal over vertical force)")
    axes.set_ylabel("peak pressure / k")
    axes.grid(True)
