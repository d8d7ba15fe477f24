#include "system/process.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cwctype>
#include <iterator>
#include <utility>

#include "system/places.h"
#include "system/windows/win.h"

#include <io.h>
#include <objbase.h>
#include <psapi.h>
#include <shellapi.h>
#include <shlwapi.h>

namespace glibra::system {
namespace {

/// The signal that another system would have ended a process with; 0: it has ended by itself.
int signalOf(DWORD status) {
    static constexpr std::pair<DWORD, int> kSignals[] = {
        {EXCEPTION_ACCESS_VIOLATION, SIGSEGV},
        {EXCEPTION_IN_PAGE_ERROR, SIGSEGV},
        {EXCEPTION_GUARD_PAGE, SIGSEGV},
        {EXCEPTION_STACK_OVERFLOW, SIGSEGV},
        {EXCEPTION_DATATYPE_MISALIGNMENT, SIGSEGV},
        {EXCEPTION_ARRAY_BOUNDS_EXCEEDED, SIGSEGV},
        {EXCEPTION_ILLEGAL_INSTRUCTION, SIGILL},
        {EXCEPTION_PRIV_INSTRUCTION, SIGILL},
        {EXCEPTION_FLT_DENORMAL_OPERAND, SIGFPE},
        {EXCEPTION_FLT_DIVIDE_BY_ZERO, SIGFPE},
        {EXCEPTION_FLT_INEXACT_RESULT, SIGFPE},
        {EXCEPTION_FLT_INVALID_OPERATION, SIGFPE},
        {EXCEPTION_FLT_OVERFLOW, SIGFPE},
        {EXCEPTION_FLT_STACK_CHECK, SIGFPE},
        {EXCEPTION_FLT_UNDERFLOW, SIGFPE},
        {EXCEPTION_INT_DIVIDE_BY_ZERO, SIGFPE},
        {EXCEPTION_INT_OVERFLOW, SIGFPE},
        {0xC0000017, kKilled},  // no memory
        {0xC0000374, SIGABRT},  // a damaged heap
        {0xC0000409, SIGABRT},  // __fastfail(), as by abort() of the universal C runtime
        {0x40000015, SIGABRT},  // a fatal exit
        {0xE06D7363, SIGABRT},  // an exception of C++ that nobody has caught
        {0x20474343, SIGABRT},  // the same of GCC
        {0xC000013A, SIGINT}};  // Ctrl+C
    const auto* const found = std::ranges::find(kSignals, status, &std::pair<DWORD, int>::first);
    if (found != std::end(kSignals)) return found->second;
    constexpr DWORD kNumber = 0xFF;
    return status > statusOfSignal(0) && status <= statusOfSignal(kNumber)
               ? static_cast<int>(status & kNumber)
               : 0;
}

/// Windows tells no signals, but the exit status is that of the exception. 3, the status of abort() in the
/// older C runtime, is also one of ours: leaveNoCore() lets abort() end otherwise.
End endOf(HANDLE process) {
    DWORD status = 0;
    End end;
    if (!::GetExitCodeProcess(process, &status)) return end;
    end.signal = signalOf(status);
    end.wasTimeLimit = end.signal == kTimeLimit;
    end.status = end.signal == 0 ? static_cast<int>(status) : 0;
    PROCESS_MEMORY_COUNTERS memory{};
    // What a limit of memory counts: that the process has asked for, wherever it is.
    if (::GetProcessMemoryInfo(process, &memory, sizeof memory)) end.peakMemory = memory.PeakPagefileUsage;
    return end;
}

double secondsOf(const FILETIME& time) {
    constexpr double kSeconds = 1e-7;
    return kSeconds * (4294967296. * time.dwHighDateTime + time.dwLowDateTime);
}

}  // namespace

Process::~Process() {
    if (handle_ != kNoHandle) std::unique_ptr<Started>(reinterpret_cast<Started*>(handle_));
}

int Process::number() const {
    return handle_ == kNoHandle ? -1 : static_cast<int>(::GetProcessId(winOf(*this)));
}

End waitFor(Process& process) {
    return *waitFor(process, 0);
}

std::optional<End> waitFor(Process& process, double seconds) {
    if (!process) return End{};
    constexpr double kLongest = 4e9;
    const DWORD wait =
        seconds > 0 ? static_cast<DWORD>(std::min(std::ceil(seconds * 1000), kLongest)) : INFINITE;
    if (::WaitForSingleObject(winOf(process), wait) == WAIT_TIMEOUT) return std::nullopt;
    const End end = endOf(winOf(process));
    process = Process();
    return end;
}

void kill(const Process& process) {
    if (!process) return;
    const Started& started = *reinterpret_cast<const Started*>(process.handle());
    ::TerminateJobObject(winOf(started.job), statusOfSignal(kKilled));
    ::TerminateProcess(winOf(started.process), statusOfSignal(kKilled));
}

int ownNumber() {
    return repeatsParent() ? parentNumber() : static_cast<int>(::GetCurrentProcessId());
}

bool isRunning(long long number) {
    if (number <= 0 || !std::in_range<DWORD>(number)) return false;
    const File process = ownOf(
        ::OpenProcess(SYNCHRONIZE | PROCESS_QUERY_LIMITED_INFORMATION, FALSE, static_cast<DWORD>(number)));
    if (!process) return ::GetLastError() == ERROR_ACCESS_DENIED;
    // The system also finds a process by the three numbers that follow its own.
    return ::GetProcessId(winOf(process)) == static_cast<DWORD>(number) &&
           ::WaitForSingleObject(winOf(process), 0) == WAIT_TIMEOUT;
}

/// Only where processes are copied has this a meaning.
bool hasOneThread() {
    return false;
}

double processorSecondsOf(const Process& process) {
    FILETIME made{}, ended{}, system{}, user{};
    if (!process || !::GetProcessTimes(winOf(process), &made, &ended, &system, &user)) return 0;
    return secondsOf(system) + secondsOf(user);
}

Process runInCopy(const std::function<void()>&) {
    errno = ENOSYS;
    return {};
}

void endBySignals() {}

/// A process is put into the job of its parent when it is started.
void endWithParent() {}

void onCopy(void (*)()) {}

// Starts programs. Each gets a job of its own, so that all that it starts can be ended with it, within the
// job of this process, so that all end with this one. A program gets its three streams and no other handle.

namespace {

namespace fs = std::filesystem;

/// The job of all processes that end with this one: the system closes it then. Detached ones may leave it.
HANDLE jobOfThisProcess() {
    static const File job = [] {
        File made = ownOf(::CreateJobObjectW(nullptr, nullptr));
        JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
        limits.BasicLimitInformation.LimitFlags =
            JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE | JOB_OBJECT_LIMIT_BREAKAWAY_OK;
        ::SetInformationJobObject(winOf(made), JobObjectExtendedLimitInformation, &limits, sizeof limits);
        return made;
    }();
    return winOf(job);
}

File newJob() {
    File job = ownOrErrno(::CreateJobObjectW(nullptr, nullptr));
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_BREAKAWAY_OK;
    ::SetInformationJobObject(winOf(job), JobObjectExtendedLimitInformation, &limits, sizeof limits);
    return job;
}

/// The attributes of a new process.
class Attributes {
  public:
    explicit Attributes(DWORD count) {
        SIZE_T size = 0;
        ::InitializeProcThreadAttributeList(nullptr, count, 0, &size);
        bytes_.resize(size);
        isMade_ = ::InitializeProcThreadAttributeList(list(), count, 0, &size) != 0;
    }
    Attributes(const Attributes&) = delete;
    Attributes& operator=(const Attributes&) = delete;
    ~Attributes() {
        if (isMade_) ::DeleteProcThreadAttributeList(list());
    }
    /// The handles stay where they are until the process is started.
    bool set(DWORD_PTR which, std::span<HANDLE> handles) {
        return isMade_ && ::UpdateProcThreadAttribute(list(), 0, which, handles.data(), handles.size_bytes(),
                                                      nullptr, nullptr) != 0;
    }
    LPPROC_THREAD_ATTRIBUTE_LIST list() {
        return reinterpret_cast<LPPROC_THREAD_ATTRIBUTE_LIST>(bytes_.data());
    }

