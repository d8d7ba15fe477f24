#include "view/edit/example_folders.h"

#include <system_error>

#include "base/own_library.h"
#include "base/text.h"

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
    // Windows has the folder by names in any case, too.
    for (fs::path at = fs::weakly_canonical(file, failure); at.has_relative_path(); at = at.parent_path())
        for (const fs::path each : {"glib", "shaders", "textures", "scenes/models"})
            if (base::sameWord(at.filename().generic_string(), each.filename().generic_string()) &&
                fs::equivalent(at, kRoot / each, failure))
                return true;
    return false;
}

Diagnostics writingProblem(const fs::path& file) {
    if (!isExample(file)) return {};
    return {diagnose("view-E03", "the folders of the examples are not written to; choose another one")};
}

}  // namespace glibra::view
