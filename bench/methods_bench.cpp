// What each method of a family costs beside the family's plainest: the same small work done by every row of its table.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "aktina/illumination/illuminator.h"
#include "aktina/illumination/normals/normals.h"
#include "aktina/import/import.h"
#include "aktina/radiosity/formfactor/formfactor.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solve.h"
#include "aktina/radiosity/solver/solver.h"
#include "aktina/radiosity/specular/specular.h"
#include "aktina/trace/accelerator/accelerator.h"
#include "aktina/trace/integrator/integrator.h"
#include "aktina/trace/primitive/primitive.h"
#include "aktina/trace/trace.h"
#include "bench/report.h"

namespace {

using namespace aktina;

/// Times `work` with each row of a table, in turn with the row called `base`.
template <class Row>
void family(const std::string& id, std::span<const Row* const> table, std::string_view base, int rounds,
            const std::function<void(const std::string& method)>& work) {
  for (const Row* row : table) {
    const std::string method(row->info.id), plain(base);
    const auto t = bench::race(rounds, {[&] { work(method); }, [&] { work(plain); }});
    bench::report(fmt::format("{}.{}.{}", id, method, plain), fmt::format("{}: time over {}'s", row->info.title, plain),
                  t[0] / t[1], "x");
  }
}

volatile float sink;  // what is computed is used

void lamps() {
  family("light", lights(), "point", 5, [](const std::string& method) {
    const Light light = make_method(lights(), "light", method);
    float sum = 0;
    for (int i = 0; i < 200000; ++i) sum += sample(light, Point3(float(i) * 1e-3f, 1, 2)).e_perp.v.g;
    sink = sum;
  });
}

struct LitPoints {
  static constexpr size_t kCount = 4096;
  alignas(64) float position[3][kCount], normal[3][kCount], diffuse[3][kCount], specular[3][kCount];
  LitPoints() {
    for (size_t i = 0; i < kCount; ++i) {
      const float angle = float(i) * 1e-3f;
      for (int k = 0; k < 3; ++k) position[k][i] = k == 0 ? angle : 0;
      const Vec3 n = normalize(Vec3(std::sin(angle) * 0.5f, 0, 1));
      for (int k = 0; k < 3; ++k) normal[k][i] = n[k];
    }
  }
  PointArrays points() const {
    return {kCount, {position[0], position[1], position[2]}, {normal[0], normal[1], normal[2]}};
  }
  LitArrays lit() { return {{diffuse[0], diffuse[1], diffuse[2]}, {specular[0], specular[1], specular[2]}}; }
  Vec3 at(const float (&v)[3][kCount], size_t i) const { return {v[0][i], v[1][i], v[2][i]}; }
};

Illuminator illuminator(const std::string& method, const Light& lamp) {
  return {make_method(illumination_models(), "illumination", method),
          {.ks = Rgb(0.4f), .exponent = 30, .roughness = 0.5f},
          std::span(&lamp, 1),
          Rgb(0.1f),
          {{0, 0, 5}, false}};
}

/// The readable equation, point by point.
void light_each(const Illuminator& light, const LitPoints& p) {
  Rgb sum;
  for (size_t i = 0; i < LitPoints::kCount; ++i) {
    const Point3 x = p.at(p.position, i);
    sum += illuminate(light.model(), light.surface(), light.lights(), light.ambient(), x, p.at(p.normal, i),
                      light.viewer().towards(x))
               .total();
  }
  sink = sum.g;
}

void models() {
  static LitPoints p;
  const Light lamp = PointLight{{1, 2, 3}, Intensity(Rgb(10)), {}};
  family("illumination", illumination_models(), "lambert", 5, [&](const std::string& method) {
    const Illuminator light = illuminator(method, lamp);
    for (int i = 0; i < 20; ++i) light.evaluate(p.points(), p.lit());
    sink = p.diffuse[0][7];
  });
  for (const std::string method :
       {"constant", "ambient", "lambert", "oren_nayar", "phong", "phong:fresnel=1", "blinn_phong", "schlick",
        "torrance_sparrow:distribution=0", "torrance_sparrow:distribution=1", "torrance_sparrow:distribution=2",
        "torrance_sparrow:distribution=3", "cook_torrance", "ward", "ggx"}) {
    const Illuminator light = illuminator(method, lamp);
    const auto t = bench::race(5, {[&] { light_each(light, p); }, [&] { light.evaluate(p.points(), p.lit()); }});
    bench::report("illumination." + method + ".simd", "time of the scalar form over the SIMD form's", t[0] / t[1], "x");
  }
}

void vertex_normals() {
  std::vector<FacetCorner> fan;
  fan.reserve(6);
  for (int i = 0; i < 6; ++i)
    fan.push_back({{std::cos(i), std::sin(i), -0.2}, {std::cos(i + 1), std::sin(i + 1), -0.2}});
  family("normals", normals(), "area", 5, [&](const std::string& method) {
    const FacetWeighting weighting = make_method(normals(), "normals", method);
    double sum = 0;
    for (int i = 0; i < 50000; ++i) sum += vertex_normal(weighting, fan).z;
    sink = float(sum);
  });
}

void shapes() {
  family("primitive", primitives(), "sphere", 5, [](const std::string& method) {
    const Primitive shape = make_method(primitives(), "primitive", method);
    double sum = 0;
    for (int i = 0; i < 200000; ++i)
      if (const auto hit = intersect(shape, {{-3, 0.01 * (i % 100), 0.2}, {1, -0.002 * (i % 97), 0}})) sum += hit->t;
    sink = float(sum);
  });
}

void accelerating(const Scene& scene) {
  family("accelerator", accelerators(), "embree", 3, [&](const std::string& method) {
    const auto accelerator = make_method(accelerators(), "accelerator", method);
    accelerator->build(scene);
    float sum = 0;
    for (int i = 0; i < 20000; ++i) {
      const int column = i % 141, row = i / 141;
      const Ray ray{{0.278f, 0.273f, 0.8f}, {float(column) / 300 - 0.2f, float(row) / 300 - 0.2f, -1}};
      sum += accelerator->intersect(ray).distance;
    }
    sink = sum;
  });
}

void integrating(const Scene& scene) {
  family("integrator", integrators(), "direct", 3, [&](const std::string& method) {
    TraceOptions options;
    options.integrator = method, options.samples = 16;
    sink = trace(scene, scene.cameras[0], 96, 96, options).layers[0].image.pixels[0];
  });
}

void between_polygons() {
  FormFactorScene scene;
  for (int i = 0; i < 12; ++i) {
    const int column = i % 4, row = i / 4;
    const double x = column, y = row;
    scene.surfaces.push_back({{{x, y, 0}, {x + 1, y, 0}, {x + 1, y + 1, 0}, {x, y + 1, 0}}});
    scene.surfaces.push_back({{{x, y, 2}, {x, y + 1, 2}, {x + 1, y + 1, 2}, {x + 1, y, 2}}});
  }
  family("formfactor", formfactors(), "analytic", 2, [&](const std::string& method) {
    const auto estimator = make_method(formfactors(), "formfactor", method);
    estimator->build(scene);
    sink = float(estimator->row(0).factors[1]);
  });
}

RadiosityOptions coarse() {
  RadiosityOptions options;
  options.patch_size = 0.15, options.tolerance = 0.01;
  return options;
}

void balancing(const Scene& scene) {
  family("mesher", meshers(), "uniform", 2, [&](const std::string& method) {
    RadiosityOptions options = coarse();
    options.mesher = method, options.most_steps = 1;
    sink = float(solve_radiosity(scene, options).mesh.size());
  });
  family("radiosity", solvers(), "progressive", 2, [&](const std::string& method) {
    RadiosityOptions options = coarse();
    options.solver = method;
    sink = float(solve_radiosity(scene, options).steps);
  });
  const Solution solution = solve_radiosity(scene, coarse());
  family("specular", specular_methods(), "two_pass", 2, [&](const std::string& method) {
    sink = render_two_pass(scene, solution, scene.cameras[0], 64, 64,
                           {.method = method, .samples = 4, .seed = 0, .each_pass = {}})
               .layers[0]
               .image.pixels[0];
  });
}

}  // namespace

int main() {
  const Scene cornell = load_scene(std::string(AKTINA_SOURCE_DIR) + "/scenes/cornell.glb");
  lamps(), models(), vertex_normals(), shapes();
  accelerating(cornell), integrating(cornell), between_polygons(), balancing(cornell);
}
