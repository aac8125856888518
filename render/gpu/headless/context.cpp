// SPDX-License-Identifier: Apache-2.0
#include "render/gpu/headless/context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <vector>

namespace sline::render::gpu {

namespace {

constexpr const char* remedy =
    "Install an OpenGL driver that needs no display: apt-get install libegl1 libgl1-mesa-dri";

/// Describes one way to a display, and its result.
struct Attempt {
  const char* name;
  EGLDisplay display = EGL_NO_DISPLAY;
};

// Tells whether the library is present: libepoxy ends the program where it is absent, so this must
// look first.
bool libraryPresent(const char* name) {
  void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
  if (library)
    dlclose(library);
  return library != nullptr;
}

Attempt surfaceless() {
  Attempt attempt{"EGL surfaceless"};
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
    attempt.display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  return attempt;
}

std::vector<Attempt> devices() {
  std::vector<Attempt> attempts;
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") ||
      !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration"))
    return attempts;
  std::array<EGLDeviceEXT, 16> found{};
  EGLint count = 0;
  if (!eglQueryDevicesEXT(EGLint(found.size()), found.data(), &count))
    return attempts;
  for (EGLint i = 0; i < count; ++i)
    attempts.push_back({"EGL device", eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT,
                                                               found[std::size_t(i)], nullptr)});
  return attempts;
}

#ifndef NDEBUG
void APIENTRY report(GLenum /*source*/, GLenum type, GLuint /*id*/, GLenum severity,
                     GLsizei /*length*/, const GLchar* message, const void* /*user*/) {
  if (type == GL_DEBUG_TYPE_ERROR || severity == GL_DEBUG_SEVERITY_HIGH)
    std::fprintf(stderr, "OpenGL: %s\n", message);
}
#endif

void installDebugOutput() {
#ifndef NDEBUG
  if (!epoxy_has_gl_extension("GL_KHR_debug"))
    return;
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(report, nullptr);
#endif
}

}  // namespace

struct HeadlessContext::Data {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  std::string driver;

  /// Opens the display; returns null, or why it gives no context.
  const char* open() {
    if (display == EGL_NO_DISPLAY)
      return "not offered";
    EGLint major = 0;
    EGLint minor = 0;
    if (!eglInitialize(display, &major, &minor))
      return "cannot be initialised";
    if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context") ||
        !epoxy_has_egl_extension(display, "EGL_KHR_create_context"))
      return "has no contexts without a surface";
    if (!eglBindAPI(EGL_OPENGL_API))
      return "has no desktop OpenGL";
    const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                       EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted.data(), &config, 1, &count) || count == 0)
      return "has no configuration for desktop OpenGL";
    const std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION_KHR,
                                           3,
                                           EGL_CONTEXT_MINOR_VERSION_KHR,
                                           3,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                           EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
#ifdef NDEBUG
                                           EGL_NONE,
#else
                                           EGL_CONTEXT_FLAGS_KHR,
                                           EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR,
#endif
                                           EGL_NONE};
    context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
    if (context == EGL_NO_CONTEXT)
      return "gives no OpenGL 3.3 core context";
    if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
      return "does not make its context current";
    return nullptr;
  }

  void close() {
    if (display == EGL_NO_DISPLAY)
      return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT)
      eglDestroyContext(display, context);
    // The display stays initialised: EGL gives the same one to the whole program.
    context = EGL_NO_CONTEXT;
    display = EGL_NO_DISPLAY;
  }
};

HeadlessContext::HeadlessContext() : m_data(std::make_unique<Data>()) {}

HeadlessContext::~HeadlessContext() {
  m_data->close();
}

bool HeadlessContext::mayBeOnCard() {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/dev", none)) {
    const std::string name = entry.path().filename();
    if (name == "dxg" || name.starts_with("nvidia") || name.starts_with("kfd"))
      return true;
  }
  for (const auto& entry : std::filesystem::directory_iterator("/dev/dri", none))
    if (entry.path().filename().string().starts_with("renderD"))
      return true;
  return false;
}

Result<std::unique_ptr<HeadlessContext>> HeadlessContext::create() {
  for (const char* library : {"libEGL.so.1", "libGL.so.1"})
    if (!libraryPresent(library) && !(library[3] == 'G' && libraryPresent("libOpenGL.so.0")))
      return Error{.file = library,
                   .reason = "the library that draws without a display is not installed",
                   .remedy = remedy};
  std::unique_ptr<HeadlessContext> context(new HeadlessContext);
  std::vector<Attempt> attempts{surfaceless()};
  for (const Attempt& device : devices())
    attempts.push_back(device);
  std::string tried;
  for (const Attempt& attempt : attempts) {
    Data& data = *context->m_data;
    data.display = attempt.display;
    const char* fault = data.open();
    if (!fault) {
      GLint version[2] = {0, 0};
      glGetIntegerv(GL_MAJOR_VERSION, &version[0]);
      glGetIntegerv(GL_MINOR_VERSION, &version[1]);
      const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
      data.driver = std::string(renderer ? renderer : "unknown driver") + ", OpenGL " +
                    std::to_string(version[0]) + "." + std::to_string(version[1]) + ", " +
                    attempt.name;
      installDebugOutput();
      return context;
    }
    data.close();
    tried += (tried.empty() ? "" : "; ") + std::string(attempt.name) + " " + fault;
  }
  return Error{.reason = "no OpenGL without a display (" + tried + ")", .remedy = remedy};
}

const std::string& HeadlessContext::driver() const {
  return m_data->driver;
}

void HeadlessContext::makeCurrent() {
  eglMakeCurrent(m_data->display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_data->context);
}

}  // namespace sline::render::gpu
