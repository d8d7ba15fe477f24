#include "gpu/object/timer.h"

namespace glibra::gpu {
namespace {

std::uint64_t timeOf(GLuint query) {
    GLuint64 time = 0;
    glad_glGetQueryObjectui64v(query, GL_QUERY_RESULT, &time);
    return time;
}

}  // namespace

// The functions of glad's table are called without its macros, which CallCounter counts.

Timer::Timer(const Capabilities& capabilities, Take take)
    : bits_(capabilities.timerBits), flushes_(capabilities.isSoftware), take_(std::move(take)) {}

Timer::QueryName Timer::stamp() {
    QueryName query;
    if (free_.empty()) {
        query = QueryName(glad_glGenQueries);
    } else {
        query = std::move(free_.back());
        free_.pop_back();
    }
    glad_glQueryCounter(query.get(), GL_TIMESTAMP);
    if (flushes_) glad_glFlush();
    return query;
}

void Timer::begin(std::size_t piece) {
    if (!measures()) return;
    open_.push_back({piece, stamp(), {}});
}

void Timer::end() {
    if (open_.empty()) return;
    Piece ended = std::move(open_.back());
    open_.pop_back();
    ended.end = stamp();
    pending_.push_back(std::move(ended));
    if (pending_.size() > kMostPending) takeFirst();
}

void Timer::takeFirst() {
    Piece first = std::move(pending_.front());
    pending_.pop_front();
    std::uint64_t passed = timeOf(first.end.get()) - timeOf(first.begin.get());
    constexpr int kAllBits = 64;
    if (bits_ < kAllBits) passed &= (std::uint64_t{1} << bits_) - 1;  // the clock may have begun anew
    free_.push_back(std::move(first.begin));
    free_.push_back(std::move(first.end));
    constexpr double kNanosecondsInMillisecond = 1e6;
    take_(first.piece, static_cast<double>(passed) / kNanosecondsInMillisecond);
}

void Timer::collect() {
    while (!pending_.empty()) {
        GLint isReady = GL_FALSE;
        glad_glGetQueryObjectiv(pending_.front().end.get(), GL_QUERY_RESULT_AVAILABLE, &isReady);
        if (isReady == GL_FALSE) return;
        takeFirst();
    }
}

void Timer::finish() {
    while (!pending_.empty()) takeFirst();
}

}  // namespace glibra::gpu
