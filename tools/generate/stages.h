// The scenes that the pictures in textures/ show.
#pragma once

#include "march.h"

namespace generate {

Stage applesStage();     // a crate of apples, seen straight from above
Stage cherriesStage();   // a bowl of cherries on a checked cloth
Stage toysStage();       // a table with bright solids and a mirror ball
Stage lakeStage();       // a mountain lake in the evening
Stage villageStage();    // houses with red roofs below wooded hills
Stage roomStage();       // a room with things at many depths, for stereo pairs
Stage courtyardStage();  // a tiled court with columns, seen from its centre
Stage planetStage();     // only a sky, which holds continents and seas by direction

}  // namespace generate
