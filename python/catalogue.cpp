// The families of methods, as the JSON text that every face of Aktina reads.
#include "aktina/render/catalogue.h"

#include "rooms.h"

namespace aktina::python {

void bind_catalogue(py::module_& m) { m.def("catalogue_json", &catalogue_json); }

}  // namespace aktina::python
