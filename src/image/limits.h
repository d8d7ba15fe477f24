#pragma once
// Sizes beyond which nothing is read (language, 11). Every product is computed with 64 bits and checked
// before memory is reserved.

#include <glibra/diagnostic.h>

#include <cstdint>
#include <optional>
#include <string>

namespace glibra::image {

inline constexpr std::uint64_t kGiB = std::uint64_t{1} << 30;

/// What the pictures, raw textures and noise textures of a scene may have together.
inline constexpr std::uint64_t kSceneTexelBytes = 2 * kGiB;

/// The largest picture that a caller accepts. The defaults are the limits for textures of a scene.
struct Limits {
    std::uint64_t fileBytes = 2 * kGiB;
    std::uint64_t texelBytes = kGiB;
    int side = 16384;
    int side3D = 2048;  ///< of a 3D texture
    /// What the textures of a scene may still have together.
    std::uint64_t sceneBytesLeft = kSceneTexelBytes;
};

/// The name of a file in messages, and the place in the scene that refers to it.
struct FileLabel {
    std::string name;
    Place place;
};

/// file-E09 if width x height pixels of `bytesPerPixel` exceed the limits; draw-E08 if they exceed what is
/// left for the scene.
std::optional<Diagnostic> checkSize(std::uint64_t width, std::uint64_t height, std::uint64_t bytesPerPixel,
                                    const Limits& limits, const FileLabel& label);

/// draw-E08 if `bytes` are more than is left for the scene. `what` names the texture, as "'a.png'".
std::optional<Diagnostic> checkSceneBytes(std::uint64_t bytes, const Limits& limits, const std::string& what,
                                          const Place& place);

/// file-E04 if a file is so short that it cannot hold the pixels that it announces. No format packs them
/// without bound, but some readers make a picture of what a damaged file lacks.
std::optional<Diagnostic> checkInflation(std::uint64_t width, std::uint64_t height, std::uint64_t fileBytes,
                                         const FileLabel& label);

/// checkSize, then checkInflation.
std::optional<Diagnostic> checkPacked(std::uint64_t width, std::uint64_t height, std::uint64_t bytesPerPixel,
                                      std::uint64_t fileBytes, const Limits& limits, const FileLabel& label);

/// The messages of language, 8.2 that several readers report. `damaged` is file-E04: "'name': what".
Diagnostic damaged(const FileLabel& label, const std::string& what);

/// file-E04 for pixels that end too early: the file has only `rows` of `height` rows.
Diagnostic endsEarly(const FileLabel& label, std::uint64_t rows, std::uint64_t height);

}  // namespace glibra::image
