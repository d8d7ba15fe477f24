#include "gpu/context/work_places.h"

#include <algorithm>
#include <utility>

namespace glibra::gpu {

void WorkPlaces::set(const Place& place) {
    current_ = place;
    if (std::exchange(isFinished_, false) || unfinished_.first.file != place.file) {
        unfinished_.first = place;  // keeps its memory: a frame of a moving scene allocates nothing
        unfinished_.lastLine = place.line;
    } else if (place.line < unfinished_.first.line) {
        unfinished_.first = place;
    } else {
        unfinished_.lastLine = std::max(unfinished_.lastLine, place.line);
    }
}

}  // namespace glibra::gpu
