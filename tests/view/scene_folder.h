#pragma once
// A scene in a folder of its own, and a session that shows it without a window.

#include <glibra/render.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "gpu/context/context.h"
#include "view/session/session.h"

namespace glibra::test {

/// One context that all tests of the program share.
gpu::Context& context();

/// A temporary folder with a scene and other files; the destructor removes it.
class SceneFolder {
  public:
    explicit SceneFolder(std::string_view scene, const std::map<std::string, std::string>& files = {});
    SceneFolder(const SceneFolder&) = delete;
    SceneFolder& operator=(const SceneFolder&) = delete;
    ~SceneFolder();

    [[nodiscard]] std::filesystem::path scene() const { return folder_ / "scene.glib"; }
    [[nodiscard]] std::filesystem::path operator/(std::string_view name) const { return folder_ / name; }
    /// Writes a file and makes its folders.
    void write(std::string_view name, std::string_view content) const;
    [[nodiscard]] std::string read(std::string_view name) const;

  private:
    std::filesystem::path folder_;
};

using Color = std::array<int, 3>;  ///< red, green and blue, 0..255

/// A pixel of the last picture; x and y count from the top left.
Color pixelOf(const view::Session& session, int x, int y);
/// The whole picture: RGB bytes, top row first.
std::vector<std::byte> pixelsOf(const view::Session& session);

/// The index of the knob with that tag; fails the test if there is none.
std::size_t knobIndex(const view::Session& session, std::string_view tag);

/// Changes all that a window of 300 x 200 pixels with ovalnoise.glib can change; picks the object at (x, y).
void changeOvalNoise(view::Session& session, int x, int y);

std::string text(const Diagnostics& diagnostics);

/// A vertex shader that only applies the matrices and passes texture coordinates.
inline constexpr const char* kPlainVertex =
    "#version 330\nout vec4 vST;\nvoid main() { vST = aTexCoord0; gl_Position = uModelViewProjectionMatrix * "
    "aVertex; }\n";

/// The beginning of a scene of 40 x 40 pixels, and a program of the files a.vert and a.frag.
inline const std::string kHead = "WindowSize 40 40\nOrtho -1 1 -1 1 -1 1\n",
                         kProgram = "Vertex a.vert\nFragment a.frag\nProgram P\n";

}  // namespace glibra::test
