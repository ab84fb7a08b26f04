"""View-factor matrices of whole models."""
import json
import os

import numpy as np

from . import _core
from ._arrays import number, numbers
from ._errors import UsageError
from ._scene import Scene


class ViewFactors:
    """What `view_factors` returns: an N x N matrix in compressed rows, with areas, names and its certificate.

    areas : (N,) float64, m^2.   names : list of N texts, the model's own.
    data, indices, indptr : float64, int32, int64: scipy.sparse.csr_array((f.data, f.indices, f.indptr), shape=f.shape).
    errors : float32 in the order of `data`: an estimate of each factor's absolute error.
    transmittances : (N,) float64, or None where all is opaque: F (1 - transmittances) sums to 1 in an enclosure.
    certificate : dict: closure, reciprocity, bounds, errors, the worst rows (docs/view-factors.md).
    """

    def __init__(self, arrays):
        self._arrays = arrays
        self.names = arrays.names
        self.certificate = json.loads(arrays.certificate)
        self.areas, self.data, self.errors = (np.asarray(a) for a in (arrays.areas, arrays.data, arrays.errors))
        transmittances = np.asarray(arrays.transmittances)
        self.transmittances = transmittances if transmittances.size else None
        self.indices = np.asarray(arrays.indices).view(np.int32)
        self.indptr = np.asarray(arrays.indptr).view(np.int64)

    @property
    def shape(self):
        return len(self.areas), len(self.areas)

    @property
    def F(self):
        """(N, N) float64, made at each call: F[i, j] is the fraction of what leaves i that arrives at j."""
        dense = np.zeros(self.shape)
        dense[np.repeat(np.arange(len(self.areas)), np.diff(self.indptr)), self.indices] = self.data
        return dense

    def gray_body(self, emissivity=0.9, temperature=None, flux=None, surroundings=0.0):
        """Exchange of heat between the surfaces, grey and diffuse.

        emissivity : one for all, or (N,), above 0 and at most 1; equal to the absorptance.
        temperature, flux : (N,) or one for all: K, and W/m^2 of net heat that the surface loses (0: adiabatic). Of each
            surface one of the two must be known, NaN stands for what is not; with neither array no balance is made.
        surroundings : K, of what is seen through openings, black.
        Returns a dict: "gebhart" (N, N): the share of what i emits that j absorbs, with all reflections; "script_F"
            (N, N): emissivity times that; "escaped" (N,). With a balance (Oppenheim's network) also "temperatures" K,
            "radiosities" and "fluxes" W/m^2 (N,), and "net" W, what escapes.
        Raises BadParam (an emissivity outside, a surface with both or neither known, a negative temperature, a flux
            that would need one), BadInput (no finite solution), LimitExceeded, UsageError (a shape that does not fit).
        Source: gebhart1961, oppenheim1956.

        >>> import aktina
        >>> quads = [[0, 1, 2], [0, 2, 3]]
        >>> floor = {"vertices": [[0, 0, 0], [9, 0, 0], [9, 9, 0], [0, 9, 0]], "triangles": quads}
        >>> lid = {"vertices": [[0, 0, .01], [0, 9, .01], [9, 9, .01], [9, 0, .01]], "triangles": quads}
        >>> heat = aktina.view_factors(aktina.Scene([floor, lid])).gray_body(0.5, [400, 300])
        >>> round(float(heat["fluxes"][0]), 1)  # 330.8 between endless plates
        332.8
        """
        n = len(self.areas)
        emissivities = self._each("emissivity", numbers("emissivity", emissivity, np.float64))
        known = [self._each(name, np.asarray(np.nan if values is None else values, float))
                 for name, values in (("temperature", temperature), ("flux", flux))]
        result = self._arrays.gray_exchange(emissivities, *known)
        if temperature is not None or flux is not None:
            result |= self._arrays.gray_balance(emissivities, *known,
                                                number("surroundings", surroundings, 0, 1e6))
        found = {name: values if name == "net" else np.asarray(values) for name, values in result.items()}
        for name in ("gebhart", "script_F"):
            found[name] = found[name].reshape(n, n)
        return found

    def _each(self, name, values):
        if values.shape not in ((), self.areas.shape):
            raise UsageError(f"has shape {values.shape}", name, f"one number, or ({len(self.areas)},)")
        return np.ascontiguousarray(np.broadcast_to(values, self.areas.shape))

    def __repr__(self):
        return f"<aktina.ViewFactors: {len(self.areas)} surfaces, {len(self.data)} factors above 0>"


def view_factors(scene, by="face", target_error=1e-4, repair=False, two_sided=False, clear=False, max_memory=0.0,
                 scratch=None, progress=None):
    """View factors between the fronts of all surfaces of a model, which hide each other, with a certificate.

    scene : an aktina.Scene, or the path of a file that `aktina.load` reads, or of a View3D input file (.vs3).
    by : "face": each polygon of the file is a surface; "object": each object; "material": all of one material.
    target_error : wanted absolute error of each factor, 1e-8 .. 0.1.
    repair : make the rows of a closed enclosure sum to 1, keeping reciprocity. Otherwise nothing is normalised.
    two_sided : backs of two-sided materials take part, too: by face as surfaces "NAME/back" of their own.
    clear : light goes straight on through materials with alpha or transmission (by luminance, without textures), and
        arrives both at them and behind them; else they hide all.
    max_memory : GB that the matrix may take; 0: three quarters of the machine's.  scratch : folder for files that hold
        a matrix larger than that while it is in use; None: it is refused.
    progress : called as progress(stage, unit, done, total, seconds) now and then.
    Returns ViewFactors.
    Raises BadInput (no surface with an area; repair of an open scene), BadParam, UsageError, LimitExceeded (memory,
        foreseen), FileError.

    >>> import aktina
    >>> floor = {"vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], "triangles": [[0, 1, 2], [0, 2, 3]]}
    >>> ceiling = {"vertices": [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]], "triangles": [[0, 1, 2], [0, 2, 3]]}
    >>> f = aktina.view_factors(aktina.Scene([floor, ceiling]))
    >>> f.F.round(6).tolist()
    [[0.0, 0.199825], [0.199825, 0.0]]
    >>> f.certificate["closed"]
    False
    """
    if isinstance(scene, Scene):
        surfaces = _core.surfaces_of_scene(scene._scene, by, bool(two_sided), bool(clear))
    else:
        surfaces = _core.surfaces_of_file(os.fspath(scene), by, bool(two_sided), bool(clear))
    return ViewFactors(_core.view_factors(surfaces, number("target_error", target_error, 1e-8, 0.1), bool(repair),
                                          number("max_memory", max_memory, 0, 1e6),
                                          os.fspath(scratch) if scratch else "", progress))
