#pragma once
// A GL context of the compatibility profile, which runs shaders of every dialect as they are written. It is
// what glibra itself never uses, and so an independent judge of the translation to core GLSL.
//
// The functions come in a table of its own, so that this context and a Renderer's can be used in turn in one
// process.

#include <memory>

struct GladGLContext;  // glad's table of functions, from this folder's own <glad/gl.h>

namespace glibra::oracle {

class CompatibilityContext {
  public:
    /// EGL without a surface, GL 4.5 compatibility or the next lower version it has. Throws
    /// std::runtime_error with the reason if there is none. Opens no earlier than the first Renderer of the
    /// process: drivers read their settings from the environment once.
    CompatibilityContext();
    CompatibilityContext(const CompatibilityContext&) = delete;
    CompatibilityContext& operator=(const CompatibilityContext&) = delete;
    ~CompatibilityContext();

    [[nodiscard]] const GladGLContext& gl() const { return *functions_; }

    /// The context is current while this lives; afterwards the one that was current before is so again.
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
