#include <vector>

#include "bench/antialiasing.h"
#include "bench/budget.h"
#include "bench/builtins.h"
#include "bench/curves.h"
#include "bench/depth.h"
#include "bench/filters.h"
#include "bench/fractals.h"
#include "bench/lighting.h"
#include "bench/minification.h"
#include "bench/noise_textures.h"
#include "bench/primitives.h"
#include "bench/ray_sphere.h"
#include "bench/scenes.h"
#include "bench/subject.h"
#include "bench/tessellation.h"
#include "bench/transforms.h"
#include "bench/volume.h"

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
        {"transforms", "Transforms: float and double against 100 digits", measureTransforms},
        {"lighting", "Lighting: by vertex and by fragment against the analytic surface", measureLighting},
        {"curves", "Curves and streamlines: fixed, adaptive, summed up", measureCurves},
        {"volume", "Volume ray casting: steps against a fine integration", measureVolume},
        {"fractals", "Fractals: float and double by zoom", measureFractals},
        {"ray-sphere", "Ray and sphere: textbook and stable formulas", measureRaySphere},
        {"filters", "Image filters: direct and separable, through bytes and floats", measureFilters},
        {"builtins", "GLSL functions: units in the last place, and what the specification allows",
         measureBuiltins},
        {"scenes", "Shipped scenes: time and error of each, largest first", measureScenes},
        {"budget", "A bound instead of counts: --max-error on the shipped scenes", measureBudget},
    };
    return table;
}

}  // namespace glibra::bench
