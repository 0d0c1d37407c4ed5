#include "sim/rendering/offscreen.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdio>
#include <string>

#include "mrroc/errors.hpp"

namespace mrroc::sim {

namespace {

void require(bool done, const char* call) {
  if (done) return;
  std::array<char, 16> code{};
  std::snprintf(code.data(), code.size(), "0x%x", static_cast<unsigned>(eglGetError()));
  throw SystemError(ErrorCode::resources, std::string("offscreen rendering: ") + call + " failed with " + code.data());
}

}  // namespace

OffscreenContext::OffscreenContext() {
  const auto get_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  require(get_display != nullptr, "eglGetProcAddress(eglGetPlatformDisplayEXT)");
  display_ = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  require(display_ != EGL_NO_DISPLAY, "eglGetPlatformDisplayEXT");
  require(eglInitialize(display_, nullptr, nullptr) == EGL_TRUE, "eglInitialize");
  const std::array<EGLint, 13> wanted{EGL_RED_SIZE,
                                      8,
                                      EGL_GREEN_SIZE,
                                      8,
                                      EGL_BLUE_SIZE,
                                      8,
                                      EGL_DEPTH_SIZE,
                                      24,
                                      EGL_SURFACE_TYPE,
                                      EGL_PBUFFER_BIT,
                                      EGL_RENDERABLE_TYPE,
                                      EGL_OPENGL_BIT,
                                      EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  require(eglChooseConfig(display_, wanted.data(), &config, 1, &count) == EGL_TRUE && count == 1, "eglChooseConfig");
  require(eglBindAPI(EGL_OPENGL_API) == EGL_TRUE, "eglBindAPI");
  context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
  require(context_ != EGL_NO_CONTEXT, "eglCreateContext");
  require(eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE, "eglMakeCurrent");
}

OffscreenContext::~OffscreenContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

}  // namespace mrroc::sim
