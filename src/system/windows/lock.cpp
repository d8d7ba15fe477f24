// Locks are files that are open without sharing: whoever opens them next fails until the first one closes
// them or ends.

#include <cerrno>

#include "system/file.h"
#include "system/windows/win.h"

namespace glibra::system {

namespace fs = std::filesystem;

/// A folder is locked by a file in it, which the system removes when it is closed, however that comes.
Lock::Try Lock::takeFolder(const fs::path& folder, Wait wait) {
    release();
    if (repeatsParent()) return Try::taken;
    if (kindOf(folder, Links::followed) != FileKind::folder) return Try::missing;
    const fs::path file = folder / L".glibra-lock";
    constexpr DWORD kPause = 10;
    constexpr int kMostRefused = 10;
    for (int refused = 0;;) {
        file_ = ownOf(::CreateFileW(pathText(file).c_str(), GENERIC_WRITE | DELETE, 0, nullptr, OPEN_ALWAYS,
                                    FILE_ATTRIBUTE_HIDDEN | FILE_FLAG_DELETE_ON_CLOSE, nullptr));
        isTaken_ = static_cast<bool>(file_);
        if (isTaken_) return Try::taken;
        // For a moment, a file that is being removed cannot be opened either; for longer, only one in a
        // folder where this user may make none.
        const bool isHeld = ::GetLastError() == ERROR_SHARING_VIOLATION;
        if (isHeld && wait == Wait::no) return Try::held;
        if (!isHeld && (::GetLastError() != ERROR_ACCESS_DENIED || ++refused > kMostRefused))
            return Try::none;
        ::Sleep(kPause);
    }
}

Lock::Try Lock::takeNewFile(const fs::path& file) {
    release();
    if (repeatsParent()) return Try::taken;
    PrivateAccess access;
    // Others may read it; they cannot remove it.
    file_ = ownOrErrno(::CreateFileW(pathText(file).c_str(), GENERIC_READ | GENERIC_WRITE,
                                     FILE_SHARE_READ | FILE_SHARE_WRITE, access.attributes(), CREATE_NEW,
                                     FILE_ATTRIBUTE_NORMAL, nullptr));
    owner_ = ownNumber();
    isTaken_ = static_cast<bool>(file_);
    return isTaken_ ? Try::taken : Try::missing;
}

void Lock::release() {
    file_.close();
    isTaken_ = false;
}

bool removeUnlessLocked(const fs::path& file) {
    if (repeatsParent()) return false;
    const File opened = openExisting(file, DELETE, FILE_FLAG_OPEN_REPARSE_POINT);
    if (!opened) return ::GetLastError() == ERROR_SHARING_VIOLATION;
    removeOpen(winOf(opened));
    return false;
}

}  // namespace glibra::system
