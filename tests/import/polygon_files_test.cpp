// OBJ, PLY, STL and OFF: small files made here, and every file of others that lies beside the repository.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "aktina/base/error.h"
#include "aktina/base/random.h"
#include "aktina/image/image.h"
#include "aktina/import/import.h"
#include "aktina/import/polygon.h"
#include "aktina/import/text.h"
#include "import/reading.h"
#include "test_files.h"

namespace aktina {
namespace {

using test::bare;
using test::bytes_of;
using test::warned;

Scene obj(std::string_view text, const Path& folder = {}) { return read_obj(bytes_of(text), folder, "a.obj", bare()); }
Scene ply(std::string_view text) { return read_ply(bytes_of(text), "a.ply", bare()); }
Scene stl(std::string_view text) { return read_stl(bytes_of(text), "a.stl", bare()); }
Scene off(std::string_view text) { return read_off(bytes_of(text), "a.off", bare()); }

double area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += 0.5 * double(length(triangle_cross(mesh, t)));
  return sum;
}
template <class Read>
std::string error_of(Read read) {
  try {
    read();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

constexpr std::string_view kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, IndicesCountFromOneOrBackwards) {
  for (const std::string_view face : {"f 1 2 3 4\n", "f -4 -3 -2 -1\n", "f 1 2 -2 \\\n -1\n", "f\t1\t2\t3\t4\r\n"}) {
    const Scene scene = obj(std::string(kSquare) + std::string(face));
    ASSERT_EQ(scene.meshes.size(), 1u) << face;
    EXPECT_EQ(scene.meshes[0].triangles.size(), 2u);
    EXPECT_EQ(scene.meshes[0].faces(), 1u) << "the polygon is remembered";
    EXPECT_NEAR(area(scene.meshes[0]), 1, 1e-6);
    for (const Vec3 n : scene.meshes[0].normals) EXPECT_NEAR(n.z, 1, 1e-6);
  }
}

TEST(Obj, ConcavePolygonsKeepTheirArea) {
  const Scene arrow = obj("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 3 1 0\nf 1 2 3 4\n");
  EXPECT_NEAR(area(arrow.meshes[0]), 4, 1e-6);  // shoelace: (16 - 8) / 2
  for (const auto& t : arrow.meshes[0].triangles) EXPECT_GT(triangle_cross(arrow.meshes[0], t).z, 0);
}

TEST(Obj, AttributesByCornerSplitVertices) {
  const Scene scene =
      obj(std::string(kSquare) + "vt 0 0\nvt 1 0.25\nvn 0 0 2\nf 1/1/1 2/2/1 3/1/1\nf 1/2/1 3/1/1 4/1/1\n");
  const Mesh& mesh = scene.meshes[0];
  EXPECT_EQ(mesh.positions.size(), 5u) << "vertex 1 has two texture coordinates";
  EXPECT_FLOAT_EQ(mesh.uv[0][1].y, 0.75f) << "v runs down here";
  EXPECT_EQ(warned(scene, "not of unit length"), 5u);
}

TEST(Obj, ObjectsGroupsAndMaterialsBecomeNodesAndMeshes) {
  test::TemporaryFolder folder;
  write_file(folder / "two words.mtl",
             std::string_view("newmtl red paint\nKd 1 0 0\nKs .5 .5 .5\nNs 20\n"
                              "newmtl lamp\nKe 10 5 1\nnewmtl glass\nTf .9 .9 .9\nNi 1.5\nillum 7\n"));
  const Scene scene =
      obj("mtllib two words.mtl\n" + std::string(kSquare) +
              "o box\ng lid\nusemtl red paint\nf 1 2 3\nusemtl lamp\nf 1 3 4\ng side\nusemtl none\nf 1 2 4\n",
          folder.path());
  ASSERT_EQ(scene.nodes.size(), 3u);
  EXPECT_EQ(scene.nodes[1].name, "lid");
  EXPECT_EQ(scene.nodes[1].parent, 0);
  ASSERT_EQ(scene.meshes.size(), 3u);
  ASSERT_EQ(scene.materials.size(), 3u);
  EXPECT_EQ(scene.materials[0].classic->kd, Rgb(1, 0, 0));
  EXPECT_EQ(scene.materials[0].classic->exponent, 20);
  EXPECT_EQ(scene.materials[1].emission.v, Rgb(10, 5, 1));
  EXPECT_EQ(scene.materials[2].classic->kt, Rgb(0.9f));
  EXPECT_EQ(warned(scene, "material 'none' is missing"), 1u);
}

TEST(Obj, SmoothingGroupsDecideOverEdges) {
  const std::string roof = "v 0 0 0\nv 1 0 0\nv 1 1 1\nv 0 1 1\nv 1 2 0\nv 0 2 0\n";
  const std::string faces = "f 1 2 3 4\nf 4 3 5 6\n";
  EXPECT_EQ(obj(roof + "s 1\n" + faces).meshes[0].positions.size(), 6u) << "smooth over a right angle";
  EXPECT_EQ(obj(roof + "s off\n" + faces).meshes[0].positions.size(), 8u);
  EXPECT_EQ(obj(roof + faces).meshes[0].positions.size(), 8u) << "sharper than the crease";
}

TEST(Obj, VertexColoursAreDecoded) {
  const Scene scene = obj("v 0 0 0 1 0.5 0\nv 1 0 0 1 0.5 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_NEAR(scene.meshes[0].colours[0].y, srgb_to_linear(0.5f), 1e-6);
  EXPECT_EQ(warned(scene, "without a colour"), 1u);
}

TEST(Obj, Utf16) {
  std::string wide("\xfe\xff", 2);
  for (const char c : std::string(kSquare) + "f 1 2 3\n") wide += std::string({'\0', c});
  EXPECT_EQ(obj(wide).meshes[0].triangles.size(), 1u);
}

TEST(Obj, FilesOutsideOfTheFolderAreNotRead) {
  test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "in");
  write_file(folder / "m.mtl", std::string_view("newmtl a\n"));
  for (const std::string& name : {std::string("../m.mtl"), (folder / "m.mtl").string(), std::string("..\\m.mtl")}) {
    const Scene scene = obj("mtllib " + name + "\n" + std::string(kSquare) + "usemtl a\nf 1 2 3\n", folder / "in");
    EXPECT_TRUE(scene.materials.empty()) << name;
  }
  write_file(folder / "in" / "m.mtl", std::string_view("newmtl a\n"));
  const Scene scene = obj("mtllib C:\\work\\m.mtl\n" + std::string(kSquare) + "usemtl a\nf 1 2 3\n", folder / "in");
  EXPECT_EQ(scene.materials.size(), 1u) << "what lies beside the scene is found under its last part";
}

TEST(Obj, FaultsSayTheirLine) {
  EXPECT_EQ(error_of([] { obj("v 0 0 0\nv 1 x 0\n"); }), "a.obj:2: vertex has 'x' where a number belongs");
  EXPECT_NE(error_of([] { obj("v 0 0\n"); }).find("a.obj:1: vertex has 2 of 3 numbers"), std::string::npos);
  EXPECT_NE(error_of([] { obj("v 0 0 0\np 1\n"); }).find("1 points"), std::string::npos);
  EXPECT_NE(error_of([] { obj(""); }).find("no surface"), std::string::npos);
  const Scene scene = obj(std::string(kSquare) + "f 1 2 3\nf 1 2 99\nf 0 1 2\nf 1 2\nf 1 1 2\nv nan 0 0\nf 1 2 5\n");
  EXPECT_EQ(scene.meshes[0].triangles.size(), 1u);
  EXPECT_EQ(warned(scene, "indices out of range"), 2u);
  EXPECT_EQ(warned(scene, "without area"), 1u);
  EXPECT_EQ(warned(scene, "not finite"), 1u);
}

constexpr std::string_view kPlyVertices = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";

TEST(Ply, TextWithColoursAndQuads) {
  const Scene scene = ply("ply\r\nformat ascii 1.0\r\n" + std::string(kPlyVertices) +
                          "property uchar red\nproperty uchar green\nproperty uchar blue\n"
                          "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                          "0 0 0 255 0 0\n1 0 0 255 0 0\n1 1 0 255 0 0\n0 1 0 188 0 0\n4 0 1 2 3\n");
  EXPECT_NEAR(area(scene.meshes[0]), 1, 1e-6);
  EXPECT_EQ(scene.meshes[0].faces(), 1u);
  EXPECT_NEAR(scene.meshes[0].colours[3].x, srgb_to_linear(188 / 255.0f), 1e-6);
}

template <class T>
void put(std::string& out, T value, bool big) {
  char own[sizeof(T)];
  std::memcpy(own, &value, sizeof(T));
  if (big) std::reverse(own, own + sizeof(T));
  out.append(own, sizeof(T));
}

TEST(Ply, BinaryInBothOrders) {
  for (const bool big : {false, true}) {
    std::string file = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                       "_endian 1.0\nelement vertex 3\nproperty double x\nproperty short y\nproperty float z\n"
                       "element face 1\nproperty uchar flags\nproperty list ushort uint vertex_index\nend_header\n";
    const double x[] = {0, 2, 0};
    const int16_t y[] = {0, 0, 3};
    for (int i = 0; i < 3; ++i) put(file, x[i], big), put(file, y[i], big), put(file, 0.0f, big);
    file += '\7';
    put(file, uint16_t(3), big);
    for (uint32_t i = 0; i < 3; ++i) put(file, i, big);
    EXPECT_NEAR(area(ply(file).meshes[0]), 3, 1e-6);
    file.resize(file.size() - 1);
    EXPECT_NE(error_of([&] { ply(file); }).find("claims 3 values"), std::string::npos);
  }
}

TEST(Ply, TriangleStripsTurnEveryOther) {
  const Scene scene = ply("ply\nformat ascii 1.0\n" + std::string(kPlyVertices) +
                          "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                          "0 0 0\n1 0 0\n0 1 0\n1 1 0\n9 0 1 2 3 -1 0 1 2 -1\n");
  ASSERT_EQ(scene.meshes[0].triangles.size(), 3u);
  for (const auto& t : scene.meshes[0].triangles) EXPECT_GT(triangle_cross(scene.meshes[0], t).z, 0);
}

TEST(Ply, HugeClaimsAreRefusedBeforeMemoryIsTaken) {
  const std::string head = "ply\nformat binary_little_endian 1.0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  EXPECT_NE(error_of([&] { ply(head + "element vertex 4000000000\n" + xyz + "end_header\nabc"); }).find("are claimed"),
            std::string::npos);
  std::string list = head + "element face 1\nproperty list uint int vertex_indices\nend_header\n";
  put(list, 0xfffffff0u, false);
  EXPECT_NE(error_of([&] { ply(list); }).find("a list of 'vertex_indices' claims"), std::string::npos);
}

TEST(Ply, AnElementThatIsDeclaredTwiceIsRefused) {
  const std::string bare = "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n";
  const std::string coloured = bare + "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  EXPECT_NE(error_of([&] {
              ply("ply\nformat ascii 1.0\n" + bare + coloured + "end_header\n0 0 0\n0 0 0 1 2 3\n");
            }).find("'vertex' is declared twice"),
            std::string::npos);
}

