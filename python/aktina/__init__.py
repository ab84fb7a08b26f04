"""Aktina: how light falls on surfaces, and what the eye sees.

Illumination models, shading interpolation, ray tracing and radiosity on NumPy arrays. Lengths are in metres, colours
linear Rec. 709, light in photometric units: radiance cd/m^2, irradiance lx, radiosity lm/m^2, intensity cd. Names of
methods are those of the `aktina` program; `aktina.methods()` lists them.
"""
from ._catalogue import methods
from ._core import set_thread_count, thread_count, version as __version__
from ._errors import (BadInput, BadParam, Cancelled, CheckFailed, Error, FileError, LimitExceeded, NoSuchMethod,
                      Unsupported, UsageError)
from ._facets import facet_distribution, fresnel, groove_masking
from ._form_factors import form_factor, form_factors, polygon_area
from ._geometry import Hits, intersect, mesh_normals, reflect, refract, vertex_normal
from ._illumination import albedo, highlight, illuminate, reciprocity, reflected_share, schlick_power
from ._images import compare, read_image, write_image
from ._lights import attenuation, depth_cue, irradiance, spot_falloff
from ._scene import Lightmap, Scene, Solution, load, load_solution, mix, radiance, trace
from ._shading import arc_angle, fast_phong_series, interpolate, interpolate_cosine, interpolate_samples, slerp
from ._radiosity import solve_radiosity
from ._view_factors import ViewFactors, view_factors

__all__ = [name for name in dir() if not name.startswith("_")]
