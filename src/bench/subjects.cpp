#include <vector>

#include "bench/antialiasing.h"
#include "bench/depth.h"
#include "bench/minification.h"
#include "bench/noise_textures.h"
#include "bench/primitives.h"
#include "bench/subject.h"
#include "bench/tessellation.h"

namespace glibra::bench {

std::span<const Subject> subjects() {
    static const std::vector<Subject> table{
        {"primitives", "Primitives: slices and stacks against the analytic surface", measurePrimitives},
        {"tessellation", "Tessellation shaders: levels and spacings against analytic surfaces",
         measureTessellation},
        {"noise", "Noise textures: size and texel format against the function", measureNoise},
        {"antialiasing", "Antialiasing: samples a pixel and their filters", measureAntialiasing},
        {"minification", "Texture filters: minified and magnified, against many samples",
         measureMinification},
        {"depth", "Depth buffers: the smallest gap that is told apart", measureDepth},
    };
    return table;
}

}  // namespace glibra::bench
