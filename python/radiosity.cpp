// Radiosity of patches whose form factors are known.
#include <algorithm>

#include "aktina/radiosity/solver/solver.h"
#include "arrays.h"
#include "rooms.h"
#include "work.h"

namespace aktina::python {
namespace {

void solve_system(const std::string& method, const py::buffer& factors, const py::buffer& emissions,
                  const py::buffer& reflectances, const py::buffer& radiosities, double tolerance,
                  const py::object& report) {
  const Rows<const double> f(factors, 1, "F"), e(emissions, 1, "E"), rho(reflectances, 1, "rho");
  const Rows<double> b(radiosities, 1, "B");
  RadiositySystem system;
  while (system.patches * system.patches < f.size()) ++system.patches;
  system.bands = system.patches > 0 ? b.size() / system.patches : 1;
  system.factors = f.values(), system.emissions = e.values(), system.reflectances = rho.values();
  const std::vector<double> result =
      run(report, [&](Progress& progress) { return solve_radiosity_system(system, method, tolerance, &progress); });
  std::copy(result.begin(), result.end(), b.data());
}

}  // namespace

void bind_radiosity(py::module_& m) { m.def("solve_radiosity", &solve_system); }

}  // namespace aktina::python
