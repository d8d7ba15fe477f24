#include "image/limits.h"

#include <fmt/format.h>

#include "base/text.h"

namespace glibra::image {

std::optional<Diagnostic> checkSize(std::uint64_t width, std::uint64_t height, std::uint64_t bytesPerPixel,
                                    const Limits& limits, const FileLabel& label) {
    const auto side = static_cast<std::uint64_t>(limits.side);
    if (width > side || height > side)
        return diagnose(
            "file-E09",
            fmt::format("'{}' has {} x {} pixels, the limit is {} per side", label.name, width, height, side),
            label.place);
    const std::uint64_t bytes = width * height * bytesPerPixel;
    if (bytes > limits.texelBytes)
        return diagnose(
            "file-E09",
            fmt::format("'{}' has {} of pixels ({} x {}), the limit is {}", label.name,
                        base::readableBytes(bytes), width, height, base::readableBytes(limits.texelBytes)),
            label.place);
    return checkSceneBytes(bytes, limits, fmt::format("'{}'", label.name), label.place);
}

std::optional<Diagnostic> checkSceneBytes(std::uint64_t bytes, const Limits& limits, const std::string& what,
                                          const Place& place) {
    if (bytes <= limits.sceneBytesLeft) return std::nullopt;
    return diagnose(
        "draw-E08",
        fmt::format("{} needs {}, but the textures of a scene may have {} together, and {} are left", what,
                    base::readableBytes(bytes), base::readableBytes(kSceneTexelBytes),
                    base::readableBytes(limits.sceneBytesLeft)),
        place);
}

std::optional<Diagnostic> checkInflation(std::uint64_t width, std::uint64_t height, std::uint64_t fileBytes,
                                         const FileLabel& label) {
    // A blank fax of 8192 x 8192 pixels may have 1 KB, so pictures up to this size pass. Beyond it, a byte of
    // TIFF with LZW holds 21,845 pixels at most, and every other common packing less.
    constexpr std::uint64_t kAlwaysPass = std::uint64_t{8192} * 8192;
    constexpr std::uint64_t kMostPerByte = 21'845;
    if (width * height <= kAlwaysPass || width * height / kMostPerByte <= fileBytes) return std::nullopt;
    return damaged(label, fmt::format("{} bytes cannot hold {} x {} pixels", fileBytes, width, height));
}

std::optional<Diagnostic> checkPacked(std::uint64_t width, std::uint64_t height, std::uint64_t bytesPerPixel,
                                      std::uint64_t fileBytes, const Limits& limits, const FileLabel& label) {
    if (auto tooLarge = checkSize(width, height, bytesPerPixel, limits, label)) return tooLarge;
    return checkInflation(width, height, fileBytes, label);
}

Diagnostic damaged(const FileLabel& label, const std::string& what) {
    return diagnose("file-E04", fmt::format("'{}': {}", label.name, what), label.place);
}

Diagnostic endsEarly(const FileLabel& label, std::uint64_t rows, std::uint64_t height) {
    return damaged(label, fmt::format("pixel data end after row {} of {}", rows, height));
}

}  // namespace glibra::image
