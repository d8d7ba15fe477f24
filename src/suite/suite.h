#pragma once
// A suite: pictures to render and to hold against goldens, as values. suite_file.h reads them.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image/compare/judge.h"

namespace glibra::suite {

/// A scene that has to fail, and how.
struct ExpectedError {
    std::string id;    ///< of a diagnostic, as "glsl-E01"; empty: any error
    std::string text;  ///< that its message contains; empty: any
    int line = 0;      ///< of its place; 0: any
};

/// A uniform that a suite names, and where.
struct PlacedUniform {
    std::string name;  ///< "uKd", "Dots:uKd"
    Place place;
};

/// One picture.
struct Shot {
    /// Unique in its suite; letters, digits and "._-=,@+" and '/' between parts, so that it names files:
    /// "teapot", "oval@uTol=0.1", "start/teapot@time=0.5".
    std::string name;
    std::filesystem::path script;
    RenderOptions options;
    image::Tolerance tolerance;
    double timeout = 300;           ///< seconds
    std::vector<std::string> tags;  ///< for --only tag:NAME
    std::optional<ExpectedError> expectedError;
    std::string match;   ///< another shot of the suite that has to give the same picture; empty: none
    std::string differ;  ///< another shot that has to give a different one; empty: none
    bool golden = true;  ///< false: the picture is only compared with `match` and `differ`
    /// What the [[shot]] itself sets or sweeps; empty if it means several scenes, which need not all have it.
    std::vector<PlacedUniform> ownUniforms;
    Place place;  ///< in the suite file
};

struct Suite {
    std::string name;               ///< the file's stem, or the folder's name
    std::filesystem::path file;     ///< the TOML file, or the folder of .glib files
    std::filesystem::path goldens;  ///< folder of the golden pictures
    std::vector<Shot> shots;        ///< in the order of the file; sweeps in the order of their values
};

}  // namespace glibra::suite
