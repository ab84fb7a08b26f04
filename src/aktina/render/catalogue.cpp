#include "aktina/render/catalogue.h"

#include <nlohmann/json.hpp>

#include "aktina/base/error.h"
#include "aktina/illumination/light/light.h"
#include "aktina/illumination/model.h"
#include "aktina/illumination/normals/normals.h"
#include "aktina/radiosity/formfactor/formfactor.h"
#include "aktina/radiosity/mesher/mesher.h"
#include "aktina/radiosity/solver/solver.h"
#include "aktina/radiosity/specular/specular.h"
#include "aktina/raster/shading/shading_method.h"
#include "aktina/trace/accelerator/accelerator.h"
#include "aktina/trace/integrator/integrator.h"
#include "aktina/trace/primitive/primitive.h"

namespace aktina {
namespace {

template <class Product>
std::vector<const MethodInfo*> rows(std::span<const Method<Product>* const> table) {
  std::vector<const MethodInfo*> rows;
  for (const Method<Product>* row : table) rows.push_back(&row->info);
  return rows;
}

nlohmann::ordered_json to_json(const Param& p) {
  return {{"id", p.id},       {"help", p.help},   {"unit", p.unit},  {"default", p.value},
          {"minimum", p.min}, {"maximum", p.max}, {"whole", p.whole}};
}

nlohmann::ordered_json to_json(const MethodInfo& method) {
  auto params = nlohmann::ordered_json::array();
  for (const Param& p : method.params) params.push_back(to_json(p));
  return {{"id", method.id},
          {"title", method.title},
          {"summary", method.summary},
          {"cite", method.cite},
          {"parameters", std::move(params)}};
}

nlohmann::ordered_json to_json(const Family& family) {
  auto methods = nlohmann::ordered_json::array();
  for (const MethodInfo* method : family.methods) methods.push_back(to_json(*method));
  return {{"id", family.id},
          {"title", family.title},
          {"summary", family.summary},
          {"folder", family.folder},
          {"methods", std::move(methods)}};
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> table = {
      {"light", "Light sources", "What arrives at a point, and from where.", "illumination/light", rows(lights())},
      {"illumination", "Illumination models", "How a surface reflects light from one direction into another.",
       "illumination", rows(illumination_models())},
      {"formfactor", "Form factors", "What fraction of the light leaving one polygon arrives at another.",
       "radiosity/formfactor", rows(formfactors())},
      {"mesher", "Meshers", "How surfaces are cut into patches that light is computed on.", "radiosity/mesher",
       rows(meshers())},
      {"normals", "Vertex normals", "How the facets around a vertex make up its normal.", "illumination/normals",
       rows(normals())},
      {"shading", "Shading interpolation", "How light is carried from the corners of a triangle into its inside.",
       "raster/shading", rows(shading_methods())},
      {"primitive", "Analytic shapes", "What rays meet without triangles.", "trace/primitive", rows(primitives())},
      {"accelerator", "Accelerators", "How the first thing that a ray meets is found.", "trace/accelerator",
       rows(accelerators())},
      {"integrator", "Integrators", "How light is gathered along the rays of a picture.", "trace/integrator",
       rows(integrators())},
      {"radiosity", "Radiosity solvers", "How the light between diffuse surfaces is balanced.", "radiosity/solver",
       rows(solvers())},
      {"specular", "Specular light with radiosity", "How mirrors and glass come into a picture of a solution.",
       "radiosity/specular", rows(specular_methods())},
  };
  return table;
}

const Family& find_family(std::string_view id) {
  std::string known;
  for (const Family& family : families()) {
    if (family.id == id) return family;
    known += (known.empty() ? "" : ", ") + std::string(family.id);
  }
  throw Error(Code::no_such_method, std::string(id), "no such family of methods", "there are: " + known);
}

const MethodInfo& find_method(const Family& family, std::string_view id) {
  std::string known;
  for (const MethodInfo* method : family.methods) {
    if (method->id == id) return *method;
    known += (known.empty() ? "" : ", ") + std::string(method->id);
  }
  no_such_method(family.id, id, known);
}

std::string catalogue_json(std::string_view family) {
  auto list = nlohmann::ordered_json::array();
  if (family.empty())
    for (const Family& row : families()) list.push_back(to_json(row));
  else
    list.push_back(to_json(find_family(family)));
  return nlohmann::ordered_json{{"schema_version", 1}, {"families", std::move(list)}}.dump(2) + "\n";
}

}  // namespace aktina
