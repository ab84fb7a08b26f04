#include "aktina/base/version.h"

namespace aktina {

std::string_view version() { return AKTINA_VERSION; }

}  // namespace aktina
