#pragma once
// A GL context of the compatibility profile, which runs shaders of every dialect as they are written. glibra
// itself never uses this profile, so it is an independent reference for the translation to core GLSL.
//
// The context has its own table of GL functions, so that it and a Renderer's context can be used in turn in
// one process.

#include <memory>

struct GladGLContext;  // glad's table of functions, from this folder's own <glad/gl.h>

namespace glibra::oracle {

class CompatibilityContext {
  public:
    /// Opens an EGL context without a surface, of GL 4.5 compatibility or the next lower version. Throws
    /// std::runtime_error with the reason if there is none. Open it after the first Renderer of the process,
    /// because drivers read their settings from the environment only once.
    CompatibilityContext();
    CompatibilityContext(const CompatibilityContext&) = delete;
    CompatibilityContext& operator=(const CompatibilityContext&) = delete;
    ~CompatibilityContext();

    [[nodiscard]] const GladGLContext& gl() const { return *functions_; }

    /// Makes the context current during its lifetime, and then the context that was current before.
    class Current {
      public:
        explicit Current(const CompatibilityContext& context);
        Current(const Current&) = delete;
        Current& operator=(const Current&) = delete;
        ~Current();

      private:
        const CompatibilityContext& context_;
        void* before_ = nullptr;
    };

  private:
    struct Egl;
    std::unique_ptr<Egl> egl_;
    std::unique_ptr<GladGLContext> functions_;
};

}  // namespace glibra::oracle