TEST(Ply, PointsAloneAreRefused) {
  EXPECT_NE(error_of([] {
              ply("ply\nformat ascii 1.0\n" + std::string(kPlyVertices) + "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n");
            }).find("4 points and no faces"),
            std::string::npos);
}

constexpr std::string_view kSolid =
    "solid a b\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
    "a b\n";

TEST(Stl, TextAndBinary) {
  EXPECT_EQ(stl(std::string(kSolid) + std::string(kSolid)).meshes.size(), 2u) << "each solid a mesh";
  std::string binary(80, 's');
  binary.replace(0, 5, "solid");
  put(binary, uint32_t(1), false);
  const float facet[] = {0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 2, 0};
  for (const float x : facet) put(binary, x, false);
  binary += std::string(2, '\0');
  EXPECT_NEAR(area(stl(binary).meshes[0]), 2, 1e-6) << "though it begins with 'solid'";
  binary[83] = '\x7f';
  EXPECT_NE(error_of([&] { stl(binary); }).find("are claimed"), std::string::npos);
  EXPECT_NE(error_of([] { stl("solid\nfacet\nvertex 0 0\n"); }).find("a.stl:3"), std::string::npos);
  EXPECT_NE(error_of([] { stl("solid\nendsolid\n"); }).find("no surface"), std::string::npos);
}

