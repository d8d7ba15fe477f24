#pragma once
// The header of an OpenEXR file ("OpenEXR File Layout"), as far as its sizes are to be judged before the
// library sees the file, and what is more than pixels in it.

#include <glibra/result.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "image/limits.h"

namespace glibra::image {

/// Both corners belong to the window.
struct ExrWindow {
    std::int32_t left = 0, top = 0, right = -1, bottom = -1;

    [[nodiscard]] std::uint64_t width() const;   ///< 0 if the corners are in the wrong order
    [[nodiscard]] std::uint64_t height() const;  ///< likewise
    bool operator==(const ExrWindow&) const = default;
};

enum class ExrNumber : std::uint32_t { whole = 0, half = 1, floating = 2 };

struct ExrChannel {
    std::string name;
    ExrNumber number = ExrNumber::half;
};

/// The header of one part.
struct ExrPart {
    ExrWindow data, display;
    std::vector<ExrChannel> channels;
    std::uint32_t tileWidth = 0, tileHeight = 0;  ///< 0: it has lines
    bool isDeep = false;
};

/// The first part of a file that is not deep, or the first part. Errors: file-E04 damaged; file-E09 a window
/// or a tile exceeds the limits.
Result<ExrPart> readExrHeader(std::span<const std::byte> file, const FileLabel& label,
                              const Limits& limits = {});

/// What two files may have different although the pictures that they show are equal: the places of the
/// windows, and the channels with their types, in words.
std::string describeExr(const ExrPart& part);

}  // namespace glibra::image
