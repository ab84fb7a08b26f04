// aktina._core: what the Python package calls. Arguments arrive checked and in the right type; see python/aktina/.
#include "aktina/base/parallel.h"
#include "arrays.h"
#include "rooms.h"

PYBIND11_MODULE(_core, m) {
  using namespace aktina::python;
  py::class_<Array>(m, "Array", py::buffer_protocol()).def_buffer([](const Array& a) {
    std::vector<py::ssize_t> strides(a.shape.size());
    py::ssize_t stride = a.item_size;
    for (size_t i = a.shape.size(); i-- > 0; stride *= a.shape[i]) strides[i] = stride;
    return py::buffer_info(const_cast<void*>(a.data), a.item_size, a.format, py::ssize_t(a.shape.size()), a.shape,
                           strides, /*readonly=*/true);
  });
  m.attr("version") = AKTINA_VERSION;
  m.def("set_thread_count", &aktina::set_thread_count);
  m.def("thread_count", &aktina::thread_count);
  bind_errors(m);
  bind_catalogue(m);
  bind_illumination(m);
  bind_lights(m);
  bind_images(m);
  bind_shading(m);
  bind_geometry(m);
  bind_form_factors(m);
  bind_view_factors(m);
  bind_scene(m);
  bind_jobs(m);
  bind_lightmaps(m);
  bind_study(m);
  bind_radiosity(m);
}
