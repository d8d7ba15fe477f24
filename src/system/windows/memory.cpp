#include "system/memory.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <limits>
#include <system_error>
#include <thread>

#include "system/places.h"
#include "system/windows/win.h"

#include <psapi.h>

namespace glibra::system {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failWith(int number) {
    throw std::system_error(number, std::generic_category());
}

[[noreturn]] void endAtOnce(UINT status) {
    ::TerminateProcess(::GetCurrentProcess(), status);
    ::ExitProcess(status);
}

/// Memory that this process has asked for, which Windows counts and limits, whether it is used or not.
std::uint64_t ownBytes() {
    PROCESS_MEMORY_COUNTERS memory{};
    ::GetProcessMemoryInfo(::GetCurrentProcess(), &memory, sizeof memory);
    return memory.PagefileUsage;
}

bool limitJob(HANDLE job, std::uint64_t bytes) {
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    if (bytes > 0) limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_PROCESS_MEMORY;
    limits.BasicLimitInformation.LimitFlags |= JOB_OBJECT_LIMIT_BREAKAWAY_OK;
    limits.ProcessMemoryLimit = bytes;
    return ::SetInformationJobObject(job, JobObjectExtendedLimitInformation, &limits, sizeof limits) != 0;
}

/// A further job for this process. It lasts as long as the process, also when its handle is closed.
File enterNewJob() {
    File job = ownOf(::CreateJobObjectW(nullptr, nullptr));
    if (job && !::AssignProcessToJobObject(winOf(job), ::GetCurrentProcess())) return {};
    return job;
}

/// The limit of MemoryLimit::set(); 0: none.
std::atomic<std::uint64_t> limitNow = 0;

std::uint64_t sum(std::uint64_t base, std::uint64_t bytes) {
    return bytes < std::numeric_limits<std::uint64_t>::max() - base ? base + bytes : 0;
}

void setLimit(std::uint64_t bytes) {
    static const File job = enterNewJob();
    if (job && limitJob(winOf(job), bytes)) limitNow = bytes;
}

}  // namespace

/// Windows gives memory when it is written, but counts it at once.
SharedMemory::SharedMemory(std::size_t size) {
    if (void* memory = ::VirtualAlloc(nullptr, size, MEM_RESERVE | MEM_COMMIT, PAGE_READWRITE))
        bytes_ = {static_cast<std::byte*>(memory), size};
}

SharedMemory::~SharedMemory() {
    if (!bytes_.empty()) ::VirtualFree(bytes_.data(), 0, MEM_RELEASE);
}

/// A file in the user's folder for temporary files, which the system tries to keep in memory. The system
/// could not remove it by itself: other code could not open it then.
MemoryFile::MemoryFile(const fs::path&) {
    std::uint64_t random = 0;
    std::error_code failure;
    const fs::path folder = fs::temp_directory_path(failure);
    if (failure || !fillWithRandom(std::as_writable_bytes(std::span(&random, 1)))) failWith(EIO);
    const fs::path path = folder / (L"glibra-" + std::to_wstring(random) + L".tmp");
    PrivateAccess access;
    file_ = ownOrErrno(::CreateFileW(pathText(path).c_str(), GENERIC_READ | GENERIC_WRITE, kShareAll,
                                     access.attributes(), CREATE_NEW, FILE_ATTRIBUTE_TEMPORARY, nullptr));
    if (!file_) failWith(errno);
    path_ = narrowOf(path.native());
}

MemoryFile::~MemoryFile() {
    file_.close();
    ::DeleteFileW(pathText(wideOf(path_)).c_str());
}

void MemoryFile::write(std::span<const std::byte> bytes) const {
    if (!::SetFilePointerEx(winOf(file_), {}, nullptr, FILE_BEGIN)) failWith(lastErrno());
    if (const int problem = writeAll(file_, bytes); problem != 0) failWith(problem);
}

std::vector<unsigned char> MemoryFile::content() const {
    LARGE_INTEGER size{};
    if (!::GetFileSizeEx(winOf(file_), &size) || !::SetFilePointerEx(winOf(file_), {}, nullptr, FILE_BEGIN))
        failWith(lastErrno());
    std::vector<unsigned char> bytes(static_cast<std::size_t>(size.QuadPart));
    std::size_t count = 0;
    const int problem = readFull(file_, std::as_writable_bytes(std::span(bytes)), count);
    if (problem != 0 || count < bytes.size()) failWith(problem != 0 ? problem : EIO);
    return bytes;
}

MemoryLimit::MemoryLimit() : base_(ownBytes()) {}

void MemoryLimit::set(std::uint64_t bytes) const {
    if (bytes > 0 || limitNow > 0) setLimit(bytes > 0 ? sum(base_, bytes) : 0);
}

void MemoryLimit::lower(std::uint64_t bytes) const {
    const std::uint64_t wanted = bytes > 0 ? sum(base_, bytes) : 0;
    if (wanted > 0 && (limitNow == 0 || wanted < limitNow)) setLimit(wanted);
}

LiftedMemoryLimit::LiftedMemoryLimit() : before_(limitNow) {
    if (before_ == 0) return;
    taken_ = ownBytes();
    setLimit(0);
}

LiftedMemoryLimit::~LiftedMemoryLimit() {
    if (before_ > 0) setLimit(before_ + std::max(ownBytes(), taken_) - taken_);
}

/// Nobody can change the limit of a job that has no name and no handle.
void MemoryLimit::setForever(std::uint64_t bytes) const {
    const std::uint64_t wanted = bytes > 0 ? sum(base_, bytes) : 0;
    if (wanted == 0) return;
    if (const File job = enterNewJob(); job) limitJob(winOf(job), wanted);
}

/// A thread looks, as the system does for its own limits of time.
void limitProcessorTime(double seconds) {
    std::thread([seconds = std::ceil(seconds)] {
        const double processors = std::max(1U, std::thread::hardware_concurrency());
        constexpr double kLongest = 3600, kShortest = .02;
        for (;;) {
            const double left = seconds - processorSeconds();
            if (left <= 0) endAtOnce(statusOfSignal(kTimeLimit));
            ::Sleep(static_cast<DWORD>(1000 * std::clamp(left / processors, kShortest, kLongest)));
        }
    }).detach();
}

/// Nor is the user asked, nor a report written: the exit status tells enough.
void leaveNoCore() {
    ::SetErrorMode(SEM_FAILCRITICALERRORS | SEM_NOGPFAULTERRORBOX);
    ::SetUnhandledExceptionFilter(
        [](EXCEPTION_POINTERS* found) -> LONG { endAtOnce(found->ExceptionRecord->ExceptionCode); });
    std::signal(SIGABRT, [](int signal) { endAtOnce(statusOfSignal(signal)); });
}

/// Windows has no such limit.
void failBeyondLargestFile() {}

void endAfter(unsigned seconds) {
    static HANDLE timer = nullptr;
    if (timer != nullptr) ::DeleteTimerQueueTimer(nullptr, timer, nullptr);
    timer = nullptr;
    if (seconds == 0) return;
    const auto end = [](void*, BOOLEAN) { endAtOnce(statusOfSignal(kAlarm)); };
    constexpr DWORD kMilliseconds = 1000;
    ::CreateTimerQueueTimer(&timer, nullptr, end, nullptr, kMilliseconds * DWORD{seconds}, 0,
                            WT_EXECUTEINTIMERTHREAD);
}

void stepBack() {
    ::SetPriorityClass(::GetCurrentProcess(), BELOW_NORMAL_PRIORITY_CLASS);
}

}  // namespace glibra::system
