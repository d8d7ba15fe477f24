// Text, paths and errors of Windows in the terms of this program.

#include <algorithm>
#include <cerrno>
#include <utility>

#include "system/windows/win.h"

namespace glibra::system {

std::wstring wideOf(std::string_view text) {
    const int size = static_cast<int>(text.size());
    const int length = ::MultiByteToWideChar(CP_UTF8, 0, text.data(), size, nullptr, 0);
    std::wstring wide(static_cast<std::size_t>(length), L'\0');
    ::MultiByteToWideChar(CP_UTF8, 0, text.data(), size, wide.data(), length);
    return wide;
}

std::string narrowOf(std::wstring_view text) {
    const int size = static_cast<int>(text.size());
    const int length = ::WideCharToMultiByte(CP_UTF8, 0, text.data(), size, nullptr, 0, nullptr, nullptr);
    std::string narrow(static_cast<std::size_t>(length), '\0');
    ::WideCharToMultiByte(CP_UTF8, 0, text.data(), size, narrow.data(), length, nullptr, nullptr);
    return narrow;
}

int errnoOf(DWORD error) {
    // MinGW does not know the names ERROR_STOPPED_ON_SYMLINK, ERROR_ELEVATION_REQUIRED and
    // ERROR_DISK_QUOTA_EXCEEDED.
    constexpr DWORD kStoppedOnLink = 681, kNeedsAdministrator = 740, kOverQuota = 1295;
    static constexpr std::pair<DWORD, int> kNumbers[] = {
        {ERROR_SUCCESS, 0},
        {ERROR_FILE_NOT_FOUND, ENOENT},
        {ERROR_PATH_NOT_FOUND, ENOENT},
        {ERROR_INVALID_DRIVE, ENOENT},
        {ERROR_BAD_NETPATH, ENOENT},
        {ERROR_BAD_NET_NAME, ENOENT},
        {ERROR_BAD_PATHNAME, ENOENT},
        {ERROR_INVALID_NAME, ENOENT},  // no file has a name like "a?"
        {ERROR_NOT_READY, ENOENT},     // a drive without a disk
        {ERROR_TOO_MANY_OPEN_FILES, EMFILE},
        {ERROR_ACCESS_DENIED, EACCES},
        {ERROR_SHARING_VIOLATION, EACCES},
        {ERROR_LOCK_VIOLATION, EACCES},
        {ERROR_DELETE_PENDING, EACCES},
        {ERROR_CANT_ACCESS_FILE, EACCES},
        {ERROR_NETWORK_ACCESS_DENIED, EACCES},
        {ERROR_USER_MAPPED_FILE, EACCES},
        {ERROR_PRIVILEGE_NOT_HELD, EPERM},
        {kNeedsAdministrator, EPERM},
        {ERROR_WRITE_PROTECT, EROFS},
        {ERROR_INVALID_HANDLE, EBADF},
        {ERROR_NOT_ENOUGH_MEMORY, ENOMEM},
        {ERROR_OUTOFMEMORY, ENOMEM},
        {ERROR_COMMITMENT_LIMIT, ENOMEM},
        {ERROR_NOT_ENOUGH_QUOTA, ENOMEM},
        {ERROR_NO_SYSTEM_RESOURCES, ENOMEM},
        {ERROR_DISK_FULL, ENOSPC},
        {ERROR_HANDLE_DISK_FULL, ENOSPC},
        {kOverQuota, ENOSPC},
        {ERROR_FILE_EXISTS, EEXIST},
        {ERROR_ALREADY_EXISTS, EEXIST},
        {ERROR_BROKEN_PIPE, EPIPE},
        {ERROR_NO_DATA, EPIPE},
        {ERROR_PIPE_NOT_CONNECTED, EPIPE},
        {ERROR_BAD_PIPE, EPIPE},
        {ERROR_NOT_SAME_DEVICE, EXDEV},
        {ERROR_DIR_NOT_EMPTY, ENOTEMPTY},
        {ERROR_DIRECTORY, ENOTDIR},
        {ERROR_INVALID_PARAMETER, EINVAL},
        {ERROR_NEGATIVE_SEEK, EINVAL},
        {ERROR_FILENAME_EXCED_RANGE, ENAMETOOLONG},
        {ERROR_CANT_RESOLVE_FILENAME, ELOOP},
        {kStoppedOnLink, ELOOP},
        {ERROR_INVALID_FUNCTION, ENOTSUP},
        {ERROR_NOT_SUPPORTED, ENOTSUP},
        {ERROR_CALL_NOT_IMPLEMENTED, ENOTSUP},
        {ERROR_FILE_TOO_LARGE, EFBIG},
        {ERROR_BAD_EXE_FORMAT, ENOEXEC},
        {ERROR_EXE_MACHINE_TYPE_MISMATCH, ENOEXEC},
        {ERROR_BUSY, EBUSY},
        {ERROR_PIPE_BUSY, EBUSY},
        {ERROR_OPERATION_ABORTED, ECANCELED}};
    const auto* const found = std::ranges::find(kNumbers, error, &std::pair<DWORD, int>::first);
    return found == std::end(kNumbers) ? EIO : found->second;
}

int lastErrno() {
    return errnoOf(::GetLastError());
}

std::string textOf(DWORD error) {
    wchar_t* text = nullptr;
    const DWORD length = ::FormatMessageW(
        FORMAT_MESSAGE_ALLOCATE_BUFFER | FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, nullptr,
        error, 0, reinterpret_cast<wchar_t*>(&text), 0, nullptr);
    std::string words = length > 0 ? narrowOf({text, length}) : "error " + std::to_string(error);
    ::LocalFree(text);
    while (!words.empty() && std::string_view(".\r\n ").find(words.back()) != std::string_view::npos)
        words.pop_back();
    return words;
}

std::wstring pathText(const std::filesystem::path& path) {
    constexpr std::size_t kLongest = 247;  // of a folder; MAX_PATH without the 8.3 name of a file
    const std::wstring& named = path.native();
    if (named.starts_with(LR"(\\?\)") || named.starts_with(LR"(\\.\)")) return named;
    const DWORD size = ::GetFullPathNameW(named.c_str(), 0, nullptr, nullptr);
    if (size <= kLongest) return named;
    std::wstring whole(size, L'\0');
    whole.resize(::GetFullPathNameW(named.c_str(), size, whole.data(), nullptr));
    return whole.starts_with(LR"(\\)") ? LR"(\\?\UNC)" + whole.substr(1) : LR"(\\?\)" + whole;
}

std::wstring variableText(const wchar_t* name) {
    std::wstring value;
    DWORD size = ::GetEnvironmentVariableW(name, nullptr, 0);
    while (size > value.size()) {
        value.resize(size);
        size = ::GetEnvironmentVariableW(name, value.data(), size);
    }
    value.resize(size);
    return value;
}

File ownOrErrno(HANDLE handle) {
    File file = ownOf(handle);
    if (!file) errno = lastErrno();
    return file;
}

HANDLE standardHandle(DWORD which) {
    const HANDLE handle = ::GetStdHandle(which);
    return handle == INVALID_HANDLE_VALUE ? nullptr : handle;
}

}  // namespace glibra::system
