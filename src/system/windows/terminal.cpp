#include "system/terminal.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>

#include "system/memory.h"
#include "system/windows/win.h"

#include <fcntl.h>
#include <io.h>

namespace glibra::system {
namespace {

constexpr DWORD kStandard[] = {STD_INPUT_HANDLE, STD_OUTPUT_HANDLE, STD_ERROR_HANDLE};

HANDLE handleOf(Standard stream) {
    return standardHandle(kStandard[static_cast<int>(stream)]);
}

/// What the console was like before.
struct Console {
    UINT codePage = 0;  ///< 0: not changed
    HANDLE screen = nullptr;
    DWORD mode = 0;
};
Console before;

/// Output is UTF-8, and colours are what they are on other terminals.
void prepareConsole() {
    for (const Standard each : {Standard::output, Standard::error}) {
        DWORD mode = 0;
        const HANDLE screen = handleOf(each);
        if (screen == nullptr || !::GetConsoleMode(screen, &mode)) continue;
        if (const UINT page = ::GetConsoleOutputCP(); page != CP_UTF8 && ::SetConsoleOutputCP(CP_UTF8))
            before.codePage = page;
        if ((mode & ENABLE_VIRTUAL_TERMINAL_PROCESSING) == 0 &&
            ::SetConsoleMode(screen, mode | ENABLE_PROCESSED_OUTPUT | ENABLE_VIRTUAL_TERMINAL_PROCESSING)) {
            before.screen = screen;
            before.mode = mode;
        }
    }
}

/// The null device for a stream that is closed. Its mode is the wrong one for the stream on purpose: a
/// picture for a closed standard output must be an error and not vanish.
bool openNull(int number) {
    const DWORD access = number == 0 ? GENERIC_WRITE : GENERIC_READ;
    const HANDLE null = ::CreateFileW(L"NUL", access, kShareAll, nullptr, OPEN_EXISTING, 0, nullptr);
    if (null == INVALID_HANDLE_VALUE) return false;
    // The C runtime does not give away the numbers of closed streams by itself.
    const int open = ::_open_osfhandle(reinterpret_cast<std::intptr_t>(null), _O_BINARY);
    if (open < 0) return false;
    if (open != number) {
        const bool isCopied = ::_dup2(open, number) == 0;
        ::_close(open);
        if (!isCopied) return false;
    }
    return ::SetStdHandle(kStandard[number], reinterpret_cast<HANDLE>(::_get_osfhandle(number))) != 0;
}

/// Reads standard input on a thread of its own, since Windows cannot wait for a pipe that somebody else has
/// made, nor for a whole line of a console.
class InputReader {
  public:
    InputReader() {
        std::thread([this] { run(); }).detach();
    }

    bool waitFor(int milliseconds) {
        std::unique_lock lock(mutex_);
        const auto isReady = [&] { return !bytes_.empty() || isEnded_; };
        if (milliseconds >= 0)
            return changed_.wait_for(lock, std::chrono::milliseconds(milliseconds), isReady);
        changed_.wait(lock, isReady);
        return true;
    }

    int take(std::span<char> bytes, std::size_t& count) {
        waitFor(-1);
        const std::scoped_lock lock(mutex_);
        count = std::min(bytes.size(), bytes_.size());
        std::copy_n(bytes_.begin(), count, bytes.begin());
        bytes_.erase(0, count);
        changed_.notify_all();
        return count == 0 ? problem_ : 0;
    }

  private:
    void run() {
        constexpr std::size_t kMostWaiting = std::size_t{1} << 20U;
        std::array<char, 1 << 16> block{};
        for (bool isMore = true; isMore;) {
            std::size_t count = 0;
            const DWORD error = readOnce(handleOf(Standard::input), block.data(), block.size(), count);
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [&] { return bytes_.size() < kMostWaiting; });
            bytes_.append(block.data(), count);
            isMore = error == ERROR_SUCCESS && count > 0;
            isEnded_ = !isMore;
            problem_ = errnoOf(error);
            changed_.notify_all();
        }
    }

