"""From whatever NumPy can read to what the core takes: contiguous rows of one type, checked."""
import numpy as np

from ._errors import BadParam, UsageError


def numbers(name, values, dtype):
    """An array of finite numbers."""
    try:
        array = np.asarray(values, dtype)
    except (TypeError, ValueError) as error:
        raise UsageError(f"not an array of numbers: {error}", name) from None
    if not np.isfinite(array).all():
        raise BadParam("holds NaN or infinity", name)
    return array


def number(name, value, low=-np.inf, high=np.inf):
    """One finite number in [low, high]."""
    array = numbers(name, value, np.float64)
    if array.shape != ():
        raise UsageError(f"has shape {array.shape}", name, "one number")
    if not low <= array <= high:
        raise BadParam(f"got {array}", name, f"accepted {low} .. {high}")
    return float(array)


def rows(name, values, columns, dtype):
    """(..., columns); a single number stands for all columns of a colour."""
    array = numbers(name, values, dtype)
    if array.ndim == 0 or array.shape[-1] != columns:
        raise UsageError(f"has shape {array.shape}", name, f"(..., {columns})")
    return array


def colours(name, values):
    """(..., 3) float32; one number means grey."""
    array = numbers(name, values, np.float32)
    return np.repeat(array[np.newaxis], 3) if array.ndim == 0 else rows(name, array, 3, np.float32)


def unit_vectors(name, values, dtype=np.float32):
    """(..., 3), each of length 1 within 1e-3."""
    array = rows(name, values, 3, dtype)
    if (abs((array * array).sum(-1) - 1) > 2e-3).any():
        raise BadParam("a vector is not of unit length", name, "divide by numpy.linalg.norm")
    return array


def one_vector(name, values, dtype=np.float64):
    """(3,)"""
    array = numbers(name, values, dtype)
    if array.shape != (3,):
        raise UsageError(f"has shape {array.shape}", name, "(3,)")
    return array


def spread(**arrays):
    """Broadcasts the leading axes of (..., columns) arrays: the common shape, and each array as contiguous rows. An
    array that is the same for all samples stays a single row."""
    try:
        shape = np.broadcast_shapes(*(array.shape[:-1] for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise UsageError("leading axes do not broadcast", shapes) from None
    spread_rows = []
    for array in arrays.values():
        columns = array.shape[-1]
        if array.size != columns:
            array = np.broadcast_to(array, (*shape, columns))
        spread_rows.append(np.ascontiguousarray(array.reshape(-1, columns)))
    return shape, spread_rows
