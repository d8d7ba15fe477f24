#pragma once

#include <glibra/draw_id.h>

#include <map>
#include <string>

#include "base/raster_state.h"

namespace glibra::view {

/// A draw of the frame that is drawn with another state than the scene says, to try that.
struct TriedState {
    std::string word;           ///< the command that draws
    base::RasterState ofScene;  ///< as the scene says
    base::RasterState wanted;
    friend bool operator==(const TriedState&, const TriedState&) = default;
};
using TriedStates = std::map<DrawId, TriedState>;

}  // namespace glibra::view