    std::mutex mutex_;
    std::condition_variable changed_;
    std::string bytes_;
    bool isEnded_ = false;
    int problem_ = 0;
};

/// From the first question on, all input goes through the reader. It lives as long as its thread.
InputReader* reader = nullptr;

}  // namespace

void restoreConsole() {
    if (before.codePage != 0) ::SetConsoleOutputCP(before.codePage);
    if (before.screen != nullptr) ::SetConsoleMode(before.screen, before.mode);
    before = {};
}

bool openStandardFiles() noexcept {
    ::SetErrorMode(SEM_FAILCRITICALERRORS);  // no question about a drive without a disk
    if (takeInheritance()) leaveNoCore();    // nobody looks at questions of a helper
    for (int number = 0; number <= 2; ++number) {
        const bool isOpen = ::_get_osfhandle(number) >= 0 && standardHandle(kStandard[number]) != nullptr;
        if (!isOpen && !openNull(number)) return false;
        ::_setmode(number, _O_BINARY);
    }
    std::setvbuf(stderr, nullptr, _IONBF, 0);  // Wine's C runtime keeps what goes to a file or a pipe
    prepareConsole();
    std::atexit(restoreConsole);
    return true;
}

bool isTerminal(Standard stream) {
    DWORD mode = 0;
    return ::GetConsoleMode(handleOf(stream), &mode) != 0;
}

std::size_t terminalColumns() {
    constexpr std::size_t kUsual = 80;
    CONSOLE_SCREEN_BUFFER_INFO screen{};
    if (!::GetConsoleScreenBufferInfo(handleOf(Standard::error), &screen)) return kUsual;
    const int columns = screen.srWindow.Right - screen.srWindow.Left + 1;
    return columns > 0 ? static_cast<std::size_t>(columns) : kUsual;
}

bool isSameFile(Standard first, Standard second) {
    const HANDLE a = handleOf(first), b = handleOf(second);
    if (isTerminal(first) || isTerminal(second)) return isTerminal(first) && isTerminal(second);
    if (::GetFileType(a) == FILE_TYPE_DISK && ::GetFileType(b) == FILE_TYPE_DISK) return isSame(a, b);
    // Windows 10 and later; not in the libraries of MinGW.
    using Compare = BOOL(WINAPI*)(HANDLE, HANDLE);
    const HMODULE library = ::GetModuleHandleW(L"kernelbase.dll");
    const auto compare = reinterpret_cast<Compare>(reinterpret_cast<void*>(
        library != nullptr ? ::GetProcAddress(library, "CompareObjectHandles") : nullptr));
    return a == b || (compare != nullptr && compare(a, b));
}

int readInput(std::span<char> bytes, std::size_t& count) {
    if (reader != nullptr) return reader->take(bytes, count);
    return errnoOf(readOnce(handleOf(Standard::input), bytes.data(), bytes.size(), count));
}

std::optional<bool> isInputReady(int milliseconds) {
    if (reader == nullptr && ::GetFileType(handleOf(Standard::input)) == FILE_TYPE_DISK) return true;
    try {
        if (reader == nullptr) reader = std::make_unique<InputReader>().release();
    } catch (const std::system_error&) {
        return true;  // without a thread, reading waits
    }
    return reader->waitFor(milliseconds);
}

int writeOutput(std::string_view text) {
    const HANDLE output = handleOf(Standard::output);
    constexpr std::size_t kMostAtOnce = std::size_t{1} << 15U;  // what old consoles take
    while (!text.empty()) {
        DWORD put = 0;
        const auto size = static_cast<DWORD>(std::min(text.size(), kMostAtOnce));
        if (!::WriteFile(output, text.data(), size, &put, nullptr)) return lastErrno();
        text.remove_prefix(put);
    }
    return 0;
}

}  // namespace glibra::system
