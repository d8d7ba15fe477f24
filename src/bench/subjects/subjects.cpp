#include "bench/subjects/subjects.h"

#include <vector>

#include "bench/subjects/builtins.h"

namespace glibra::bench {

std::span<const Subject> subjects() {
    static const std::vector<Subject> table{
        {"primitives", "Primitives: slices and stacks against the analytic surface", measurePrimitives},
        {"tessellation", "Tessellation shaders: levels and spacings against analytic surfaces",
         measureTessellation},
        {"noise", "Noise textures: size and texel format against the function", measureNoise},
        {"antialiasing", "Antialiasing: samples per pixel and their filters", measureAntialiasing},
        {"minification", "Texture filters: minified and magnified, against many samples",
         measureMinification},
        {"depth", "Depth buffers: the smallest gap that is resolved", measureDepth},
        {"near-far", "Near and far of a scene: planes that fight", measureNearFar},
        {"shadows", "Shadow maps of a scene: their resolution and their offset", measureShadows},
        {"transforms", "Transforms: float and double against 100 digits", measureTransforms},
        {"lighting", "Lighting: per vertex and per fragment against the analytic surface", measureLighting},
        {"curves", "Curves and streamlines: fixed steps, adaptive steps, accumulated parameters",
         measureCurves},
        {"time", "Time and motion: hours as a float, and integrators in a shader", measureTime},
        {"volume", "Volume ray casting: steps against a fine integration", measureVolume},
        {"fractals", "Fractals: float and double by zoom", measureFractals},
        {"ray-sphere", "Ray and sphere: textbook and stable formulas", measureRaySphere},
        {"filters", "Image filters: direct and separable, through bytes and floats", measureFilters},
        {"layers", "Blending and accumulation: many layers, by the texels of the target", measureLayers},
        {"colors", "sRGB: round trips through linear light, by the curve and the texels", measureColors},
        {"builtins", "GLSL functions: their errors, and the errors that the specification allows",
         measureBuiltins},
        {"claims", "Claims of books about the speed of shaders: true here or not", measureClaims},
        {"scenes", "Shipped scenes: time and error of each, largest first", measureScenes},
        {"bounds", "--max-error on the scenes that declare values with Bound", measureBounds},
        {"budget", "--max-error on the shipped scenes: a bound instead of counts", measureBudget},
    };
    return table;
}

}  // namespace glibra::bench
