#pragma once
// The ways to reach OpenGL, and their words on the command line.

#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace glibra {

/// Which GL the pictures are drawn with. `automatic` tries EGL without a surface, then an EGL device, then
/// OSMesa; on Windows WGL, then OSMesa. `gles` is OpenGL ES 3.0, what browsers have as WebGL 2: it draws what
/// a live page shows, and has no geometry, tessellation and compute stages.
enum class Driver { automatic, egl, eglDevice, osmesa, wgl, gles };

inline constexpr std::array<std::pair<std::string_view, Driver>, 6> kDriverWords{{
    {"auto", Driver::automatic},
    {"egl", Driver::egl},
    {"egl-device", Driver::eglDevice},
    {"osmesa", Driver::osmesa},
    {"wgl", Driver::wgl},
    {"gles", Driver::gles},
}};

/// The driver's word: "egl-device".
constexpr std::string_view word(Driver driver) {
    for (const auto& [word, each] : kDriverWords)
        if (each == driver) return word;
    return kDriverWords.front().first;
}

/// The driver of a word, if there is one.
constexpr std::optional<Driver> driverOfWord(std::string_view word) {
    for (const auto& [each, driver] : kDriverWords)
        if (each == word) return driver;
    return std::nullopt;
}

}  // namespace glibra