TEST(Off, PlainAndColoured) {
  EXPECT_NEAR(area(off("OFF 4 1 0\n# a square\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 255 0 0\n").meshes[0]), 1, 1e-6);
  const Scene scene = off("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 255 0 0 255\n3 0 1 2\n");
  EXPECT_FLOAT_EQ(scene.meshes[0].colours[0].x, 1);
  EXPECT_NE(error_of([] { off("OFF\n9999999 9999999 0\n"); }).find("are claimed"), std::string::npos);
}

TEST(Triangulator, AreaIsKeptForStars) {
  std::vector<Point3> star;
  double expected = 0;
  for (int i = 0; i < 40; ++i) {
    const double r = i % 2 ? 0.3 : 1, phi = 2 * kPi * i / 40;
    star.emplace_back(0, r * std::cos(phi), r * std::sin(phi));
    expected += 0.5 * 0.3 * std::sin(2 * kPi / 40);
  }
  Triangulator cutter;
  double sum = 0;
  for (const auto& t : cutter.triangulate(star)) {
    const Vec3 n = cross(star[t[1]] - star[t[0]], star[t[2]] - star[t[0]]);
    EXPECT_GT(n.x, 0);
    sum += 0.5 * double(n.x);
  }
  EXPECT_NEAR(sum, expected, 1e-5);
  EXPECT_EQ(cutter.given_up(), 0u);
}

