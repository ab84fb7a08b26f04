"""Form factors from Python: shapes, ways to pass arguments, and what is refused."""
import numpy as np
import pytest

import aktina
from reference.cases import ids

FLOOR = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
CEILING = np.array([[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]])
OPPOSED = 0.19982489569838746  # unit squares a unit apart; J. Howell's catalogue, C-11
ACROSS = [[-1, -1, 0.5], [2, -1, 0.5], [2, 2, 0.5], [-1, 2, 0.5]]
HERE = {"type": "point", "position": [0.5, 0.5, 0], "normal": [0, 0, 1]}
METHODS = ids("formfactor")


def cube():
    x, y, z = np.eye(3)
    walls = [(0 * x, x, y), (z, y, x), (0 * x, y, z), (x, z, y), (0 * x, z, x), (y, x, z)]
    return [np.array([p, p + u, p + u + v, p + v]) for p, u, v in walls]


@pytest.mark.parametrize("method", METHODS)
def test_every_method_agrees_with_the_closed_form(method):
    assert aktina.form_factor(FLOOR, CEILING, method=method) == pytest.approx(OPPOSED, abs=5e-3)
    F, errors = aktina.form_factors([FLOOR, CEILING], method=method)
    assert F.shape == errors.shape == (2, 2) and F.dtype == errors.dtype == np.float64
    assert (errors >= 0).all() and F[0, 0] == F[1, 1] == 0
    np.testing.assert_allclose(F[[0, 1], [1, 0]], OPPOSED, atol=5e-3)


def test_what_is_closed_sums_to_one_and_is_reciprocal():
    F, _ = aktina.form_factors(cube())
    np.testing.assert_allclose(F.sum(axis=1), 1, atol=1e-9)
    np.testing.assert_allclose(F, F.T, atol=1e-9)


def test_surfaces_hide_each_other_and_occluders_on_both_sides():
    assert aktina.form_factor(FLOOR, CEILING, occluders=[ACROSS]) == pytest.approx(0, abs=1e-8)
    assert aktina.form_factor(HERE, CEILING, occluders=[ACROSS[::-1]]) == pytest.approx(0, abs=1e-8)
    F, _ = aktina.form_factors([FLOOR, CEILING, ACROSS])
    assert F[0, 1] == pytest.approx(0, abs=1e-8) and F[0, 2] == 0, "ACROSS turns its back to the floor"
    alone, _ = aktina.form_factors([FLOOR, CEILING], [ACROSS])
    np.testing.assert_allclose(alone, 0, atol=1e-8)


@pytest.mark.parametrize("convert", [np.ndarray.tolist, np.float32, np.int64, np.asfortranarray,
                                     lambda a: np.repeat(a, 2, axis=0)[::2], lambda a: tuple(map(tuple, a))])
def test_vertices_come_in_any_form_numpy_takes(convert):
    assert aktina.form_factor(convert(FLOOR), convert(CEILING)) == pytest.approx(OPPOSED, abs=1e-12)
    F, _ = aktina.form_factors(iter([convert(FLOOR), convert(CEILING)]), occluders=())
    assert F[0, 1] == pytest.approx(OPPOSED, abs=1e-12)


def test_no_surfaces_make_an_empty_matrix():
    F, errors = aktina.form_factors([])
    assert F.shape == errors.shape == (0, 0)


def test_parameters_follow_the_method():
    rough, fine = (aktina.form_factor(FLOOR, CEILING, f"monte_carlo:samples={n}") for n in (16, 1 << 16))
    assert abs(fine - OPPOSED) < 2e-3 and rough != fine
    again = aktina.form_factor(FLOOR, CEILING, "monte_carlo:samples=16")
    assert rough == again, "the same seed gives the same number"
    assert rough != aktina.form_factor(FLOOR, CEILING, "monte_carlo:samples=16,seed=1")


def test_points_see_polygons_discs_and_spheres():
    corner = np.arctan(0.5 / np.sqrt(1.25)) / np.sqrt(5)  # each quarter of the square: B-4 of the catalogue
    assert aktina.form_factor(HERE, CEILING) == pytest.approx(4 * corner / np.pi, abs=1e-12)
    # a disc overhead: r^2 / (r^2 + h^2); a sphere overhead: (r / h)^2
    disc = {"type": "disc", "centre": [0.5, 0.5, 3], "normal": [0, 0, -1], "radius": 1}
    assert aktina.form_factor(HERE, disc) == pytest.approx(0.1, abs=1e-12)
    assert aktina.form_factor(HERE, {**disc, "normal": [0, 0, 1]}) == 0, "its back"
    sphere = {"type": "sphere", "centre": [0.5, 0.5, 2], "radius": 1}
    assert aktina.form_factor(HERE, sphere) == pytest.approx(0.25, abs=1e-12)


