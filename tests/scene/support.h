#pragma once
// What the tests of this room share: scenes from text, folders that vanish again.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/interpret.h"

namespace glibra::scene::tests {

/// Parses and interprets; the path only matters for files. The script must have no errors of its own.
Scene run(std::string_view text, const std::filesystem::path& path = "scene.glib",
          const InterpretOptions& options = {});

/// All draws of all passes, in order.
std::vector<Draw> drawsOf(const Scene& scene);
/// The only draw.
Draw drawOf(std::string_view text);

/// "glib-W31 glib-E06": ids in order.
std::string idsOf(const Diagnostics& diagnostics);
/// "3:1 glib-W31 text"
std::string textsOf(const Diagnostics& diagnostics);

/// A folder of its own below the temporary one, removed with everything in it.
class TemporaryFolder {
  public:
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Writes a file, with its folders.
    std::filesystem::path write(const std::filesystem::path& name, std::string_view content = "x") const;

  private:
    std::filesystem::path path_;
};

}  // namespace glibra::scene::tests
