#include "view/edit/example_folders.h"

#include <iterator>
#include <system_error>

#include "base/own_library.h"

namespace glibra::view {

namespace fs = std::filesystem;

fs::path exampleRoot(const std::vector<fs::path>& roots, const fs::path& scene, const fs::path& program) {
    for (const fs::path& each : roots)
        if (base::isLibrary(each)) return each;
    for (const fs::path& each : {program, scene})
        if (!each.empty())
            if (fs::path root = base::libraryAbove(each.parent_path()); !root.empty()) return root;
    return {};
}

bool isExample(const fs::path& file) {
    static const fs::path kRoot = base::ownLibrary();
    if (kRoot.empty() || file.empty()) return false;
    std::error_code failure;
    const fs::path inside = fs::weakly_canonical(file, failure).lexically_relative(kRoot);
    const fs::path first = inside.empty() ? inside : *inside.begin();
    return first == "glib" || first == "shaders" || first == "textures" ||
           (first == "scenes" && *std::next(inside.begin()) == "models");
}

Diagnostics writingProblem(const fs::path& file) {
    if (!isExample(file)) return {};
    return {diagnose("view-E03", "the folders of the examples are not written to; choose another one")};
}

}  // namespace glibra::view
