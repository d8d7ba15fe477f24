#pragma once
// Shared by the tests of `scene`: scenes from text, and temporary folders.

#include <filesystem>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/interpret.h"

namespace glibra::scene::tests {

/// Parses and interprets the text. The path matters only for files. The script itself must have no errors.
Scene run(std::string_view text, const std::filesystem::path& path = "scene.glib",
          const InterpretOptions& options = {});

/// A script that can be run for several moments. It must have no errors.
Interpretation scriptOf(std::string_view text, const std::filesystem::path& path = "scene.glib");
Scene sceneAt(Interpretation& script, double time);

/// All draws of all passes, in order.
std::vector<Draw> drawsOf(const Scene& scene);
/// The only draw.
Draw drawOf(std::string_view text);

/// Where its model's origin stands before the eye.
glm::dvec3 placeOf(const Draw& draw);
/// What Set and the tags of the draw give to a uniform; null if they do not.
const glib::UniformSpec* uniformOf(const Scene& scene, const Draw& draw, std::string_view tag);
/// Its values; none if it has none.
std::vector<double> uniformValues(const Scene& scene, const Draw& draw, std::string_view tag);

/// The ids in order: "glib-W31 glib-E06".
std::string idsOf(const Diagnostics& diagnostics);
/// One line per message: "3:1 glib-W31 text".
std::string textsOf(const Diagnostics& diagnostics);

/// A new temporary folder. The destructor removes it with its content.
class TemporaryFolder {
  public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Writes a file and makes the folders of its path.
    std::filesystem::path write(const std::filesystem::path& name, std::string_view content = "x") const;

  private:
    std::filesystem::path path_;
};

}  // namespace glibra::scene::tests
