#pragma once
// Draws a scene twice, with every skip rule and with none, and records the GL calls, bytes and files of each.

#include <glibra/render.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "gpu/context/call_counter.h"
#include "gpu/context/context.h"
#include "render/load/shared_parts.h"
#include "render/stats.h"

namespace glibra::test {

/// A temporary folder with a scene and the files that it names.
class SceneFolder {
  public:
    explicit SceneFolder(const std::string& scene, const std::map<std::string, std::string>& files = {});
    SceneFolder(const SceneFolder&) = delete;
    SceneFolder& operator=(const SceneFolder&) = delete;
    ~SceneFolder();

    void write(const std::string& file, const std::string& content) const;
    [[nodiscard]] std::filesystem::path operator/(const std::string& file) const { return path_ / file; }

  private:
    std::filesystem::path path_;
};

struct Drawing {
    std::vector<std::byte> pixels;
    gpu::CallCounts calls;
    render::Stats stats;
    std::set<std::string> opened;  ///< files of the folder, as the operating system reports them
    Diagnostics diagnostics;

    [[nodiscard]] std::uint64_t count(const std::string& name) const;
    /// The reasons of everything of that kind that was skipped.
    [[nodiscard]] std::vector<std::string> skipped(const std::string& what) const;
};

/// Draws `scene.glib` of the folder at each of `times`, with the context that all tests share. Fails the test
/// if there is no picture.
Drawing draw(const SceneFolder& folder, const RenderOptions& options = {},
             render::SharedParts* shared = nullptr, const std::vector<double>& times = {0});

struct BothWays {
    Drawing skipping, whole;
};
/// Draws both ways. Fails the test unless the pictures are equal bit for bit.
BothWays drawBothWays(const SceneFolder& folder, RenderOptions options = {});

/// The shared context.
gpu::Context& sharedContext();

}  // namespace glibra::test
