#include "view/edit/example_folders.h"

#include <iterator>
#include <system_error>

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

bool isRoot(const fs::path& folder) {
    std::error_code failure;
    return fs::is_directory(folder / "glib", failure) && fs::is_directory(folder / "shaders", failure);
}

fs::path rootAbove(const fs::path& file) {
    std::error_code failure;
    fs::path folder = fs::absolute(file, failure).lexically_normal().parent_path();
    for (;; folder = folder.parent_path()) {
        if (isRoot(folder)) return folder;
        if (isRoot(folder / "share/glibra")) return folder / "share/glibra";
        if (!folder.has_relative_path()) return {};
    }
}

}  // namespace

fs::path exampleRoot(const std::vector<fs::path>& roots, const fs::path& scene, const fs::path& program) {
    for (const fs::path& each : roots)
        if (isRoot(each)) return each;
    for (const fs::path& each : {program, scene})
        if (!each.empty())
            if (fs::path root = rootAbove(each); !root.empty()) return root;
    return {};
}

fs::path programFile() {
    std::error_code failure;
    return fs::read_symlink("/proc/self/exe", failure);
}

bool isExample(const fs::path& file) {
    static const fs::path kRoot = rootAbove(programFile());
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
