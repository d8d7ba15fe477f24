// The scenes that the pictures in textures/ are photographs of.
#pragma once

#include "march.h"

namespace generate {

Stage applesStage();     // a crate of apples, to be seen straight from above
Stage cherriesStage();   // a bowl of cherries on a checked cloth
Stage toysStage();       // a table with bright solids and a mirror ball
Stage lakeStage();       // a mountain lake in the evening
Stage villageStage();    // houses with red roofs below wooded hills
Stage roomStage();       // a room with things at many depths, for stereo pairs
Stage courtyardStage();  // a tiled court with columns, to be seen from its centre
Stage planetStage();     // only a sky: continents and seas by direction

}  // namespace generate
