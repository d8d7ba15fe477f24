#pragma once
// Counts what a driver is asked to do, at the table of GL functions that every call passes through. Tests use
// it to verify the skip rules.

#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "gpu/context/errors.h"

namespace glibra::gpu {

// Lists the GL calls of a frame, with the places in the scene that they are made for (--trace).

/// The arguments of a call. A va_list alone may be a copy where it is handed on.
struct CallArguments {
    va_list list;
};

/// Lists every GL call of the process while it lives, as long as a CallCounter lives too. There is one at a
/// time.
class CallTrace {
  public:
    /// `places` must outlive the trace.
    explicit CallTrace(const WorkPlaces& places);
    CallTrace(const CallTrace&) = delete;
    CallTrace& operator=(const CallTrace&) = delete;
    ~CallTrace();

    /// A line `scene.glib:12` before the calls made for that place, then one indented line per call, or per
    /// run of equal calls: `glUniform4fv(3, 1, ...) x 2`. Arrays, and functions that a frame rarely calls,
    /// are shown as dots.
    [[nodiscard]] std::string text() const;

    /// Adds a call with its arguments. The callback of CallCounter calls this.
    void add(const char* name, int argumentCount, CallArguments& arguments);

  private:
    struct Call {
        Place place;
        std::string text;
        std::size_t times = 1;
    };
    const WorkPlaces& places_;
    std::vector<Call> calls_;
};

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
