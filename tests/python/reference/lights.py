"""Factors of lights, and the irradiance that lights cast."""
import numpy as np

import aktina

from .cases import FLOAT, Method


def kinds():
    return {
        "spot": [Method("spot_falloff", FLOAT, spot)],
        "attenuation": [Method("attenuation", FLOAT, attenuation)],
        "illuminance_point": [Method("irradiance", FLOAT, point_light)],
        "illuminance_spot": [Method("irradiance", FLOAT, spot_light)],
        "illuminance_directional": [Method("irradiance", FLOAT, directional_light)],
    }


def spot(case):
    given = case.inputs
    factor = aktina.spot_falloff(given["axis"], given["L"], np.radians(given["cutoff_deg"]), exponent=given["p"])
    return {"factor": factor, "I": factor * np.array(given["I0"])}


def attenuation(case):
    given = case.inputs
    d = given["d"]
    cue = {"a0": given["k1"], "a1": given["k2"], "a2": 0}
    light = {"a0": given["c"], "a1": given["l"], "a2": given["q"]}
    return {"f1": aktina.depth_cue(d, given["k1"], given["k2"]), "f1_min1": aktina.attenuation(d, **cue, clamp=True),
            "f2": aktina.attenuation(d, **light), "f2_min1": aktina.attenuation(d, **light, clamp=True)}


def point_light(case):
    given = case.inputs
    light = {"type": "point", "position": given["light_pos"], "intensity": given["intensity"]}
    return {"E": aktina.irradiance(light, given["point"], given["normal"])}


def spot_light(case):
    given = case.inputs
    cutoff = np.radians(given["cutoff_deg"])
    light = {"type": "spot", "position": given["light_pos"], "direction": given["axis"], "exponent": given["p"],
             "intensity": given["intensity"], "inner_angle": cutoff, "outer_angle": cutoff}
    return {"E": aktina.irradiance(light, given["point"], given["normal"])}


def directional_light(case):
    given = case.inputs
    light = {"type": "directional", "direction": given["direction"], "illuminance": given["E0"]}
    return {"E": aktina.irradiance(light, [0, 0, 0], given["normal"])}
