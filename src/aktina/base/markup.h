// Text within XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace aktina {

/// The text on one line of valid UTF-8 with <, >, &, " and ' as entities, for content and for attributes.
std::string escaped(std::string_view text);

}  // namespace aktina
