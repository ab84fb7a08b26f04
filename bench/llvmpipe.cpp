#include "bench/llvmpipe.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/core.h>

#include <cstdlib>

namespace aktina::bench {
namespace {

/// The same equation in both shaders: ka Ia + sum over lights of I / (pi d^2) (kd n.l + ks (r.v)^n). Backs turn their
/// normal, as ours do.
constexpr char kLight[] = R"(
uniform vec3 eye, ambient, kd, ks, place[3], colour[3];
uniform float exponent;
vec3 light(vec3 x, vec3 n) {
  n = normalize(n);
  vec3 v = normalize(eye - x), sum = ambient;
  for (int i = 0; i < 3; ++i) {
    vec3 d = place[i] - x;
    vec3 l = normalize(d);
    float nl = dot(n, l);
    if (nl > 0.0) {
      float shine = pow(max(2.0 * nl * dot(n, v) - dot(l, v), 1e-30), exponent);
      sum += colour[i] / dot(d, d) * (kd * nl + ks * shine);
    }
  }
  return sum;
}
)";
constexpr char kVertexPhong[] = R"(
layout(location = 0) in vec3 position; layout(location = 1) in vec3 normal;
uniform mat4 clip; out vec3 x, n;
void main() { x = position; n = normal; gl_Position = clip * vec4(position, 1.0); }
)";
constexpr char kPixelPhong[] = R"(
in vec3 x, n; out vec4 c;
void main() { c = vec4(light(x, gl_FrontFacing ? n : -n), 1.0); }
)";
constexpr char kVertexGouraud[] = R"(
layout(location = 0) in vec3 position; layout(location = 1) in vec3 normal;
uniform mat4 clip; noperspective out vec3 lit;
void main() { lit = light(position, normal); gl_Position = clip * vec4(position, 1.0); }
)";
constexpr char kPixelGouraud[] = R"(
noperspective in vec3 lit; out vec4 c;
void main() { c = vec4(lit, 1.0); }
)";

constexpr char kVertexItem[] = R"(
layout(location = 0) in vec3 position;
uniform mat4 clip;
void main() { gl_Position = clip * vec4(position, 1.0); }
)";
constexpr char kPixelItem[] = R"(
out uint item;
void main() { item = uint(gl_PrimitiveID) + 1u; }
)";

GLuint compiled(GLenum kind, const std::string& body) {
  const std::string text = "#version 330 core\n" + std::string(kLight) + body;
  const char* source = text.c_str();
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  return shader;
}

GLuint linked(const char* vertex, const char* pixel) {
  const GLuint program = glCreateProgram();
  glAttachShader(program, compiled(GL_VERTEX_SHADER, vertex));
  glAttachShader(program, compiled(GL_FRAGMENT_SHADER, pixel));
  glLinkProgram(program);
  GLint ok = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  return ok ? program : 0;
}

void set_uniforms(GLuint program, const Scene& scene, int size) {
  const Camera& camera = scene.cameras[0];
  const Surface s = surface_of(scene.materials[0]);
  const auto at = [&](const std::string& name) { return glGetUniformLocation(program, name.c_str()); };
  const auto put = [&](const std::string& name, Rgb c) { glUniform3f(at(name), c.r, c.g, c.b); };
  glUseProgram(program);
  const Mat4 clip = clip_from_world(camera, size, size);
  glUniformMatrix4fv(at("clip"), 1, GL_FALSE, &clip[0][0]);
  const Point3 eye = camera.position();
  put("eye", {eye.x, eye.y, eye.z});
  put("ambient", s.ka * scene.ambient), put("kd", s.kd), put("ks", s.ks);
  glUniform1f(at("exponent"), s.exponent);
  for (int i = 0; i < 3; ++i) {
    const auto& lamp = std::get<PointLight>(scene.lights[size_t(i)].light);
    put(fmt::format("place[{}]", i), {lamp.position.x, lamp.position.y, lamp.position.z});
    put(fmt::format("colour[{}]", i), lamp.intensity.v * float(kInvPi));
  }
}

/// What llvmpipe draws on.
struct Canvas {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  GLsizei indices = 0;
  int size = 0;
  std::string renderer;

