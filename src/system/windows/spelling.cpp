#include "system/spelling.h"

#include "system/windows/win.h"

namespace glibra::system {

std::filesystem::path asInFolders(const std::filesystem::path& path) {
    if (!path.has_relative_path()) {
        std::wstring drive = path.native();
        ::CharUpperW(drive.data());
        return drive;
    }
    std::filesystem::path name = path.filename();
    WIN32_FIND_DATAW found{};
    const bool isName =
        name != L"." && name != L".." && name.native().find_first_of(L"*?") == std::wstring::npos;
    const HANDLE search = isName ? ::FindFirstFileW(pathText(path).c_str(), &found) : INVALID_HANDLE_VALUE;
    if (search != INVALID_HANDLE_VALUE) name = found.cFileName;
    ::FindClose(search);
    return asInFolders(path.parent_path()) / name;
}

}  // namespace glibra::system
