#pragma once
// Sizes beyond which nothing is read (language, 11). Every product is computed with 64 bits and checked
// before memory is reserved.

#include <glibra/diagnostic.h>

#include <cstdint>
#include <optional>
#include <string>

namespace glibra::image {

inline constexpr std::uint64_t kGiB = std::uint64_t{1} << 30;

/// The largest picture that a caller accepts. The defaults are the limits for textures of a scene.
struct Limits {
    std::uint64_t fileBytes = 2 * kGiB;
    std::uint64_t texelBytes = kGiB;
    int side = 16384;
    int side3D = 2048;  ///< of a 3D texture
};

/// The name of a file in messages, and the place in the scene that refers to it.
struct FileLabel {
    std::string name;
    Place place;
};

/// file-E09 if width x height pixels of `bytesPerPixel` exceed the limits.
std::optional<Diagnostic> checkSize(std::uint64_t width, std::uint64_t height, std::uint64_t bytesPerPixel,
                                    const Limits& limits, const FileLabel& label);

/// "2.1 GiB", "300 MiB", "17 bytes".
std::string readableBytes(std::uint64_t bytes);

/// The messages of language, 8.2 that several readers report. `damaged` is file-E04: "'name': what".
Diagnostic damaged(const FileLabel& label, const std::string& what);

/// file-E04 for pixels that end too early: the file has only `rows` of `height` rows.
Diagnostic endsEarly(const FileLabel& label, std::uint64_t rows, std::uint64_t height);

}  // namespace glibra::image
