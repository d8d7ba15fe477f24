#pragma once
// What `glibra info` prints. `glibra-bench precision` prints the same and adds to it.

#include <glibra/diagnostic.h>

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gpu/context/context.h"
#include "image/compare/judge.h"

namespace glibra::cli {

/// Lines for a terminal, the version of glibra first.
std::string infoText(const gpu::Context& context);

/// The same as an object.
nlohmann::ordered_json infoJson(const gpu::Context& context);

// What subcommands print with --json.

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
