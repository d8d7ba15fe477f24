#pragma once
// The statements of a scene that the device works for.

#include <glibra/diagnostic.h>

namespace glibra::gpu {

class WorkPlaces {
  public:
    /// What is asked of the device from now on is for this place.
    void set(const Place& place);
    [[nodiscard]] const Place& current() const { return current_; }

    /// The places since the device was known to be idle.
    struct Unfinished {
        Place first;       ///< without a file: none
        int lastLine = 0;  ///< the last one in the same file
    };
    [[nodiscard]] Unfinished unfinished() const { return isFinished_ ? Unfinished{} : unfinished_; }
    /// The device has done all that it was given.
    void finish() { isFinished_ = true; }

  private:
    Place current_;
    Unfinished unfinished_;
    bool isFinished_ = true;  ///< the next place is the first unfinished one
};

}  // namespace glibra::gpu
