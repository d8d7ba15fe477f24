#pragma once
// What `glibra bench` measures: one row and one file per subject.

#include <span>

#include "bench/core/run.h"

namespace glibra::bench {

/// All subjects, in the order of the report.
std::span<const Subject> subjects();

/// Position, normal, outline and volume of the solids against closed forms, by slices and stacks; teapot and
/// soccer ball; a sphere as the driver draws it. Without a driver, the last figure is missing and gpu-E01 is
/// among the diagnostics.
std::vector<Figure> measurePrimitives(Bench& bench);

/// Tessellation shaders: largest and mean distance of a Bezier patch, an octant of a sphere and a PN
/// triangle; cracks along the shared edges of the teapot; gaps between neighbours of different levels.
std::vector<Figure> measureTessellation(Bench& bench);

/// Noise textures, error against size and texel format: interpolated on the CPU; octave by octave; drawn with
/// the filters of the driver and of the shader and with the function itself; across the border of the period.
std::vector<Figure> measureNoise(Bench& bench);

/// Samples per pixel and their weights, against the picture from very many samples or from an integral. One
/// figure per pattern: edges, a minified checkerboard, one in perspective, stripes.
std::vector<Figure> measureAntialiasing(Bench& bench);

/// Texture filters against very many samples, and the driver's arithmetic against double: a plane in
/// perspective, a surface seen from the front at many distances, magnification.
std::vector<Figure> measureMinification(Bench& bench);

/// Depth buffers, the smallest gap between two surfaces that is resolved: gap against far / near at the far
/// end, gap against distance, share of fighting pixels, cost.
std::vector<Figure> measureDepth(Bench& bench);

/// Objects far away and of all sizes, chained rotations, and normals under uneven scales; in float and
/// double, on the CPU and in a shader, against 100 digits. Without a driver, the curves of the shaders are
/// missing and gpu-E01 is among the diagnostics.
std::vector<Figure> measureTransforms(Bench& bench);

/// Lighting per vertex and per fragment against the analytic surface.
std::vector<Figure> measureLighting(Bench& bench);

/// A curve parameter accumulated or computed; chords of curves at fixed steps and by flatness; streamlines
/// with fixed and adaptive steps. Without a driver, the curve of the shader is missing and gpu-E01 is among
/// the diagnostics.
std::vector<Figure> measureCurves(Bench& bench);

/// Volume ray casting in steps against a fine integration.
std::vector<Figure> measureVolume(Bench& bench);

/// The Mandelbrot set by zoom, in float, double, long double and by perturbation, on the CPU and in shaders,
/// against 113 bits of mantissa. Without a driver, the curves of the shaders are missing and gpu-E01 is among
/// the diagnostics.
std::vector<Figure> measureFractals(Bench& bench);

/// The intersection of rays in float with a unit sphere, by the textbook formula and by stable ones, by
/// distance and for rays that graze it; against 100 digits. Without a driver, the curves of the shaders are
/// missing and gpu-E01 is among the diagnostics.
std::vector<Figure> measureRaySphere(Bench& bench);

/// Image filters, direct and separable, through bytes and floats.
std::vector<Figure> measureFilters(Bench& bench);

/// The functions of GLSL on this driver against long double.
std::vector<Figure> measureBuiltins(Bench& bench);

/// Claims of books about the speed of shaders: one figure per claim, named by the row of docs/coverage.md
/// that it answers. The first finding is the verdict: "true here, by 1.8 (1.7 .. 1.9)", "false here: ...", or
/// "no difference here".
std::vector<Figure> measureClaims(Bench& bench);

/// The scenes that ship with glibra: their time and their error.
std::vector<Figure> measureScenes(Bench& bench);

/// --max-error on the scenes of the library that declare values with Bound. One figure per bound: error and
/// time with the values that --max-error chooses, those of the scene, and the finest ones.
std::vector<Figure> measureBounds(Bench& bench);

/// --max-error over the scenes that ship with glibra: whether the bound holds, and its cost against the
/// default and against one resolution for all.
std::vector<Figure> measureBudget(Bench& bench);

}  // namespace glibra::bench
