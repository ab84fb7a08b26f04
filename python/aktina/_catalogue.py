"""What methods there are."""
import json

from . import _core


def methods(family=None):
    """Every method Aktina has: dictionaries with family, id, title, summary, cite (key in docs/references.bib) and
    parameters (each with id, help, unit, default, minimum, maximum, whole).

    family : such as "illumination"; None: all of them.
    A method is chosen by its id, its parameters after a colon: "hemicube:resolution=256".
    Raises NoSuchMethod, listing the families.

    >>> import aktina
    >>> [method["id"] for method in aktina.methods("illumination")][:2]
    ['constant', 'ambient']
    """
    catalogue = json.loads(_core.catalogue_json(family or ""))
    return [{"family": row["id"], **method} for row in catalogue["families"] for method in row["methods"]]
