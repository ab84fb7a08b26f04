"""Pictures in files, and how far two are apart."""
import os

import numpy as np

from . import _core
from ._arrays import number
from ._errors import UsageError


def _picture(name, image):
    """(H, W, C) float32, contiguous; (H, W) is one channel. NaN and infinities are let through: metrics count them."""
    try:
        array = np.ascontiguousarray(image, np.float32)
    except (TypeError, ValueError) as error:
        raise UsageError(f"not an array of numbers: {error}", name) from None
    if array.ndim == 2:
        array = array[:, :, np.newaxis]
    if array.ndim != 3 or array.size == 0 or array.shape[2] > 4:
        raise UsageError(f"has shape {array.shape}", name, "(height, width) or (height, width, 1 to 4 channels)")
    return array


def read_image(path):
    """The picture in a PNG, JPEG, WebP, Radiance HDR, OpenEXR or PFM file, whatever its name.

    Returns (H, W, C) float32, linear: 8 and 16 bit colours are decoded from sRGB. C is 1 (grey), 2 (grey and alpha),
    3 (RGB) or 4 (RGBA). Of an OpenEXR file with layers, the picture itself.
    Raises FileError, BadInput (no image, truncated, damaged), LimitExceeded, Unsupported (animations, deep pictures).

    >>> import aktina, os, tempfile
    >>> path = os.path.join(tempfile.mkdtemp(), "half.pfm")
    >>> aktina.write_image(path, [[0.5, 0.25]])
    >>> aktina.read_image(path)[:, :, 0].tolist()
    [[0.5, 0.25]]
    """
    return np.array(_core.read_image(os.fspath(path)))


def write_image(path, image, exposure=1.0, curve="none", bits=8, metadata=None):
    """Writes a picture; the name's extension chooses the format: .png, .exr, .hdr or .pfm. Appears whole or not at all.

    image : (H, W) or (H, W, C), C from 1 to 4, linear.
    exposure : PNG: factor on the values; None: chosen from the picture.
    curve : PNG: "none" (clips at 1), "reinhard" or "filmic".
    bits : PNG: 8 or 16 per channel.
    metadata : dictionary of texts, kept in PNG, EXR and HDR files.
    Raises UsageError (shape, extension, curve), BadParam, FileError.

    >>> import aktina, os, tempfile
    >>> path = os.path.join(tempfile.mkdtemp(), "grey.png")
    >>> aktina.write_image(path, [[0.1, 1.0]], exposure=2, metadata={"Software": "mine"})
    >>> aktina.read_image(path).round(2).tolist()
    [[[0.20000000298023224], [1.0]]]
    """
    if bits not in (8, 16):
        raise UsageError(f"got {bits}", "bits", "8 or 16")
    factor = 0.0 if exposure is None else number("exposure", exposure, np.finfo(np.float32).tiny, 1e30)
    texts = [(str(key), str(value)) for key, value in (metadata or {}).items()]
    _core.write_image(os.fspath(path), _picture("image", image), factor, curve, bits, texts)


def compare(a, b, range="auto"):
    """How far a picture is from a reference: a dictionary of metrics.

    a, b : picture and reference, arrays of the same height and width as read_image gives them; alpha is left out.
    range : "low": both clipped to [0, 1]; "high": all of it; "auto": high if a value is above 1.
    Returns flip (mean FLIP, 0 to 1), rmse, psnr (dB), max_error, relative_mse, ssim, range ("low" or "high"), and
        non_finite_a, non_finite_b: how many values are NaN or infinite and were taken as 0.
    Raises UsageError (shapes).
    Source: Andersson et al. 2020 and 2021 (FLIP), Wang et al. 2004 (SSIM).

    >>> import aktina, numpy
    >>> grey = numpy.full((16, 16, 3), 0.5)
    >>> found = aktina.compare(grey + 0.1, grey)
    >>> round(found["rmse"], 6), round(found["psnr"], 3), aktina.compare(grey, grey)["flip"]
    (0.1, 20.0, 0.0)
    """
    return _core.compare(_picture("a", a), _picture("b", b), range)
