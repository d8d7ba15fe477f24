#pragma once
// Processes: this one, others that it starts, and copies of itself.

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "system/file.h"

namespace glibra::system {

/// How a process ended.
struct End {
    int status = 0;                ///< that it gave, if it ended by itself
    int signal = 0;                ///< that ended it, as in <csignal>; 0: it ended by itself
    bool wasTimeLimit = false;     ///< it had used up its processor time (limits.h)
    std::uint64_t peakMemory = 0;  ///< bytes; 0 if the system does not tell
    [[nodiscard]] bool isGood() const { return signal == 0 && status == 0; }
};

/// A process that this one started. It goes on when the object ends, and somebody has to wait for it.
class Process {
  public:
    Process() = default;
    explicit Process(std::intptr_t handle) : handle_(handle) {}
    Process(Process&& other) noexcept : handle_(other.handle_) { other.handle_ = kNoHandle; }
    Process& operator=(Process&& other) noexcept;
    ~Process();  // NOLINT(performance-trivially-destructible): not on Windows
    /// By which users and the system name it.
    [[nodiscard]] int number() const;
    [[nodiscard]] std::intptr_t handle() const { return handle_; }
    explicit operator bool() const { return handle_ != kNoHandle; }

  private:
    std::intptr_t handle_ = kNoHandle;
};

/// Waits for its end, after which it is empty. An empty one has ended well.
End waitFor(Process& process);
/// The same within a time; 0: no limit. Nothing if it still runs.
std::optional<End> waitFor(Process& process, double seconds);
/// Ends it at once; on systems that know what it has started, that too.
void kill(const Process& process);

/// The number of this process.
int ownNumber();
/// True if there is a process of that number on this machine. One that belongs to somebody else counts.
bool isRunning(long long number);
/// True if this process has one thread; false also if the system does not tell.
bool hasOneThread();
/// Seconds of processor time that a process has used; 0 if the system does not tell.
double processorSecondsOf(const Process& process);

// Other programs.

/// Where a standard stream of a started program leads.
struct Stream {
    enum class To { inherited, nothing, file, stream };
    Stream(To kind) : to(kind) {}
    Stream(const File& open) : to(To::file), file(&open) {}
    Stream(std::FILE* open) : to(To::stream), stream(open) {}
    To to;
    const File* file = nullptr;
    std::FILE* stream = nullptr;
};
struct Streams {
    Stream input = Stream::To::inherited, output = Stream::To::inherited, error = Stream::To::inherited;
};

/// Starts a program; the first word is searched in PATH. An empty value and errno: it cannot be started.
Process startProgram(const std::vector<std::string>& words, const Streams& streams);
/// Starts this program again, with these words.
Process startAgain(const std::vector<std::string>& words, const Streams& streams);
/// Starts a command that is no child of this process: it outlives this program, gets no signals from this
/// program's terminal, and nobody waits for it. The first word is searched in PATH. Returns the reason if it
/// cannot be started, such as "No such file or directory"; empty on success.
std::string startDetached(const std::vector<std::string>& words);
/// Opens a file with the program that the user has for its kind. Returns as startDetached().
std::string openForUser(const std::filesystem::path& file);
/// The editor that every user of this system has, for startDetached(); empty if there is none.
const char* usualEditor();
/// Replaces this program by another one, which gets its streams and whose exit status is this one's. Returns
/// only if it cannot be started, with the error number.
int becomeProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments);
/// The program of that name that PATH finds; empty if there is none.
std::filesystem::path findInPath(const std::string& name);
/// True if this user may run the file.
bool isProgram(const std::filesystem::path& file);

/// The writing end of a stream to a started program, for its input. Writing to a program that has ended is an
/// error, not a signal.
int makeInputOf(File& reading, File& writing);
int sendAll(const File& writing, std::span<const std::byte> bytes);

// Copies of this process.

/// Calls `work` in a copy of this process, which ends with it, and ends with status 1 after an exception. An
/// empty value: the system has no copies of processes, or cannot make one now (errno); then the work is to be
/// done otherwise.
Process runInCopy(const std::function<void()>& work);
/// In a copy: Ctrl+C and the like end it, whatever this program does about them.
void endBySignals();
/// This process ends with its parent, where the system can arrange that.
void endWithParent();

/// Calls `note` in every copy of this process that is made from now on, by whatever code. Nothing where the
/// system has no copies. `note` may do what a handler of signals may.
void onCopy(void (*note)());

}  // namespace glibra::system
