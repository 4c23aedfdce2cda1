#include "engine/platform/headless_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstring>
#include <string>
#include <vector>

#include "engine/core/error.h"

namespace offing {
namespace {

bool has(const char* extensions, const char* name) {
  return extensions != nullptr && std::strstr(extensions, name) != nullptr;
}

// EGL displays to try, best first: hardware devices, then Mesa without any surface.
std::vector<EGLDisplay> candidate_displays() {
  std::vector<EGLDisplay> displays;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (has(client, "EGL_EXT_platform_device") && has(client, "EGL_EXT_device_enumeration")) {
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if (eglQueryDevicesEXT(16, devices, &count)) {
      for (EGLint i = 0; i < count; ++i) {
        const char* extensions = eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS);
        if (has(extensions, "EGL_MESA_device_software")) continue;  // surfaceless serves it better
        displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
      }
    }
  }
  if (has(client, "EGL_MESA_platform_surfaceless")) {
    displays.push_back(
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  }
  return displays;
}

// `attributes` as for eglCreateContext.
EGLContext make_context(EGLDisplay display, const EGLint* attributes) {
  if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
  const EGLint config_attributes[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                      EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, config_attributes, &config, 1, &count) || count == 0) {
    config = nullptr;  // EGL_KHR_no_config_context
  }
  return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
}

constexpr EGLint kOpenGl45[] = {EGL_CONTEXT_MAJOR_VERSION,
                                4,
                                EGL_CONTEXT_MINOR_VERSION,
                                5,
                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                EGL_CONTEXT_OPENGL_DEBUG,
                                EGL_TRUE,
                                EGL_NONE};

// What a display has instead of 4.5, for the message.
std::string version_of(EGLDisplay display) {
  constexpr EGLint kAnyVersion[] = {EGL_NONE};
  const EGLContext context = make_context(display, kAnyVersion);
  std::string version = "none";
  if (context != EGL_NO_CONTEXT &&
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    if (const GLubyte* text = glGetString(GL_VERSION))
      version = reinterpret_cast<const char*>(text);
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
  return version;
}
}  // namespace

struct HeadlessContext::Impl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

HeadlessContext::HeadlessContext() : impl_(std::make_unique<Impl>()) {
  std::string found = "no EGL display";
  for (const EGLDisplay display : candidate_displays()) {
    EGLint major = 0, minor = 0;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor)) continue;
    const EGLContext context = make_context(display, kOpenGl45);
    if (context != EGL_NO_CONTEXT &&
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
      impl_->display = display;
      impl_->context = context;
      return;
    }
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    found = std::string(eglQueryString(display, EGL_VENDOR)) + " has " + version_of(display);
    eglTerminate(display);
  }
  throw InputError("rendering without a window needs OpenGL 4.5 through EGL: " + found +
                   "; install a graphics driver (Debian: libegl1 libgl1-mesa-dri)");
}

HeadlessContext::~HeadlessContext() {
  eglMakeCurrent(impl_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(impl_->display, impl_->context);
  eglTerminate(impl_->display);
}

}  // namespace offing
