#pragma once
// Counts what a driver is asked to do, at the table of GL functions that every call passes through. Tests use
// it to verify the skip rules.

#include <cstdint>

namespace glibra::gpu {

struct CallCounts {
    std::uint64_t calls = 0;           ///< of any GL function
    std::uint64_t draws = 0;           ///< glDraw*
    std::uint64_t programsLinked = 0;  ///< glLinkProgram
    std::uint64_t texturesFilled = 0;  ///< glTexSubImage*; a cube map counts six
    std::uint64_t buffersFilled = 0;   ///< glBufferData with content, glBufferSubData
    std::uint64_t bytesUploaded = 0;   ///< of both, as they lie in the caller's memory
    std::uint64_t pixelsRead = 0;      ///< glReadPixels
    std::uint64_t fences = 0;          ///< glFenceSync
};

/// Counts every GL call of the process while it lives. Without a counter, calls cost nothing extra. Only the
/// newest counter counts; an outer one continues when the inner one has ended.
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

/// True while a CallCounter exists.
bool isCounting();

}  // namespace glibra::gpu
