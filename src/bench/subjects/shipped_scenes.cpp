#include "bench/subjects/shipped_scenes.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <system_error>

#include "base/own_library.h"

namespace glibra::bench {
namespace {

namespace fs = std::filesystem;

struct Finest {
    std::string_view scene;
    std::vector<std::string> set;
};

const std::vector<Finest>& finestLevels() {
    static const std::vector<Finest> table{
        {"tessellation/adaptive_spheres", {"uDetail=60"}},
        {"tessellation/bezier_curve", {"uOuter1=50"}},
        {"tessellation/bezier_surface", {"uOuter02=50", "uOuter13=50", "uInner0=50", "uInner1=50"}},
        {"tessellation/octant", {"uOuter0=50", "uOuter1=50", "uOuter2=50", "uInner=50"}},
        {"tessellation/pn_triangles", {"uOuter=20", "uInner=20"}},
        {"tessellation/spheres", {"uDetail=200"}}};
    return table;
}

/// Empty if there is none.
fs::path library() {
    if (const char* variable = std::getenv("GLIBRA_PATH")) {
        std::istringstream folders(variable);
        for (std::string each; std::getline(folders, each, ':');)
            if (!each.empty() && base::isLibrary(each)) return each;
    }
    std::error_code failure;
    if (fs::path found = base::libraryAbove(fs::current_path(failure)); !found.empty()) return found;
    return base::ownLibrary();
}

}  // namespace

Result<std::vector<ShippedScene>> shippedScenes() {
    const fs::path root = library();
    std::vector<ShippedScene> scenes;
    std::error_code failure;
    if (!root.empty())
        for (fs::recursive_directory_iterator at(root / "glib", failure), end; at != end;
             at.increment(failure)) {
            if (failure) break;
            const fs::path& path = at->path();
            if (path.extension() != ".glib") continue;
            ShippedScene scene{path.parent_path().filename().string() + "/" + path.stem().string(), path, {}};
            for (const Finest& each : finestLevels())
                if (each.scene == scene.name) scene.finest = each.set;
            scenes.push_back(std::move(scene));
        }
    if (scenes.empty())
        return diagnose(
            "file-E01",
            "cannot find the scenes of the library: no folder with 'glib' and 'shaders' in GLIBRA_PATH, "
            "above the current folder or above the program");
    std::ranges::sort(scenes, {}, &ShippedScene::name);
    return scenes;
}

}  // namespace glibra::bench