/// Every prefix and many flipped bits: an Error or a scene, nothing else.
TEST(Hostile, CutAndFlippedFiles) {
  std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const float x : {0, 0, 0, 1, 0, 0, 0, 1, 0}) put(binary, x, false);
  binary += '\3';
  for (const int i : {0, 1, 2}) put(binary, i, false);
  const std::string text = std::string(kSquare) + "vt 0 0\nvn 0 0 1\ng a\ns 1\nf 1/1/1 2//1 3 4/1\n";
  Pcg32 random(1);
  const auto attempt = [&](const std::string& file) {
    error_of([&] { obj(file); }), error_of([&] { ply(file); }), error_of([&] { stl(file); }),
        error_of([&] { off(file); });
  };
  for (const std::string& file :
       {binary, text, std::string(kSolid), std::string("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")}) {
    for (size_t i = 0; i < file.size(); ++i) attempt(file.substr(0, i));
    for (int i = 0; i < 500; ++i) {
      std::string flipped = file;
      for (uint32_t k = random.next() % 4 + 1; k-- > 0;)
        flipped[random.next() % flipped.size()] ^= char(1 << random.next() % 8);
      attempt(flipped);
    }
  }
}

TEST(ThirdParty, EveryPolygonFileLoadsOrSaysWhyNot) {
  AKTINA_NEEDS_THIRD_PARTY_SCENES();
  size_t loaded = 0, refused = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::third_party_scenes())) {
    const std::string extension = lower_extension(entry.path());
    if (extension != "obj" && extension != "ply" && extension != "stl" && extension != "off") continue;
    try {
      const Scene scene = load_scene(entry.path());
      EXPECT_FALSE(scene.instances.empty()) << entry.path();
      EXPECT_FALSE(bounds(scene).empty()) << entry.path();
      ++loaded;
    } catch (const Error& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      EXPECT_NE(std::string(error.what()).find(entry.path().filename().string()), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(loaded, 2 * refused) << "most are meant to load";
}

TEST(ThirdParty, KnownScenesAreWhole) {
  AKTINA_NEEDS_THIRD_PARTY_SCENES();
  const Path scenes = test::third_party_scenes();
  const Scene box = load_scene(scenes / "scene-cornell-mcguire/CornellBox-Original.obj");
  EXPECT_TRUE(has_light(box));
  EXPECT_TRUE(std::any_of(box.materials.begin(), box.materials.end(), [](const Material& m) { return m.emits(); }));
  EXPECT_EQ(triangle_count(load_scene(scenes / "mesh-stanford/bunny.off")), 6966u);
  EXPECT_EQ(triangle_count(load_scene(scenes / "mesh-stanford/dragon_vrip_res4.ply")), 11102u);
  uint64_t room = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scenes / "scene-living-room-partial/models"))
    room += triangle_count(load_scene(entry.path()));
  EXPECT_GT(room, 30000u);
}

}  // namespace
}  // namespace aktina