  ~Canvas() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    eglTerminate(display);
  }

  /// @return  why there is nothing to draw on; empty: there is
  std::string open(int size_, int threads) {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
    size = size_;
    if (!make_context()) return "no surfaceless EGL with OpenGL 3.3 (Debian: libegl-mesa0, libgl1-mesa-dri)";
    renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    if (renderer.find("llvmpipe") == std::string::npos) return "OpenGL is not llvmpipe but " + renderer;
    return "";
  }

  bool make_context() {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) return false;
    display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return false;
    eglBindAPI(EGL_OPENGL_API);
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    return context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
  }

  void make_picture(GLenum colours) {
    GLuint frame, buffer[2];
    glGenFramebuffers(1, &frame);
    glGenRenderbuffers(2, buffer);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    const GLenum formats[2] = {colours, GL_DEPTH_COMPONENT24};
    const GLenum places[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (int i = 0; i < 2; ++i) {
      glBindRenderbuffer(GL_RENDERBUFFER, buffer[i]);
      glRenderbufferStorage(GL_RENDERBUFFER, formats[i], size, size);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, buffer[i]);
    }
    glViewport(0, 0, size, size);
    glEnable(GL_DEPTH_TEST);
    glClearColor(0, 0, 0, 1);
  }

  void load(const Mesh& mesh) {
    GLuint array, buffer[3];
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(3, buffer);
    const std::vector<Vec3>* attributes[2] = {&mesh.positions, &mesh.normals};
    for (GLuint i = 0; i < 2; ++i) {
      glBindBuffer(GL_ARRAY_BUFFER, buffer[i]);
      glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(attributes[i]->size() * sizeof(Vec3)), attributes[i]->data(),
                   GL_STATIC_DRAW);
      glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
      glEnableVertexAttribArray(i);
    }
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffer[2]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.triangles.size() * 12), mesh.triangles.data(),
                 GL_STATIC_DRAW);
    indices = GLsizei(mesh.triangles.size() * 3);
  }
};

}  // namespace

struct Llvmpipe::Context : Canvas {
  GLuint phong = 0, gouraud = 0;
};

Llvmpipe::Llvmpipe(const Scene& scene, int size, int threads) : context_(std::make_unique<Context>()) {
  Context& c = *context_;
  missing_ = c.open(size, threads), renderer_ = c.renderer;
  if (!missing_.empty()) return;
  c.make_picture(GL_RGBA8);
  c.load(scene.meshes[0]);
  c.phong = linked(kVertexPhong, kPixelPhong), c.gouraud = linked(kVertexGouraud, kPixelGouraud);
  if (c.phong == 0 || c.gouraud == 0) {
    missing_ = "shaders do not compile on " + renderer_;
    return;
  }
  set_uniforms(c.phong, scene, size);
  set_uniforms(c.gouraud, scene, size);
}

Llvmpipe::~Llvmpipe() = default;

void Llvmpipe::draw(bool per_pixel) {
  glUseProgram(per_pixel ? context_->phong : context_->gouraud);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDrawElements(GL_TRIANGLES, context_->indices, GL_UNSIGNED_INT, nullptr);
  glFinish();
}

std::vector<float> Llvmpipe::read() const {
  const auto n = size_t(context_->size);
  std::vector<uint8_t> bytes(n * n * 4);
  glReadPixels(0, 0, context_->size, context_->size, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  std::vector<float> out(n * n * 3);
  for (size_t y = 0; y < n; ++y)
    for (size_t x = 0; x < n; ++x)
      for (size_t k = 0; k < 3; ++k) out[(y * n + x) * 3 + k] = float(bytes[((n - 1 - y) * n + x) * 4 + k]) / 255;
  return out;
}

struct LlvmpipeItems::Context : Canvas {
  GLuint program = 0;
  GLint clip = 0;
};

LlvmpipeItems::LlvmpipeItems(const Mesh& mesh, int size, int threads) : context_(std::make_unique<Context>()) {
  Context& c = *context_;
  missing_ = c.open(size, threads);
  if (!missing_.empty()) return;
  c.make_picture(GL_R32UI);
  c.load(mesh);
  c.program = linked(kVertexItem, kPixelItem);
  if (c.program == 0) missing_ = "shaders do not compile on " + c.renderer;
  c.clip = glGetUniformLocation(c.program, "clip");
  glUseProgram(c.program);
  glEnable(GL_SCISSOR_TEST);
}

LlvmpipeItems::~LlvmpipeItems() = default;

void LlvmpipeItems::draw(const Camera& camera, int rows, std::vector<uint32_t>& items) {
  const int size = context_->size;
  const Mat4 clip = clip_from_world(camera, size, size);
  glUniformMatrix4fv(context_->clip, 1, GL_FALSE, &clip[0][0]);
  glScissor(0, size - rows, size, rows);
  constexpr GLuint kNothing[4] = {};
  glClearBufferuiv(GL_COLOR, 0, kNothing);
  glClear(GL_DEPTH_BUFFER_BIT);
  glDrawElements(GL_TRIANGLES, context_->indices, GL_UNSIGNED_INT, nullptr);
  items.resize(size_t(size) * size_t(rows));
  glReadPixels(0, size - rows, size, rows, GL_RED_INTEGER, GL_UNSIGNED_INT, items.data());
}

}  // namespace aktina::bench
