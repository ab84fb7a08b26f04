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

void models() {
  constexpr size_t kPoints = 4096;
  struct alignas(64) Arrays {
    float position[3][kPoints], normal[3][kPoints], diffuse[3][kPoints], specular[3][kPoints];
  };
  static Arrays a;
  for (size_t i = 0; i < kPoints; ++i) {
    const float angle = float(i) * 1e-3f;
    a.position[0][i] = angle, a.normal[0][i] = std::sin(angle) * 0.5f, a.normal[2][i] = 1;
  }
  family("illumination", illumination_models(), "lambert", 5, [](const std::string& method) {
    const Light lamp = PointLight{{1, 2, 3}, Intensity(Rgb(10)), {}};
    const Illuminator light(make_method(illumination_models(), "illumination", method),
                            {.ks = Rgb(0.4f), .exponent = 30}, std::span(&lamp, 1), Rgb(0.1f), {{0, 0, 5}, false});
    const PointArrays points{
        kPoints, {a.position[0], a.position[1], a.position[2]}, {a.normal[0], a.normal[1], a.normal[2]}};
    for (int i = 0; i < 20; ++i)
      light.evaluate(points,
                     {{a.diffuse[0], a.diffuse[1], a.diffuse[2]}, {a.specular[0], a.specular[1], a.specular[2]}});
    sink = a.diffuse[0][7];
  });
}

void vertex_normals() {
  std::vector<FacetCorner> fan;
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
      const Ray ray{{0.278f, 0.273f, 0.8f}, {float(i % 141) / 300 - 0.2f, float(i / 141) / 300 - 0.2f, -1}};
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
    const double x = i % 4, y = i / 4;
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
  family("specular", specular_methods(), "two_pass", 2, [&](const std::string&) {
    sink = render_two_pass(scene, solution, scene.cameras[0], 64, 64, {.samples = 4, .seed = 0, .each_pass = {}})
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
