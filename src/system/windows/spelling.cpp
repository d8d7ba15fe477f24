#include "system/spelling.h"

#include "system/windows/win.h"

namespace glibra::system {

std::filesystem::path nameInFolder(const std::filesystem::path& path) {
    WIN32_FIND_DATAW found{};
    const HANDLE search = ::FindFirstFileW(path.c_str(), &found);
    if (search == INVALID_HANDLE_VALUE) return path.filename();
    ::FindClose(search);
    return found.cFileName;
}

}  // namespace glibra::system
