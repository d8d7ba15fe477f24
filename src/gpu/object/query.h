#pragma once

#include <glad/gl.h>

#include <cstdint>

#include "gpu/object/name.h"

namespace glibra::gpu {

/// Counts what the device does between begin() and end(): GL_SAMPLES_PASSED, GL_PRIMITIVES_GENERATED,
/// GL_TIME_ELAPSED (nanoseconds) and so on. Only one query of a kind can run at a time. On llvmpipe
/// GL_TIME_ELAPSED measures the rasteriser's threads, which start when drawing is flushed.
class Query {
  public:
    explicit Query(GLenum kind) : kind_(kind) {}
    void begin() const { glBeginQuery(kind_, name_.get()); }
    void end() const { glEndQuery(kind_); }
    [[nodiscard]] bool isReady() const {
        GLint ready = GL_FALSE;
        glGetQueryObjectiv(name_.get(), GL_QUERY_RESULT_AVAILABLE, &ready);
        return ready != GL_FALSE;
    }
    /// The count between the last begin() and end(); waits for the device.
    [[nodiscard]] std::uint64_t result() const {
        GLuint64 count = 0;
        glGetQueryObjectui64v(name_.get(), GL_QUERY_RESULT, &count);
        return count;
    }

  private:
    GLenum kind_;
    Name<glDeleteQueries> name_{glGenQueries};
};

}  // namespace glibra::gpu
