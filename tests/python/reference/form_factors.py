"""Form factors of polygons by each method, and of simple shapes in closed form."""
import numpy as np

import aktina

from .cases import ANALYTIC, SAMPLED, Method, ids

EXACT = ("contour",)  # held to the analytic tolerance
# What is smaller than a sample's share is not seen.
BY_SOLID_ANGLE = ("hemicube", "monte_carlo", "hemisphere", "cubic_tetrahedron")
PARTIAL = ("single_plane",)  # loses what is beside its plane: no claim on a value


def kinds():
    polygons = [Method(id, ANALYTIC if id in EXACT else SAMPLED, lambda case, id=id: between_polygons(id, case),
                       lambda case, id=id: id not in BY_SOLID_ANGLE or not far_away(case))
                for id in ids("formfactor") if id not in PARTIAL]
    points = [Method(id, ANALYTIC if id in (*EXACT, "analytic", "cubature") else SAMPLED, lambda case, id=id: from_point(id, case),
                     lambda case, id=id: id not in BY_SOLID_ANGLE or not far_away(case))
              for id in ids("formfactor") if id not in PARTIAL]
    shapes = {"point_disc": point_disc, "disc_disc_coaxial": coaxial_discs, "point_sphere": point_sphere,
              "concentric_spheres": spheres, "sphere_interior_band": band, "spherical_cap_base": cap,
              "illuminance_rect_luminaire": luminaire}
    return {"polygon_polygon": polygons, "polygon_polygon_occluded": polygons,
            "point_polygon": points, "point_polygon_occluded": points,
            **{kind: [Method("form_factor", ANALYTIC, compute)] for kind, compute in shapes.items()}}


def far_away(case):
    """Whether only relative accuracy of a tiny factor is asked for."""
    return case.tolerance_sampled["abs"] == 0 and any(0 < case.expected.get(key, 0) < 1e-5 for key in ("F", "F_AB", "F_BA"))


def between_polygons(method, case):
    a, b, occluders = (case.inputs[name] for name in ("A", "B", "occluders"))
    values = {"F_AB": aktina.form_factor(a, b, method, occluders), "F_BA": aktina.form_factor(b, a, method, occluders),
              "area_A": aktina.polygon_area(a), "area_B": aktina.polygon_area(b)}
    if "F_AB_unoccluded" in case.expected:
        values["F_AB_unoccluded"] = aktina.form_factor(a, b, method)
    return values


def point(given):
    return {"type": "point", "position": given["point"], "normal": given["normal"]}


def from_point(method, case):
    return {"F": aktina.form_factor(point(case.inputs), case.inputs["B"], method, case.inputs["occluders"])}


def point_disc(case):
    given = case.inputs
    disc = {"type": "disc", "centre": given["disc_centre"], "normal": given["disc_normal"], "radius": given["radius"]}
    return {"F": aktina.form_factor(point(given), disc)}


def coaxial_discs(case):
    given = case.inputs
    lower = {"type": "disc", "centre": [0, 0, 0], "normal": [0, 0, 1], "radius": given["r1"]}
    upper = {"type": "disc", "centre": [0, 0, given["distance"]], "normal": [0, 0, -1], "radius": given["r2"]}
    return {"F_12": aktina.form_factor(lower, upper), "F_21": aktina.form_factor(upper, lower)}


def point_sphere(case):
    given = case.inputs
    angle = np.radians(given["angle_deg"])
    here = {"type": "point", "position": [0, 0, 0], "normal": [np.sin(angle), 0, np.cos(angle)]}
    return {"F": aktina.form_factor(here, {"type": "sphere", "centre": [0, 0, given["distance"]],
                                           "radius": given["radius"]})}


def spheres(case):
    inner = {"type": "sphere", "radius": case.inputs["r1"]}
    outer = {"type": "sphere", "radius": case.inputs["r2"], "inside": True}
    return {"F_12": aktina.form_factor(inner, outer), "F_21": aktina.form_factor(outer, inner),
            "F_22": aktina.form_factor(outer, outer, occluders=[inner])}


def band(case):
    given = case.inputs
    sphere = {"type": "sphere", "radius": given["radius"], "inside": True}
    strip = {"type": "sphere_band", "radius": given["radius"], "from": np.radians(given["theta1_deg"]),
             "to": np.radians(given["theta2_deg"])}
    factor = aktina.form_factor(sphere, strip)
    return {"F": factor, "A_j": factor * 4 * np.pi * given["radius"] ** 2}


def cap(case):
    size = {"radius": case.inputs["radius"], "half_angle": np.radians(case.inputs["half_angle_deg"])}
    dome, base = {"type": "cap", **size}, {"type": "cap_base", **size}
    return {"F_cap_cap": aktina.form_factor(dome, dome), "F_cap_base": aktina.form_factor(dome, base),
            "F_base_cap": aktina.form_factor(base, dome)}


def luminaire(case):
    factor = aktina.form_factor(point(case.inputs), case.inputs["vertices"])
    return {"F": factor, "E": np.pi * factor * np.array(case.inputs["luminance"])}
