#pragma once

#include <glad/gl.h>

#include <cstdint>

#include "gpu/name.h"

namespace glibra::gpu {

inline void deleteQuery(GLuint name) {
    glDeleteQueries(1, &name);
}

/// Time the device spends between start and stop. One timer runs at a time. On llvmpipe it is the time of the
/// rasteriser's threads, which only begins when drawing is flushed.
class Timer {
  public:
    Timer();
    void start() const { glBeginQuery(GL_TIME_ELAPSED, name_.get()); }
    void stop() const { glEndQuery(GL_TIME_ELAPSED); }
    [[nodiscard]] bool isReady() const;
    /// Nanoseconds between the last start and stop; waits for them.
    [[nodiscard]] std::uint64_t nanoseconds() const;

  private:
    Name<deleteQuery> name_;
};

}  // namespace glibra::gpu