REFUSED = [
    (aktina.UsageError, FLOOR[:, :2], CEILING, {}),
    (aktina.UsageError, FLOOR[0], CEILING, {}),
    (aktina.UsageError, FLOOR[np.newaxis], CEILING, {}),
    (aktina.UsageError, "floor", CEILING, {}),
    (aktina.BadParam, None, CEILING, {}),
    (aktina.UsageError, HERE, {"type": "cube"}, {}),
    (aktina.UsageError, {"type": "point", "position": [0, 0, 0]}, CEILING, {}),
    (aktina.UsageError, {**HERE, "colour": 1}, CEILING, {}),
    (aktina.BadParam, {**HERE, "normal": [0, 0, 7]}, CEILING, {}),
    (aktina.UsageError, FLOOR, {"type": "sphere", "radius": 1}, {}),
    (aktina.Unsupported, {"type": "disc", "centre": [0, 0, 0], "normal": [0, 0, 1], "radius": 1},
     {"type": "disc", "centre": [1, 0, 1], "normal": [0, 0, -1], "radius": 1}, {}),
    (aktina.BadInput, FLOOR[:2], CEILING, {}),
    (aktina.BadInput, FLOOR * 0, CEILING, {}),
    (aktina.BadInput, FLOOR + [[0, 0, 0], [0, 0, 0], [0, 0, 0.5], [0, 0, 0]], CEILING, {}),
    (aktina.BadParam, FLOOR * np.nan, CEILING, {}),
    (aktina.BadInput, FLOOR, CEILING, {"occluders": [FLOOR[:2]]}),
    (aktina.NoSuchMethod, FLOOR, CEILING, {"method": "guess"}),
    (aktina.BadParam, FLOOR, CEILING, {"method": "hemicube:resolution=0"}),
    (aktina.Error, FLOOR, CEILING, {"method": "hemicube:samples=4"}),
]


@pytest.mark.parametrize("error, a, b, options", REFUSED)
def test_what_is_refused(error, a, b, options):
    with pytest.raises(error) as caught:
        aktina.form_factor(a, b, **options)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("method", METHODS)
def test_a_hole_is_reached_by_a_bridge(method):
    def square(half, z):
        return [[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]]
    outer, inner = square(1, 0), square(0.5, 0)
    frame = outer + outer[:1] + [inner[0]] + inner[:0:-1] + [inner[0]]
    above = square(1, 1)[::-1]
    assert aktina.polygon_area(frame) == 3

    def seen(from_above):
        return aktina.form_factors([above, from_above], method=method)[0][0, 1]
    assert seen(frame) == pytest.approx(seen(outer) - seen(inner), abs=2e-3)
    # Through the hole, and past the frame.
    low, high = square(0.3, -1), square(0.3, 1)[::-1]
    through = aktina.form_factors([high, low, frame, frame[::-1]], method=method)[0][0, 1]
    alone = aktina.form_factors([high, low], method=method)[0][0, 1]
    assert through == pytest.approx(alone, abs=2e-3)
    wide, far = square(1, 1)[::-1], square(1, -1)
    past = aktina.form_factors([wide, far, frame], method=method)[0][0, 1]
    assert past == pytest.approx(0.1005, abs=1e-2), "4 million rays: 0.1005"


def test_the_matrix_refuses_the_same_and_too_many():
    with pytest.raises(aktina.BadInput, match="surface 1"):
        aktina.form_factors([FLOOR, FLOOR * 0])
    with pytest.raises(aktina.NoSuchMethod):
        aktina.form_factors([FLOOR], method="guess")
    with pytest.raises(aktina.LimitExceeded, match="20000"):
        aktina.form_factors([FLOOR] * 20001)


def test_progress_is_reported_and_what_it_raises_stops_the_work():
    seen = []
    aktina.form_factors(cube(), progress=lambda *state: seen.append(state))
    stage, unit, done, total, seconds = seen[-1]
    assert (stage, unit, total) == ("form factors", "rows", 6) and done <= total and seconds >= 0

    def stop(*_):
        raise RuntimeError("enough")
    with pytest.raises(RuntimeError, match="enough"):
        aktina.form_factors(cube() * 20, method="ray_cast", progress=stop)


def test_areas():
    assert aktina.polygon_area(FLOOR) == 1 and aktina.polygon_area(FLOOR[::-1]) == 1
    assert aktina.polygon_area([[0, 0, 0], [4, 0, 0], [1, 1, 0], [0, 4, 0]]) == 4, "concave"


def test_normals_that_are_unit_to_single_precision():
    random = np.random.default_rng(1)
    for _ in range(50):
        n = random.normal(size=3)
        n = (n / np.linalg.norm(n)).astype(np.float32).astype(float)
        disc = {"type": "disc", "centre": n, "normal": -n, "radius": 1}
        assert aktina.form_factor({"type": "point", "position": [0, 0, 0], "normal": n}, disc) == pytest.approx(0.5, abs=1e-6)


def test_discs_all_but_touching():
    lower = {"type": "disc", "centre": [0, 0, 0], "normal": [0, 0, 1], "radius": 4776.2}
    upper = {"type": "disc", "centre": [0, 0, 1.07e-8], "normal": [0, 0, -1], "radius": 5356.98}
    assert 1 - 1e-12 < aktina.form_factor(lower, upper) <= 1


def test_a_long_wall_and_its_short_end():
    wall = [[0, 0, 0], [0, 0, 1000], [1, 0, 1000], [1, 0, 0]]
    end = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    exact = aktina.form_factor(wall, end)
    assert exact == pytest.approx(2.5e-4, rel=1e-3)
    assert aktina.form_factor(wall, end, method="cubature") == pytest.approx(exact, rel=1e-4)
