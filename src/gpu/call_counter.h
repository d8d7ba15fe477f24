#pragma once
// What a driver is asked to do, counted where every call passes: at the table of GL functions. By it the
// rules are proved that leave something out.

#include <cstdint>

namespace glibra::gpu {

struct CallCounts {
    std::uint64_t calls = 0;           ///< of any GL function
    std::uint64_t draws = 0;           ///< glDraw*
    std::uint64_t programsLinked = 0;  ///< glLinkProgram
    std::uint64_t texturesFilled = 0;  ///< glTexSubImage*; a cube map counts six
    std::uint64_t buffersFilled = 0;   ///< glBufferData with content, glBufferSubData
    std::uint64_t bytesUploaded = 0;   ///< of both, as the caller's memory holds them
    std::uint64_t pixelsRead = 0;      ///< glReadPixels
};

/// Counts every GL call of the process while it lives; without one counting costs nothing. One at a time:
/// while an outer one waits for an inner one to end it counts nothing.
class CallCounter {
  public:
    CallCounter();
    CallCounter(const CallCounter&) = delete;
    CallCounter& operator=(const CallCounter&) = delete;
    ~CallCounter();

    [[nodiscard]] const CallCounts& counts() const { return counts_; }

  private:
    CallCounts counts_;
    CallCounts* outer_ = nullptr;
};

/// True while a CallCounter lives.
bool isCounting();

}  // namespace glibra::gpu
