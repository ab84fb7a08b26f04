// Rays against single shapes, and the normal of one vertex: pure functions in double precision.
#include <cmath>
#include <functional>
#include <limits>

#include "aktina/illumination/normals/normals.h"
#include "aktina/scene/mesh.h"
#include "aktina/trace/primitive/primitive.h"
#include "aktina/trace/refract.h"
#include "arrays.h"
#include "fields.h"
#include "primitive_dict.h"
#include "rooms.h"

namespace aktina::python {
namespace {

using Shape = std::function<std::optional<SurfaceHit>(const Line&)>;

/// {"type": "plane", "normal": ..., "d": ...} and so on: whatever a line can meet.
Shape shape_from(const py::dict& dict) {
  std::string type;
  FromDict field(dict, "shape");
  field("type", type);
  Shape shape;
  if (type == "plane") {
    Vec3d normal(0, 1, 0);
    double d = 0;
    field("normal", normal), field("d", d);
    shape = [=](const Line& line) { return intersect_plane(line, normal, d); };
  } else if (type == "sphere") {
    Point3d centre(0);
    double radius = 1;
    field("centre", centre), field("radius", radius);
    shape = [=](const Line& line) { return intersect_sphere(line, centre, radius); };
  } else if (type == "triangle" || type == "polygon") {
    std::vector<Point3d> corners;
    field("vertices", corners);
    if (corners.size() < 3 || (type == "triangle" && corners.size() != 3))
      throw Error(Code::usage, "shape.vertices", fmt::format("has {} corners", corners.size()));
    if (type == "polygon")
      shape = [=](const Line& line) { return intersect_polygon(line, corners); };
    else
      shape = [=](const Line& line) { return intersect_triangle(line, corners[0], corners[1], corners[2]); };
  } else {
    const Primitive primitive = read_primitive(type, field);
    shape = [=](const Line& line) { return intersect(primitive, line); };
  }
  field.expect_all_read();
  return shape;
}

/// What is not hit has distance infinity; its other results stay as Python has filled them.
void intersect_shape(const py::dict& shape_fields, const py::buffer& origins, const py::buffer& directions, double near,
                     double far, const py::buffer& distance, const py::buffer& normal, const py::buffer& uv) {
  const Shape shape = shape_from(shape_fields);
  const Rows<const double> origin(origins, 3, "origins"), direction(directions, 3, "directions");
  const Rows<double> t(distance, 1, "distance"), n(normal, 3, "normal"), parameters(uv, 2, "uv");
  for (size_t i = 0; i < t.size(); ++i) {
    const auto hit = shape({vec3d(origin.row_or_only(i)), vec3d(direction.row_or_only(i)), near, far});
    if (!hit) continue;
    *t.row(i) = hit->t;
    for (int k = 0; k < 3; ++k) n.row(i)[k] = hit->normal[k];
    parameters.row(i)[0] = hit->u, parameters.row(i)[1] = hit->v;
  }
}

py::object normal_of_vertex(const std::string& method, const py::buffer& vertex, const py::buffer& rim, bool closed) {
  const FacetWeighting weighting = make_method(normals(), "normals", method);
  const Rows<const double> centre(vertex, 3, "vertex"), corners(rim, 3, "rim");
  const Vec3d q = vec3d(centre.row(0));
  std::vector<FacetCorner> fan;
  for (size_t i = 0; i + (closed ? 0 : 1) < corners.size(); ++i)
    fan.push_back({vec3d(corners.row(i)) - q, vec3d(corners.row((i + 1) % corners.size())) - q});
  const Vec3d n = vertex_normal(weighting, fan);
  return py::make_tuple(n.x, n.y, n.z);
}

/// (vertices, normals, triangles), vertices doubled where normals differ.
py::tuple normals_of_mesh(const py::buffer& vertices, const py::buffer& triangles, const std::string& method,
                          float crease) {
  const Rows<const float> place(vertices, 3, "vertices");
  const Rows<const uint32_t> corner(triangles, 3, "triangles");
  Mesh mesh;
  for (size_t i = 0; i < place.size(); ++i) mesh.positions.push_back(vec3(place.row(i)));
  for (size_t i = 0; i < corner.size(); ++i) {
    const uint32_t* t = corner.row(i);
    mesh.triangles.push_back({t[0], t[1], t[2]});
    for (const uint32_t v : mesh.triangles.back())
      if (v >= place.size()) throw Error(Code::usage, "triangles", fmt::format("there is no vertex {}", v));
  }
  generate_normals(mesh, crease, make_method(normals(), "normals", method));
  std::vector<uint32_t> corners;
  for (const auto& t : mesh.triangles) corners.insert(corners.end(), t.begin(), t.end());
  const auto triples = [](const std::vector<Vec3>& v) {
    std::vector<float> numbers;
    for (const Vec3 p : v) numbers.insert(numbers.end(), {p.x, p.y, p.z});
    return array(std::move(numbers), {py::ssize_t(v.size()), 3});
  };
  return py::make_tuple(triples(mesh.positions), triples(mesh.normals),
                        array(std::move(corners), {py::ssize_t(mesh.triangles.size()), 3}));
}

/// Unit directions and shares at a boundary of two media; refracted: NaN at total internal reflection.
void refract_rays(const py::buffer& incident, const py::buffer& normals, double n1, double n2, bool whitted_form,
                  const py::buffer& refracted, const py::buffer& reflectance) {
  const Rows<const double> in(incident, 3, "incident"), normal(normals, 3, "normal");
  const Rows<double> out(refracted, 3, "out"), shares(reflectance, 2, "reflectance");
  for (size_t i = 0; i < out.size(); ++i) {
    const Vec3d d = vec3d(in.row_or_only(i)), n = vec3d(normal.row_or_only(i));
    const auto through = whitted_form ? refract_direction_whitted(d, n, n2 / n1) : refract_direction(d, n, n2 / n1);
    for (int k = 0; k < 3 && through; ++k) out.row(i)[k] = (*through)[k];
    const FresnelReflectance f = fresnel_reflectance(std::abs(dot(d, n)), n2 / n1);
    shares.row(i)[0] = f.s, shares.row(i)[1] = f.p;
  }
}

void reflect_rays(const py::buffer& incident, const py::buffer& normals, const py::buffer& reflected) {
  const Rows<const double> in(incident, 3, "incident"), normal(normals, 3, "normal");
  const Rows<double> out(reflected, 3, "out");
  for (size_t i = 0; i < out.size(); ++i) {
    const Vec3d r = reflect_direction(vec3d(in.row_or_only(i)), vec3d(normal.row_or_only(i)));
    for (int k = 0; k < 3; ++k) out.row(i)[k] = r[k];
  }
}

}  // namespace

void bind_geometry(py::module_& m) {
  m.def("intersect", &intersect_shape);
  m.def("vertex_normal", &normal_of_vertex);
  m.def("mesh_normals", &normals_of_mesh);
  m.def("refract", &refract_rays);
  m.def("reflect", &reflect_rays);
}

}  // namespace aktina::python
