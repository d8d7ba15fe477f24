#pragma once
// Lists the GL calls of a frame, with the places in the scene that they are made for (--trace).

#include <cstdarg>
#include <cstddef>
#include <string>
#include <vector>

#include "gpu/context/work_places.h"

namespace glibra::gpu {

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

/// The trace that lives; null if there is none.
CallTrace* activeTrace();

}  // namespace glibra::gpu
