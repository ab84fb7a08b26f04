#include "aktina/base/method.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "aktina/base/error.h"

namespace aktina {

ParamSet::ParamSet(const MethodInfo& method) : method_(&method) {
  for (const Param& p : method.params) values_.push_back(p.value);
}

size_t ParamSet::index(std::string_view id) const {
  std::string known;
  for (size_t i = 0; i < method_->params.size(); ++i) {
    if (method_->params[i].id == id) return i;
    known += (known.empty() ? "" : ", ") + std::string(method_->params[i].id);
  }
  throw Error(Code::usage, fmt::format("{}.{}", method_->id, id), "no such parameter",
              known.empty() ? "this method has none" : "it has: " + known);
}

void ParamSet::set(std::string_view id, double value) {
  const size_t i = index(id);
  const Param& p = method_->params[i];
  if (!(std::isfinite(value) && value >= p.min && value <= p.max) || (p.whole && value != std::floor(value)))
    throw Error(Code::bad_param, fmt::format("{}.{}", method_->id, id),
                fmt::format("got {:g}{}{}", value, p.unit == "1" ? "" : " ", p.unit == "1" ? "" : p.unit),
                fmt::format("accepted {:g} .. {:g}{}", p.min, p.max, p.whole ? ", whole" : ""));
  values_[i] = value;
}

double ParamSet::operator[](std::string_view id) const { return values_[index(id)]; }

MethodChoice parse_method(std::string_view text) {
  MethodChoice choice;
  const size_t colon = text.find(':');
  choice.id = text.substr(0, colon);
  if (choice.id.empty()) throw Error(Code::usage, std::string(text), "a method's name is missing");
  if (colon == std::string_view::npos) return choice;
  std::string_view rest = text.substr(colon + 1);
  while (true) {
    const size_t comma = rest.find(',');
    const std::string_view item = rest.substr(0, comma);
    const size_t equals = item.find('=');
    double value = 0;
    const char* const end = item.data() + item.size();
    const auto parsed = equals == std::string_view::npos
                            ? std::from_chars_result{item.data(), std::errc::invalid_argument}
                            : std::from_chars(item.data() + equals + 1, end, value);
    if (parsed.ec != std::errc() || parsed.ptr != end)
      throw Error(Code::usage, std::string(text), fmt::format("cannot read '{}'", item),
                  "write METHOD:parameter=number,parameter=number");
    const std::string id(item.substr(0, equals));
    if (std::any_of(choice.values.begin(), choice.values.end(), [&](const auto& v) { return v.first == id; }))
      throw Error(Code::usage, std::string(text), fmt::format("'{}' is given twice", id), "name each parameter once");
    choice.values.emplace_back(id, value);
    if (comma == std::string_view::npos) return choice;
    rest.remove_prefix(comma + 1);
  }
}

void no_such_method(std::string_view family, std::string_view id, std::string_view choices) {
  throw Error(Code::no_such_method, std::string(id), fmt::format("no such {} method", family),
              fmt::format("there are: {}", choices));
}

}  // namespace aktina
