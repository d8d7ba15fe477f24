#pragma once
// What `glibra bench` measures: a table of the subjects, and the function that measures each.

#include <span>

#include "bench/core/run.h"

namespace glibra::bench {

/// All subjects, in the order of the report.
std::span<const Subject> subjects();

// Each gives its figures (those with parts of their own are declared beside these), and throws Failed if it
// has none. Without a driver, what needs none is measured all the same, and gpu-E01 is among the problems of
// `bench`.
std::vector<Figure> measurePrimitives(Bench& bench);
/// Parts of the primitives: distance and normals of the teapot's meshes, by the cells per side of a patch.
/// The last point is that of the teapot of scenes.
std::vector<Figure> teapotFigures(const Bench& bench);
std::vector<Figure> measureTessellation(Bench& bench);
std::vector<Figure> measureNearFar(Bench& bench);
std::vector<Figure> measureShadows(Bench& bench);
std::vector<Figure> measureTransforms(Bench& bench);
std::vector<Figure> measureCurves(Bench& bench);
std::vector<Figure> measureTime(Bench& bench);
std::vector<Figure> measureFractals(Bench& bench);
std::vector<Figure> measureRaySphere(Bench& bench);
std::vector<Figure> measureNoise(Bench& bench);
std::vector<Figure> measureAntialiasing(Bench& bench);
std::vector<Figure> measureMinification(Bench& bench);
std::vector<Figure> measureDepth(Bench& bench);
std::vector<Figure> measureFilters(Bench& bench);
std::vector<Figure> measureVolume(Bench& bench);
std::vector<Figure> measureLighting(Bench& bench);
std::vector<Figure> measureLayers(Bench& bench);
std::vector<Figure> measureColors(Bench& bench);
/// One figure per claim, named by the row of docs/coverage.md that it answers. The first finding is the
/// verdict: "true here, by 1.8 (1.7 .. 1.9)", "false here: ...", or "no difference here".
std::vector<Figure> measureClaims(Bench& bench);
std::vector<Figure> measureScenes(Bench& bench);
std::vector<Figure> measureBounds(Bench& bench);
std::vector<Figure> measureBudget(Bench& bench);

}  // namespace glibra::bench
