// Makes trouble for a program of Windows, as other programs and users do. Prints nothing but errors; the exit
// status is that of the program, or 99 if there was nothing to do it to.
//
//   glibra_trouble crash MILLISECONDS PROGRAM WORD...
//       an access violation in a worker of it that has computed for so long
//
//   glibra_trouble kill MILLISECONDS PROGRAM WORD...
//       TerminateProcess() of that worker, as the task manager does
//
//   glibra_trouble ctrl-c MILLISECONDS PROGRAM WORD...
//       Ctrl+C in the console of both, when a worker has computed for so long
//
//   glibra_trouble hold FILE
//       has the file open, which nobody else may open, until its input ends
//
//   glibra_trouble number
//       prints the number of its process, and waits until its input ends
//
//   curl --disable ... --output FILE ... --url ADDRESS
//       under this name, as glibra starts it: a server whose files lie in the folder that the variable SERVED
//       names
//
//   ffmpeg -nostdin ... file:FILE
//       under this name, too: writes its words, one a line, and its input to the file

#include <windows.h>

#include <shellapi.h>
#include <tlhelp32.h>

#include <cstdio>
#include <string>
#include <vector>

namespace {

constexpr int kNothingDone = 99;

/// The processes that this one has started.
std::vector<HANDLE> workersOf(DWORD parent) {
    const HANDLE all = CreateToolhelp32Snapshot(TH32CS_SNAPPROCESS, 0);
    PROCESSENTRY32W each{};
    each.dwSize = sizeof each;
    std::vector<HANDLE> found;
    for (BOOL is = Process32FirstW(all, &each); is; is = Process32NextW(all, &each))
        if (each.th32ParentProcessID == parent)
            if (const HANDLE process = OpenProcess(PROCESS_ALL_ACCESS, FALSE, each.th32ProcessID);
                process != nullptr)
                found.push_back(process);
    CloseHandle(all);
    return found;
}

/// Has a handler, so that Ctrl+C does not end this process; unlike a call without one, it is not inherited.
BOOL WINAPI goOn(DWORD) {
    return TRUE;
}

void waitForEndOfInput() {
    char byte = 0;
    DWORD count = 0;
    while (ReadFile(GetStdHandle(STD_INPUT_HANDLE), &byte, 1, &count, nullptr) && count > 0) {
    }
}

/// Status 22 is curl's for what a server does not give.
int download(int count, wchar_t** words) {
    std::wstring file, address, folder(MAX_PATH, L'\0');
    for (int i = 1; i + 1 < count; ++i) {
        if (std::wstring(words[i]) == L"--output") file = words[i + 1];
        if (std::wstring(words[i]) == L"--url") address = words[i + 1];
    }
    folder.resize(GetEnvironmentVariableW(L"SERVED", folder.data(), MAX_PATH));
    const std::wstring served = folder + L'\\' + address.substr(address.rfind(L'/') + 1);
    return CopyFileW(served.c_str(), file.c_str(), FALSE) ? 0 : 22;
}

/// Opens the file as ffmpeg does, so that others may have it open, too, but not remove it.
int writeFilm(int count, wchar_t** words) {
    std::string content;
    for (int i = 1; i < count; ++i) {
        char bytes[1024];
        WideCharToMultiByte(CP_UTF8, 0, words[i], -1, bytes, sizeof bytes, nullptr, nullptr);
        content += std::string(bytes) + '\n';
    }
    char bytes[4096];
    DWORD length = 0;
    while (ReadFile(GetStdHandle(STD_INPUT_HANDLE), bytes, sizeof bytes, &length, nullptr) && length > 0)
        content.append(bytes, length);
    const HANDLE film = CreateFileW(words[count - 1] + std::wstring(L"file:").size(), GENERIC_WRITE,
                                    FILE_SHARE_READ | FILE_SHARE_WRITE, nullptr, CREATE_ALWAYS, 0, nullptr);
    return WriteFile(film, content.data(), static_cast<DWORD>(content.size()), &length, nullptr) ? 0 : 1;
}

std::wstring quoted(const std::wstring& word) {
    return L'"' + word + L'"';
}

int trouble(const std::wstring& what, const wchar_t* file, int count, wchar_t** words) {
    STARTUPINFOW how{};
    how.cb = sizeof how;
    how.dwFlags = STARTF_USESTDHANDLES;
    how.hStdInput = GetStdHandle(STD_INPUT_HANDLE);
    how.hStdOutput = GetStdHandle(STD_OUTPUT_HANDLE);
    how.hStdError = GetStdHandle(STD_ERROR_HANDLE);
    const bool isTyped = what == L"ctrl-c";
    if (isTyped && GetConsoleWindow() == nullptr) {
        FreeConsole();  // Wine's, which has no window and passes no events
        if (!AllocConsole()) std::fprintf(stderr, "no console: error %lu\n", GetLastError());
    }
    SetConsoleCtrlHandler(goOn, TRUE);
    std::wstring line;
    for (int i = 0; i < count; ++i) line += (i > 0 ? L" " : L"") + quoted(words[i]);
    PROCESS_INFORMATION made{};
    if (!CreateProcessW(nullptr, line.data(), nullptr, nullptr, TRUE, 0, nullptr, nullptr, &how, &made)) {
        std::fprintf(stderr, "cannot start it: error %lu\n", GetLastError());
        return kNothingDone;
    }
    while (GetFileAttributesW(file) == INVALID_FILE_ATTRIBUTES &&
           WaitForSingleObject(made.hProcess, 20) == WAIT_TIMEOUT) {
    }
    bool isDone = WaitForSingleObject(made.hProcess, 1000) == WAIT_TIMEOUT;
    if (isDone && isTyped) {
        if (!GenerateConsoleCtrlEvent(CTRL_C_EVENT, 0)) {
            std::fprintf(stderr, "no event: error %lu\n", GetLastError());
            isDone = false;
        }
    } else if (isDone) {
        const std::vector<HANDLE> workers = workersOf(made.dwProcessId);
        isDone = !workers.empty();
        for (const HANDLE each : workers) {
            if (what == L"kill")
                TerminateProcess(each, 1);
            else  // a thread whose code is at an address where none is
                CreateRemoteThread(each, nullptr, 0, reinterpret_cast<LPTHREAD_START_ROUTINE>(16), nullptr, 0,
                                   nullptr);
        }
    }
    WaitForSingleObject(made.hProcess, INFINITE);
    DWORD status = 0;
    GetExitCodeProcess(made.hProcess, &status);
    std::printf("%lx\n", status);
    return isDone ? 0 : kNothingDone;
}

}  // namespace

int main() {
    int count = 0;
    wchar_t** const words = CommandLineToArgvW(GetCommandLineW(), &count);
    const std::wstring what = count > 1 ? words[1] : L"";
    if (what == L"number") {
        std::printf("%lu\n", GetCurrentProcessId());
        std::fflush(stdout);
        waitForEndOfInput();
        return 0;
    }
    if (what == L"hold" && count == 3) {
        const HANDLE file =
            CreateFileW(words[2], GENERIC_READ | GENERIC_WRITE, 0, nullptr, OPEN_EXISTING, 0, nullptr);
        std::puts(file == INVALID_HANDLE_VALUE ? "no" : "held");
        std::fflush(stdout);
        waitForEndOfInput();
        return 0;
    }
    if (what == L"--disable") return download(count, words);
    if (what == L"-nostdin") return writeFilm(count, words);
    if (count < 4) return 2;
    return trouble(what, words[2], count - 3, words + 3);
}
