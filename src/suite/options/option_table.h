#pragma once
// The options of a picture, one row each. The command line of `glibra render`, the suite reader, the command
// that reproduces a shot, the window's suite shot, the digests of suites and the documentation all read these
// rows. To add an option, add its member to RenderOptions (or Shot) and its row here.
//
// Three things cannot be read from a row. The members are declared by hand, because include/glibra/render.h
// describes them to users of the library. What an option means for a single frame and for small pictures of
// probes depends on what it does: src/library/renderer.cpp and src/render/probe/patch_probe.cpp say it.
// docs/suites.md explains keys in the words of suites, and a test compares which keys it has.

#include <glibra/render.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "suite/suite.h"

namespace glibra::suite {

/// Access to one member of a shot.
template <class T>
struct ShotMember {
    const T& (*get)(const Shot&);
    T& (*edit)(Shot&);
};

// The kinds of value.

inline constexpr int kMostSamples = 64;  ///< per pixel

/// True or false. `whenGiven` is the value that the option stands for on the command line.
struct FlagValue {
    ShotMember<bool> member;
    bool whenGiven = true;
};
struct WholeValue {
    ShotMember<int> member;
    int least, most;
};
/// `unit` may follow the number on the command line, as in "0.25px".
struct NumberValue {
    ShotMember<double> member;
    double least, most;
    std::string_view unit{};
};
/// Seconds. A suite may state a list, which makes one shot per time.
struct TimeValue : NumberValue {};
/// Width and height in pixels, 1 to `most` each; 0 and 0 if nothing is stated.
struct SizeValue {
    ShotMember<int> width, height;
    int most;
};
/// One of several words; `get` and `set` take the word's index.
struct WordValue {
    std::span<const std::string_view> words;
    int (*get)(const Shot&);
    void (*set)(Shot&, int);
};
/// Uniform variables, "NAME=VALUE" each.
struct UniformsValue {
    ShotMember<std::vector<std::string>> member;
};
/// 16 numbers, column by column.
struct MatrixValue {
    ShotMember<Matrix> member;
};
/// A matrix for each of several lines of the scene.
struct ObjectsValue {
    ShotMember<std::vector<ViewState::Object>> member;
};
/// Red, green, blue and, if it is not 1, alpha.
struct ColorValue {
    ShotMember<std::optional<std::array<double, 4>>> member;
};
/// Bytes, as "512M" or "2G"; 0 is no limit.
struct MemoryValue {
    ShotMember<std::optional<std::uint64_t>> member;
};
/// Folders; a suite states them relative to its own.
struct FoldersValue {
    ShotMember<std::vector<std::filesystem::path>> member;
};

using OptionValue =
    std::variant<FlagValue, WholeValue, NumberValue, TimeValue, SizeValue, WordValue, UniformsValue,
                 MatrixValue, ObjectsValue, ColorValue, MemoryValue, FoldersValue>;

struct OptionRow {
    std::string_view name;  ///< on the command line, after "--"; empty: the output file's ending decides
    std::string_view key;   ///< in suites; empty: suites cannot state it
    OptionValue value;
    std::string_view help;
    std::string_view needs{};  ///< name of an option without which this one has no effect
    /// May be given together with a suite, for all its shots. The others are stated by the suite.
    bool withSuite = false;
    std::string_view former{};  ///< an earlier name and key, which still works
    bool isRare = false;        ///< --help leaves it out, --help-all lists it
    bool isKept = false;        ///< a loaded scene keeps it: load() takes it, and what draws for the window
    bool inWindow = false;      ///< `glibra view` has it
};

/// All rows, in the order in which commands and suites are written.
std::span<const OptionRow> optionTable();

/// The row of a name or key, also of a former one; null if there is none.
const OptionRow* findOption(std::string_view name);
const OptionRow* findOptionKey(std::string_view key);
/// The row that our own sources name; std::logic_error if there is none (any more).
const OptionRow& optionNamed(std::string_view name);

/// True if the shot has the value that a new Shot has.
bool isDefault(const OptionRow& row, const Shot& shot);
/// Gives a shot of a suite what is stated for all of them, if it is not the default.
void giveToAll(const Shot& stated, Shot& shot);
/// The form of the value on the command line, as "WxH"; empty for flags.
std::string placeholder(const OptionRow& row);
/// Which values are allowed, as "1 to 64"; empty if the form says it all.
std::string limits(const OptionRow& row);
/// The default, as "300" or "off"; empty where the scene decides.
std::string defaultText(const OptionRow& row);

}  // namespace glibra::suite
