#include "base/own_library.h"

#include <system_error>

#include "system/places.h"

namespace glibra::base {

namespace fs = std::filesystem;

bool isLibrary(const fs::path& folder) {
    std::error_code failure;
    return fs::is_directory(folder / "glib", failure) && fs::is_directory(folder / "shaders", failure);
}

fs::path libraryAbove(fs::path folder) {
    std::error_code failure;
    folder = fs::absolute(folder.empty() ? "." : folder, failure).lexically_normal();
    for (;; folder = folder.parent_path()) {
        for (const fs::path& each : {folder, folder / "share/glibra"})
            if (isLibrary(each)) return each;
        if (!folder.has_relative_path()) return {};
    }
}

fs::path ownLibrary() {
    const fs::path program = system::programFile();
    return program.empty() ? fs::path() : libraryAbove(program.parent_path());
}

}  // namespace glibra::base
