"""Parts of the facet models: how many facets face which way, how they hide each other, how much they mirror."""
import numpy as np

from . import _core
from ._arrays import number, numbers, spread, unit_vectors


def facet_distribution(name, alpha, width):
    """Facets that face `alpha` off the surface normal.

    name : "phong": cos^c1 alpha; "gaussian": exp(-(c2 alpha)^2); "trowbridge_reitz": [c3^2 / (cos^2 alpha (c3^2 - 1)
        + 1)]^2, all three 1 along the normal (Blinn 1977); "beckmann": exp(-tan^2 alpha / m^2) / (m^2 cos^4 alpha)
        (Cook and Torrance 1981), whose projected facets cover pi.
    alpha : (...,), rad, in [0, pi / 2].  width : c1, c2, c3 or m, positive.
    Returns (...,) float32.
    Raises NoSuchMethod, BadParam.

    >>> import aktina
    >>> float(aktina.facet_distribution("phong", 0, 20))
    1.0
    """
    alpha = numbers("alpha", alpha, np.float32)
    return _each(lambda flat, out: _core.facet_distribution(name, flat, number("width", width, 1e-6), out), alpha)


def groove_masking(n, l, v):
    """Share of facets neither in shadow nor hidden in V-shaped grooves: G of Torrance and Sparrow.

    n, l, v : (..., 3), unit.  Returns (...,) float32, in [0, 1].
    Source: Torrance, Sparrow 1967; Blinn 1977, eq. 10.

    >>> import aktina
    >>> float(aktina.groove_masking([0, 0, 1], [0, 0, 1], [0, 0, 1]))
    1.0
    """
    shape, rows = spread(n=unit_vectors("n", n), l=unit_vectors("l", l), v=unit_vectors("v", v))
    out = np.empty(shape, np.float32)
    _core.groove_masking(*rows, out.reshape(-1))
    return out[()]


def fresnel(cosine, eta):
    """Fresnel reflectance of a dielectric for unpolarised light; 1 where all is reflected.

    cosine : (...,), of the angle of incidence.  eta : index beyond the surface over the index before it, positive.
    Returns (...,) float32, in [0, 1].

    >>> import aktina
    >>> round(float(aktina.fresnel(1, 1.5)), 6)
    0.04
    """
    cosine = numbers("cosine", cosine, np.float32)
    return _each(lambda flat, out: _core.fresnel(flat, number("eta", eta, 1e-6), out), cosine)


def _each(function, values):
    flat = np.ascontiguousarray(values).reshape(-1)
    out = np.empty_like(flat)
    function(flat, out)
    return out.reshape(np.shape(values))[()]
