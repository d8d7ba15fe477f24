#pragma once
// Where things are on this system: programs, the user's folders, the environment, and what it says of itself.

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glibra::system {

/// The file of the running program; empty if the system does not tell it.
std::filesystem::path programFile();
/// A path by which this process can read or start the program that it runs, even if the file was replaced
/// meanwhile.
std::string pathOfThisProgram();
/// The words by which this program was started, the first one being its name; empty if the system does not
/// tell.
std::vector<std::string> ownWords();

/// The folder of this program (glibra) among a user's settings, states that outlive a run, and files that can
/// be made again. Empty if the system names none.
enum class UserFolder { settings, state, cache };
std::filesystem::path userFolder(UserFolder which);
/// The user's own folder; empty if there is none.
std::filesystem::path homeFolder();
/// The file of a font that is installed, such as "DejaVuSans.ttf"; empty if it is not.
std::filesystem::path fontFile(const std::string& name);
/// The folders of an environment variable like PATH; without empty ones.
std::vector<std::filesystem::path> foldersIn(const char* variable);
/// True if this user may write to the file, or make files in the folder.
bool mayWrite(const std::filesystem::path& path);

enum class Replace { no, yes };
/// Sets a variable for this process and those that it starts. No other thread may use the environment
/// meanwhile.
void setVariable(const char* name, const std::string& value, Replace replace);
void removeVariable(const char* name);

/// The time by the clock of this place, and the minutes that it is ahead of UTC. Nothing if the system does
/// not know.
struct LocalTime {
    std::tm time{};
    long minutesAhead = 0;
};
std::optional<LocalTime> localTime(std::time_t seconds);
/// Seconds of processor time that this process has used.
double processorSeconds();

/// Fills the bytes with random ones that nobody can foresee. False if the system has none.
bool fillWithRandom(std::span<std::byte> bytes);

/// "Linux 6.1.0 x86_64": system, release and kind of processor; empty if the system does not tell.
std::string systemName();
/// The first value that the system's list of processors has under one of these names, which are those of
/// Linux
/// ("model name", "vendor_id", "flags"); other systems give what corresponds to them. Empty if there is none.
std::string processorFact(std::span<const std::string_view> names);

/// The model of the processor: "Intel(R) Xeon(R) CPU"; empty if the system does not tell.
std::string processorModel();

/// The graphics card that programs of this user can draw with, as far as device files show it.
enum class GraphicsCard {
    none,
    mesa,  ///< one that Mesa drives, or the one of Windows as WSL shows it: Mesa may be told not to use it
    ownDriver  ///< one with a driver of its own, which no setting of Mesa changes
};
/// `devices`: a folder in place of the system's own.
GraphicsCard graphicsCard(const std::filesystem::path& devices = {});

/// Bytes of memory of the machine.
std::uint64_t machineMemory();
/// The same, or what the control group of this process may take, if that is less.
std::uint64_t usableMemory();

}  // namespace glibra::system
