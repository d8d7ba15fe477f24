#pragma once
// What subcommands print with --json.

#include <glibra/diagnostic.h>

#include <string>
#include <vector>

#include "image/compare/judge.h"

namespace glibra::cli {

/// What `glibra check` found in one scene.
struct CheckedScene {
    std::string scene;
    Diagnostics diagnostics;
};

/// A list with one object per scene, and a line end.
std::string toJson(const std::vector<CheckedScene>& scenes);

/// The figures of `glibra compare`, and a line end. A figure that is infinite is null.
std::string toJson(const image::Judgement& judged, const image::Image& expected, const image::Image& got,
                   const image::Tolerance& tolerance);

/// The text in quotes, in ASCII.
std::string jsonText(const std::string& text);

/// The part of the picture's pixels that differ, 0 to 1.
double differingFraction(const image::Comparison& found, const image::Image& picture);

}  // namespace glibra::cli