  private:
    std::vector<std::byte> bytes_;
    bool isMade_ = false;
};

/// A copy of a handle that a new process may inherit.
File inheritable(HANDLE handle) {
    HANDLE copy = nullptr;
    const HANDLE self = ::GetCurrentProcess();
    if (!::DuplicateHandle(self, handle, self, &copy, 0, TRUE, DUPLICATE_SAME_ACCESS)) return {};
    return ownOf(copy);
}

File streamFor(const Stream& stream, DWORD which) {
    HANDLE handle = nullptr;
    if (stream.to == Stream::To::inherited) handle = standardHandle(which);
    if (stream.to == Stream::To::file) handle = winOf(*stream.file);
    if (stream.to == Stream::To::stream)
        handle = reinterpret_cast<HANDLE>(::_get_osfhandle(::_fileno(stream.stream)));
    File copy = handle == nullptr ? File() : inheritable(handle);
    if (copy || stream.to == Stream::To::file || stream.to == Stream::To::stream) return copy;
    const DWORD access = which == STD_INPUT_HANDLE ? GENERIC_READ : GENERIC_WRITE;
    return inheritable(winOf(openExisting(L"NUL", access, 0)));
}

/// The environment of this process with one variable more.
std::wstring environmentWith(const std::wstring& variable) {
    const std::wstring begin = variable.substr(0, variable.find(L'=') + 1);
    std::wstring block;
    wchar_t* const own = ::GetEnvironmentStringsW();
    for (const wchar_t* each = own; *each != L'\0'; each += std::wstring_view(each).size() + 1)
        if (begin.empty() || !std::wstring_view(each).starts_with(begin)) block += std::wstring(each) + L'\0';
    ::FreeEnvironmentStringsW(own);
    if (!variable.empty()) block += variable + L'\0';
    return block + L'\0';
}

void appendQuoted(std::wstring& line, const std::wstring& word) {
    if (!line.empty()) line += L' ';
    if (!word.empty() && word.find_first_of(L" \t\n\v\"") == std::wstring::npos) {
        line += word;
        return;
    }
    // Backslashes are doubled before a quotation mark, also before the last one, and nowhere else.
    std::size_t backslashes = 0;
    line += L'"';
    for (const wchar_t each : word) {
        if (each == L'"') line.append(backslashes + 1, L'\\');
        backslashes = each == L'\\' ? backslashes + 1 : 0;
        line += each;
    }
    line.append(backslashes, L'\\');
    line += L'"';
}

bool isBatch(const fs::path& program) {
    std::wstring suffix = program.extension().native();
    for (wchar_t& each : suffix) each = static_cast<wchar_t>(std::towlower(each));
    return suffix == L".bat" || suffix == L".cmd";
}

/// The file of a program whose name may lack its suffix; empty if there is none.
fs::path programAt(const fs::path& named) {
    std::wstring suffixes = variableText(L"PATHEXT");
    if (suffixes.empty()) suffixes = L".COM;.EXE;.BAT;.CMD";
    const std::wstring own = named.extension().native();
    for (std::wstring_view rest = suffixes; !rest.empty();) {
        const std::wstring suffix(rest.substr(0, rest.find(L';')));
        rest.remove_prefix(std::min(rest.size(), suffix.size() + 1));
        if (suffix.empty()) continue;
        const bool isWhole = ::CompareStringOrdinal(own.c_str(), -1, suffix.c_str(), -1, TRUE) == CSTR_EQUAL;
        const fs::path file = isWhole ? named : fs::path(named.native() + suffix);
        if (kindOf(file, Links::followed) == FileKind::regular) return file;
    }
    return {};
}

fs::path find(const fs::path& name) {
    if (name.has_parent_path()) return programAt(name);
    for (const fs::path& each : foldersIn("PATH"))
        if (const fs::path file = programAt(each / name); !file.empty()) return file;
    return {};
}

/// Why a file cannot be started, as an error number. The command processor takes command lines apart by rules
/// of its own, so that words for a batch file can become commands.
int problemOf(const fs::path& program) {
    if (program.empty()) return ENOENT;
    return isBatch(program) ? ENOEXEC : 0;
}

/// A new process without a window for its console where this one has no console.
DWORD windowFlags() {
    return ::GetConsoleWindow() == nullptr ? DWORD{CREATE_NO_WINDOW} : 0;
}

}  // namespace

std::wstring commandLine(const std::vector<std::string>& words) {
    std::wstring line;
    for (const std::string& each : words) appendQuoted(line, wideOf(each));
    return line;
}

Process start(const Start& start) {
    std::vector<File> copies;
    copies.push_back(streamFor(start.streams.input, STD_INPUT_HANDLE));
    copies.push_back(streamFor(start.streams.output, STD_OUTPUT_HANDLE));
    copies.push_back(streamFor(start.streams.error, STD_ERROR_HANDLE));
    std::wstring variable = start.variable;
    for (const HANDLE each : start.handles) {
        copies.push_back(inheritable(each));
        variable += L':' + std::to_wstring(copies.back().handle());
    }
    std::vector<HANDLE> handles;
    for (const File& each : copies) handles.push_back(winOf(each));
    auto started = std::make_unique<Started>(Started{File(), newJob()});
    std::array<HANDLE, 2> jobs{jobOfThisProcess(), winOf(started->job)};
    Attributes attributes(2);
    if (!started->job || !attributes.set(PROC_THREAD_ATTRIBUTE_HANDLE_LIST, handles) ||
        !attributes.set(PROC_THREAD_ATTRIBUTE_JOB_LIST, jobs)) {
        errno = lastErrno();
        return {};
    }
    STARTUPINFOEXW how{};
    how.StartupInfo.cb = sizeof how;
    how.StartupInfo.dwFlags = STARTF_USESTDHANDLES;
    how.StartupInfo.hStdInput = handles[0];
    how.StartupInfo.hStdOutput = handles[1];
    how.StartupInfo.hStdError = handles[2];
    how.lpAttributeList = attributes.list();
    std::wstring line = commandLine(start.words);
    std::wstring environment = environmentWith(variable);
    PROCESS_INFORMATION made{};
    if (!::CreateProcessW(start.program.c_str(), line.data(), nullptr, nullptr, TRUE,
                          EXTENDED_STARTUPINFO_PRESENT | CREATE_UNICODE_ENVIRONMENT | windowFlags(),
                          environment.data(), nullptr, &how.StartupInfo, &made)) {
        errno = lastErrno();
        return {};
    }
    ::CloseHandle(made.hThread);
    started->process = ownOf(made.hProcess);
    return Process(reinterpret_cast<std::intptr_t>(started.release()));
}

Process startProgram(const std::vector<std::string>& words, const Streams& streams) {
    const fs::path program = words.empty() ? fs::path() : find(fs::path(wideOf(words.front())));
    errno = problemOf(program);
    return errno == 0 ? start({.program = program, .words = words, .streams = streams}) : Process();
}

Process startAgain(const std::vector<std::string>& words, const Streams& streams) {
    return start({.program = programFile(), .words = words, .streams = streams});
}

std::string startDetached(const std::vector<std::string>& words) {
    const fs::path program = words.empty() ? fs::path() : find(fs::path(wideOf(words.front())));
    if (program.empty()) return textOf(ERROR_FILE_NOT_FOUND);
    if (isBatch(program)) return "batch files cannot be given words safely; name the program itself";
    STARTUPINFOW how{};
    how.cb = sizeof how;
    PROCESS_INFORMATION made{};
    const auto tryWith = [&](DWORD flags) {
        std::wstring line = commandLine(words);
        return ::CreateProcessW(program.c_str(), line.data(), nullptr, nullptr, FALSE,
                                flags | DETACHED_PROCESS | CREATE_NEW_PROCESS_GROUP, nullptr, nullptr, &how,
                                &made) != 0;
    };
    // Who has put this program into a job may not let it start others outside of it.
    if (!tryWith(CREATE_BREAKAWAY_FROM_JOB) && !tryWith(0)) return textOf(::GetLastError());
    ::CloseHandle(made.hThread);
    ::CloseHandle(made.hProcess);
    return {};
}

std::string openForUser(const fs::path& file) {
    const std::wstring& name = file.native();
    const bool isAddress = name.starts_with(L"http://") || name.starts_with(L"https://");
    const FileKind kind = isAddress ? FileKind::other : kindOf(file, Links::followed);
    if (kind == FileKind::missing) return textOf(ERROR_FILE_NOT_FOUND);
    // To open such a file would be to run it, or what it names.
    const bool isRun = programAt(file) == file || ::AssocIsDangerous(file.extension().c_str());
    if (kind == FileKind::regular && isRun) return "it is a program";
    std::error_code failure;
    const std::wstring whole = isAddress ? name : fs::absolute(file, failure).make_preferred().native();
    SHELLEXECUTEINFOW how{};
    how.cbSize = sizeof how;
    how.fMask = SEE_MASK_NOASYNC | SEE_MASK_FLAG_NO_UI;
    how.lpVerb = L"open";
    how.lpFile = whole.c_str();
    how.nShow = SW_SHOWNORMAL;
    const bool isReady =
        SUCCEEDED(::CoInitializeEx(nullptr, COINIT_APARTMENTTHREADED | COINIT_DISABLE_OLE1DDE));
    const std::string problem = ::ShellExecuteExW(&how) ? std::string() : textOf(::GetLastError());
    if (isReady) ::CoUninitialize();
    return problem;
}

const char* usualEditor() {
    return "notepad";
}

/// Windows has no exec: this process waits for the other one, which is ended with it.
int becomeProgram(const fs::path& program, const std::vector<std::string>& arguments) {
    const fs::path file = programAt(program);
    if (const int problem = problemOf(file); problem != 0) return problem;
    std::vector<std::string> words{narrowOf(file.native())};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::fflush(nullptr);
    const Process process = start({.program = file, .words = words});
    if (!process) return errno;
    // Ctrl+C is for the other one. Unlike a call without a function, this is not inherited.
    ::SetConsoleCtrlHandler([](DWORD) -> BOOL { return TRUE; }, TRUE);
    DWORD status = 0;
    ::WaitForSingleObject(winOf(process), INFINITE);
    ::GetExitCodeProcess(winOf(process), &status);
    restoreConsole();
    ::ExitProcess(status);
}

fs::path findInPath(const std::string& name) {
    return find(fs::path(wideOf(name)).filename());
}

bool isProgram(const fs::path& file) {
    return !programAt(file).empty();
}

int makeInputOf(File& reading, File& writing) {
    return makePipeEnds(PipeEnd::writes, writing, reading);
}

int sendAll(const File& writing, std::span<const std::byte> bytes) {
    return writeAll(writing, bytes);
}

// What a process of this program gets from the one that has started it: numbers in a variable of its
// environment, among them handles.

namespace {

std::vector<std::uint64_t> take(const wchar_t* name) {
    std::vector<std::uint64_t> numbers;
    const std::wstring value = variableText(name);
    ::SetEnvironmentVariableW(name, nullptr);
    for (const wchar_t* rest = value.c_str(); *rest != L'\0';) {
        wchar_t* end = nullptr;
        numbers.push_back(std::wcstoull(rest, &end, 10));
        if (end == rest) return {};  // somebody else has set it
        rest = *end == L':' ? end + 1 : end;
    }
    return numbers;
}

struct Inheritance {
    std::vector<std::uint64_t> ofWorker = take(kWorkerVariable), ofChild = take(kChildVariable);
};

Inheritance& inheritance() {
    static Inheritance all;
    return all;
}

}  // namespace

bool takeInheritance() {
    const Inheritance& all = inheritance();
    return !all.ofWorker.empty() || !all.ofChild.empty();
}

std::vector<std::uint64_t> inherited(const wchar_t* name) {
    Inheritance& all = inheritance();
    return std::exchange(std::wstring_view(name) == kWorkerVariable ? all.ofWorker : all.ofChild, {});
}

File takeHandle(std::uint64_t value) {
    const auto handle = reinterpret_cast<HANDLE>(static_cast<std::uintptr_t>(value));
    return ::SetHandleInformation(handle, HANDLE_FLAG_INHERIT, 0) ? ownOf(handle) : File();
}

}  // namespace glibra::system
