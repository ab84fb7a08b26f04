// aktina methods: the catalogue.
#include <fmt/core.h>

#include "aktina/render/catalogue.h"
#include "session.h"
#include "terminal.h"

namespace aktina::app {
namespace {

std::string listing(const Family& family) {
  std::string text = fmt::format("{}: {}\n  {}\n", family.id, family.title, family.summary);
  for (const MethodInfo* method : family.methods) {
    text += fmt::format("    {:<22} {} [{}]\n", method->id, method->title, method->cite);
    for (const Param& p : method->params)
      text +=
          fmt::format("    {:<22}   {}={:g}  {} ({}, {:g} .. {:g})\n", "", p.id, p.value, p.help, p.unit, p.min, p.max);
  }
  return text;
}

int run(const Arguments& arguments, Session& session) {
  const std::string& chosen = arguments.text("family");
  if (session.json()) {
    print(catalogue_json(chosen));
    return 0;
  }
  std::string text;
  if (chosen.empty())
    for (const Family& family : families()) text += (text.empty() ? "" : "\n") + listing(family);
  else
    text = listing(find_family(chosen));
  print(text);
  return 0;
}

constexpr Option kOptions[] = {
    {.name = "family", .help = "only this family of methods", .kind = Kind::text, .value = "FAMILY"},
};
constexpr Example kExamples[] = {
    {"every method with its parameters", "aktina methods"},
    {"the shading methods for a program to read", "aktina methods --family illumination --json"},
};

}  // namespace

extern constinit const Command methods_command = {
    "methods",
    "list the methods that Aktina knows, with their parameters and sources",
    "Lists each family of methods. A method is chosen by its name, with parameters after a colon: "
    "NAME:parameter=number,parameter=number. The sources are keys of docs/references.bib.",
    {},
    kOptions,
    false,
    kExamples,
    run};

}  // namespace aktina::app
