#pragma once
// A suite as a value: pictures to render and to compare with goldens. suite_file.h reads it.

#include <glibra/diagnostic.h>
#include <glibra/render.h>

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image/compare/judge.h"

namespace glibra::suite {

/// The error that a scene is expected to have.
struct ExpectedError {
    std::string id;    ///< id of the diagnostic, as "glsl-E01"; empty: any error
    std::string text;  ///< part of its message; empty: any
    int line = 0;      ///< line of its place; 0: any
};

/// A uniform variable that a suite names, and where.
struct PlacedUniform {
    std::string name;  ///< "uKd", "Dots:uKd"
    Place place;
};

/// A rectangle of a picture in pixels, from the top left corner, that is left out of comparisons.
struct IgnoredRegion {
    int x = 0, y = 0, width = 1, height = 1;
    std::string until;  ///< the last day on which it is left out, as "2026-12-31"; empty: always
    Place place{};      ///< in the suite file
};

/// One picture.
struct Shot {
    /// Unique in its suite. It names files, so it is made of letters, digits, "._-=,@+", and "/" between
    /// parts: "teapot", "oval@uTol=0.1", "start/teapot@time=0.5".
    std::string name;
    std::filesystem::path script;
    RenderOptions options;
    image::Tolerance tolerance;
    bool statesTolerance =
        false;  ///< two drawings need only agree within the tolerance, which the suite states
    std::vector<IgnoredRegion> ignored;
    std::filesystem::path mask;  ///< a picture that is white where nothing is compared; or empty
    Place maskPlace;             ///< in the suite file
    int retries = 0;             ///< a shot that fails is drawn as often again; if one is right, it is flaky
    std::string quarantine;  ///< the last day on which its failures do not count, as "2026-12-31"; or empty
    double timeout = 300;    ///< seconds
    /// Bytes that the process that draws may take; 0: no limit; nothing: base::memoryShare().
    std::optional<std::uint64_t> memory;
    std::vector<std::string> tags;  ///< for --only tag:NAME
    std::optional<ExpectedError> expectedError;
    std::string match;   ///< another shot of the suite that must give the same picture, or empty
    std::string differ;  ///< another shot that must give a different picture, or empty
    bool golden = true;  ///< false: the picture is only compared with `match` and `differ`
    /// What the [[shot]] itself sets or sweeps. Empty if it has several scenes, because not all of them need
    /// to have every uniform.
    std::vector<PlacedUniform> ownUniforms;
    Place place;  ///< in the suite file
};

struct Suite {
    std::string name;               ///< the file's stem, or the folder's name
    std::filesystem::path file;     ///< the TOML file, or the folder of .glib files
    std::filesystem::path goldens;  ///< folder of the golden pictures
    std::string store{};  ///< where the pictures are whose goldens are pointers (picture_store.h); or empty
    std::vector<Shot> shots;  ///< in the order of the file; sweeps in the order of their values

    /// The shot of that name, or null.
    [[nodiscard]] const Shot* find(std::string_view shot) const {
        const auto found = std::ranges::find(shots, shot, &Shot::name);
        return found == shots.end() ? nullptr : &*found;
    }
};

/// A shot of a list of suites.
struct ShotReference {
    std::size_t suite = 0, shot = 0;
    friend auto operator<=>(const ShotReference&, const ShotReference&) = default;
};

// Days of the calendar, as suites write them: "2026-12-31". Two of them are compared as texts.

/// True if the text is a day that exists.
bool isDay(std::string_view text);
/// The present day, UTC.
std::string today();

}  // namespace glibra::suite
