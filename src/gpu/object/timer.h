#pragma once

#include <glad/gl.h>

#include <cstdint>

#include "gpu/object/name.h"

namespace glibra::gpu {

inline void deleteQuery(GLuint name) {
    glDeleteQueries(1, &name);
}

/// Measures the device's time between start and stop. Only one timer can run at a time. On llvmpipe it
/// measures the rasteriser's threads, which start when drawing is flushed.
class Timer {
  public:
    Timer();
    void start() const { glBeginQuery(GL_TIME_ELAPSED, name_.get()); }
    void stop() const { glEndQuery(GL_TIME_ELAPSED); }
    [[nodiscard]] bool isReady() const;
    /// The nanoseconds between the last start and stop; waits for the device.
    [[nodiscard]] std::uint64_t nanoseconds() const;

  private:
    Name<deleteQuery> name_;
};

}  // namespace glibra::gpu
