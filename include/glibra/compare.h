#pragma once
// Compares pictures as golden-image tests do.

#include <glibra/diagnostic.h>
#include <glibra/export.h>
#include <glibra/render.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace glibra {

/// The differences that pass, as in suites (docs/suites.md). The defaults pass what differs between drivers
/// and between processors, which nobody sees. With a number that is not finite, below 0 or above the range of
/// the value nothing is the same (library-E01).
struct Tolerance {
    double largest = 3;            ///< 255ths of the range by which any component may differ
    double fraction = 0.0003;      ///< share of the pixels that may differ by more
    int cluster = 8;               ///< pixels that differ by more and touch
    int line = 16;                 ///< pixels that differ by more in one row or column
    double bias = 1;               ///< 255ths that the mean difference over a block of 16 x 16 pixels may be
    std::optional<double> flip{};  ///< mean FLIP (0..1) that passes where the five above fail
    std::optional<double> structure{};  ///< structural difference (0..1) likewise
    double relative = 1e-4;             ///< of two float pictures, in place of `largest`
    double absolute = 1e-6;
    bool exact = false;  ///< only equal values pass
};

struct Comparison {
    bool same = false;
    std::string reason;                 ///< one sentence with the figure that decided and its limit
    std::uint64_t differingPixels = 0;  ///< pixels that differ at all
    double largest = 0;  ///< difference of a component, 255ths of the range; of wide whole numbers in ones
    int x = 0, y = 0;    ///< where, from the top left
    double rootMeanSquare = 0;                  ///< 255ths
    std::optional<double> flip{}, structure{};  ///< if the tolerance asks for them or they decided
    Diagnostics diagnostics;  ///< why a file could not be read; then `same` is false and `reason` says it. Or
                              ///< file-W19: other programs may show another picture of a file
};

/// Compares a picture with the expected one. Files are of any format that glibra reads. Whole numbers of 32
/// bits or with a sign are the same if they differ by at most `absolute`; nothing else of the tolerance
/// counts for them.
[[nodiscard]] GLIBRA_API Comparison compare(const Picture& got, const Picture& expected,
                                            const Tolerance& tolerance = {});
[[nodiscard]] GLIBRA_API Comparison compare(const std::filesystem::path& got,
                                            const std::filesystem::path& expected,
                                            const Tolerance& tolerance = {});
[[nodiscard]] GLIBRA_API Comparison compare(const Picture& got, const std::filesystem::path& expected,
                                            const Tolerance& tolerance = {});

}  // namespace glibra
