#include "gpu/object/timer.h"

namespace glibra::gpu {

Timer::Timer() {
    GLuint name = 0;
    glGenQueries(1, &name);
    name_ = Name<deleteQuery>(name);
}

bool Timer::isReady() const {
    GLint ready = GL_FALSE;
    glGetQueryObjectiv(name_.get(), GL_QUERY_RESULT_AVAILABLE, &ready);
    return ready != GL_FALSE;
}

std::uint64_t Timer::nanoseconds() const {
    GLuint64 elapsed = 0;
    glGetQueryObjectui64v(name_.get(), GL_QUERY_RESULT, &elapsed);
    return elapsed;
}

}  // namespace glibra::gpu
