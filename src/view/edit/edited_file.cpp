#include "view/edit/edited_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <span>
#include <sstream>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "base/own_library.h"
#include "base/text.h"
#include "base/utf8.h"
#include "image/file.h"
#include "system/process.h"
#include "view/edit/source_lines.h"

namespace glibra::view {
namespace {

bool isContinuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\n';
}

constexpr std::uint64_t kLargestFile = 1ULL << 20;
constexpr std::string_view kMark = "\xEF\xBB\xBF";
constexpr std::uint32_t kLastLatin = 0xFF;
constexpr std::uint32_t kLastOfBasicPlane = 0xFFFF;

/// The largest character of the text; empty if the text is not UTF-8.
std::optional<std::uint32_t> largestCharacter(std::string_view text) {
    std::uint32_t largest = 0;
    while (!text.empty()) {
        const base::Character character = base::firstCharacter(text);
        if (!character.valid) return std::nullopt;
        largest = std::max(largest, character.code);
        text.remove_prefix(character.bytes);
    }
    return largest;
}

std::string fromLatin(std::string_view bytes) {
    std::string text;
    for (const char each : bytes) base::appendUtf8(text, static_cast<unsigned char>(each));
    return text;
}

/// Empty if a character is not in Latin-1.
std::optional<std::string> toLatin(std::string_view text) {
    std::string bytes;
    while (!text.empty()) {
        const base::Character character = base::firstCharacter(text);
        if (!character.valid || character.code > kLastLatin) return std::nullopt;
        bytes += static_cast<char>(character.code);
        text.remove_prefix(character.bytes);
    }
    return bytes;
}

std::string replaceEach(std::string_view text, const std::string& from, std::string_view to) {
    return replaced(text, findAll(text, {from, true}), to);
}

std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    for (;;) {
        const std::size_t end = text.find('\n');
        lines.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return lines;
        text.remove_prefix(end + 1);
    }
}

/// `text` with the lines that differ between `before` and `after`, each of which it must have as often as
/// `before` does.
std::optional<std::string> withChangedLines(std::string_view before, std::string_view after,
                                            std::string_view text) {
    const std::vector<std::string_view> old = linesOf(before), wanted = linesOf(after);
    std::vector<std::string_view> lines = linesOf(text);
    const std::vector<std::string_view> mine = lines;
    if (old.size() != wanted.size()) return std::nullopt;
    for (std::size_t i = 0; i < old.size(); ++i) {
        if (old[i] == wanted[i]) continue;
        if (std::ranges::count(mine, old[i]) != std::ranges::count(old, old[i])) return std::nullopt;
        auto nth = std::count(old.begin(), old.begin() + static_cast<std::ptrdiff_t>(i), old[i]);
        for (std::size_t k = 0; k < mine.size(); ++k)
            if (mine[k] == old[i] && nth-- == 0) lines[k] = wanted[i];
    }
    std::string result;
    for (const std::string_view each : lines) result.append(each).append("\n");
    result.pop_back();
    return result;
}

constexpr const char* kTerminal = "x-terminal-emulator";
/// Editors that need a terminal.
constexpr std::array<std::string_view, 10> kTerminalEditors{"vi", "vim", "nvim", "nano", "micro",
                                                            "ne", "joe", "hx",   "kak",  "emacs-nox"};

/// The words of a variable, or the one program that it is the path of.
std::vector<std::string> words(const std::string& text) {
    if (const std::filesystem::path whole = text; whole.is_absolute() && system::isProgram(whole))
        return {text};
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

/// Without the suffix that programs have on Windows.
std::string editorName(const std::string& program) {
    const std::filesystem::path name = std::filesystem::path(program).filename();
    return (name.extension() == ".exe" ? name.stem() : name).generic_string();
}

/// Adds the file and the line in the form that the editor expects.
void addPlace(std::vector<std::string>& command, const std::string& editor, const Place& place) {
    if (editor == "code" || editor == "Code" || editor == "codium") {
        command.insert(command.end(),
                       {"--goto", fmt::format("{}:{}:{}", place.file, place.line, place.column)});
    } else if (editor == "subl" || editor == "hx" || editor == "zed") {
        command.push_back(fmt::format("{}:{}:{}", place.file, place.line, place.column));
    } else if (editor == "kate" || editor == "kwrite") {
        command.insert(command.end(), {"--line", std::to_string(place.line), place.file});
    } else if (editor == "notepad++") {
        command.insert(command.end(), {fmt::format("-n{}", place.line), place.file});
    } else if (editor == "notepad") {  // it knows no lines
        command.push_back(place.file);
    } else {
        command.insert(command.end(), {fmt::format("+{}", place.line), place.file});
    }
}

}  // namespace

/// Typing joins the last step until a new word or line begins; deleting joins until another kind of change.
bool TextHistory::join(const Step& step) {
    if (!mayJoin_ || at_ == 0 || at_ < steps_.size()) return false;
    Step& last = steps_[at_ - 1];
    if (step.removed.empty() && last.removed.empty() && step.begin == last.begin + last.added.size()) {
        const bool beginsWord = isBlank(last.added.back()) && !isBlank(step.added.front());
        const bool isLine = step.added.find('\n') != std::string::npos;
        if (beginsWord || isLine) return false;
        last.added += step.added;
        return true;
    }
    if (!step.added.empty() || !last.added.empty()) return false;
    if (step.begin == last.begin) {
        last.removed += step.removed;
        return true;
    }
    if (step.begin + step.removed.size() != last.begin) return false;
    last.removed = step.removed + last.removed;
    last.begin = step.begin;
    return true;
}

void TextHistory::record(std::string_view text) {
    if (text == present_) return;
    const std::size_t shorter = std::min(text.size(), present_.size());
    auto same = static_cast<std::size_t>(std::ranges::mismatch(text, present_).in1 - text.begin());
    // The common parts end at whole characters, so that every state is UTF-8.
    const auto cuts = [](std::string_view of, std::size_t at) {
        return at < of.size() && isContinuation(of[at]);
    };
    while (same > 0 && (cuts(text, same) || cuts(present_, same))) --same;
    std::size_t after = 0;
    while (after < shorter - same && text[text.size() - 1 - after] == present_[present_.size() - 1 - after])
        ++after;
    while (after > 0 && (cuts(text, text.size() - after) || cuts(present_, present_.size() - after))) --after;
    Step step{same, present_.substr(same, present_.size() - after - same),
              std::string(text.substr(same, text.size() - after - same))};
    present_ = text;
    if (join(step)) return;
    steps_.resize(at_);
    steps_.push_back(std::move(step));
    if (steps_.size() > kMostSteps) steps_.erase(steps_.begin());
    at_ = steps_.size();
    mayJoin_ = true;
}

TextHistory::State TextHistory::undo() {
    mayJoin_ = false;
    if (at_ == 0) return {present_, 0};
    const Step& step = steps_[--at_];
    present_.replace(step.begin, step.added.size(), step.removed);
    return {present_, step.begin + step.removed.size()};
}

TextHistory::State TextHistory::redo() {
    mayJoin_ = false;
    if (at_ == steps_.size()) return {present_, 0};
    const Step& step = steps_[at_++];
    present_.replace(step.begin, step.removed.size(), step.added);
    return {present_, step.begin + step.added.size()};
}

EditedFile::EditedFile(std::filesystem::path path) : path_(std::move(path)) {
    takeDisk();
    history_ = TextHistory(text_);
}

void EditedFile::recordWhole() {
    history_.endStep();
    history_.record(text_);
    history_.endStep();
}

void EditedFile::revert() {
    text_ = savedText_;
    recordWhole();
}

bool EditedFile::readBytes(std::string& bytes) {
    const auto read = image::readFile(path_, {path_.generic_string(), {}}, kLargestFile);
    if (read) {
        bytes = base::asText(*read);
        return true;
    }
    // An empty file is valid in an editor.
    std::error_code failure;
    bytes.clear();
    if (std::filesystem::is_regular_file(path_, failure) && std::filesystem::file_size(path_, failure) == 0)
        return true;
    whyReadOnly_ = read.diagnostics.empty() ? "It cannot be read." : read.diagnostics.front().text;
    return false;
}

void EditedFile::decode(std::string_view bytes) {
    whyReadOnly_.clear();
    hasMark_ = bytes.starts_with(kMark);
    if (hasMark_) bytes.remove_prefix(kMark.size());
    const auto largest = largestCharacter(bytes);
    isLatin_ = !largest;
    std::string text = isLatin_ ? fromLatin(bytes) : std::string(bytes);
    const auto lines = std::count(text.begin(), text.end(), '\n');
    hasCarriageReturns_ = lines > 0 && std::count(text.begin(), text.end(), '\r') == lines &&
                          text.find("\r\n") != std::string::npos;
    if (hasCarriageReturns_) text = replaceEach(text, "\r\n", "\n");
    if (text.find('\0') != std::string::npos) {
        whyReadOnly_ = "It is not a text file.";
        text = text.substr(0, text.find('\0'));
    } else if (text.find('\r') != std::string::npos) {
        whyReadOnly_ = "It mixes several kinds of line ends, which this editor would change.";
    } else if (largest && *largest > kLastOfBasicPlane) {
        whyReadOnly_ = "It has characters above U+FFFF, which this editor would lose.";
    }
    if (whyReadOnly_.empty() && isExample(path_))
        whyReadOnly_ = "It is an example of glibra; save a copy to edit it.";
    text_ = savedText_ = std::move(text);
}

std::string EditedFile::encoded() const {
    const std::string text = hasCarriageReturns_ ? replaceEach(text_, "\n", "\r\n") : text_;
    if (isLatin_)
        if (auto latin = toLatin(text)) return std::move(*latin);
    return hasMark_ ? std::string(kMark) + text : text;
}

bool EditedFile::lookAtDisk() {
    std::string bytes;
    std::string why = whyReadOnly_;
    if (!readBytes(bytes)) {
        // A missing file may come back soon. Until then the text here is kept.
        whyReadOnly_ = std::move(why);
        std::error_code failure;
        isGone_ = whyReadOnly_.empty() && !std::filesystem::exists(path_, failure);
        return false;
    }
    isGone_ = false;
    if (bytes == diskBytes_) return false;
    if (isChanged() && bytes != encoded()) {
        hasConflict_ = true;
        return true;
    }
    diskBytes_ = std::move(bytes);
    hasConflict_ = false;
    decode(diskBytes_);
    recordWhole();
    return true;
}

void EditedFile::keepMine() {
    std::string bytes;
    hasConflict_ = false;
    if (!readBytes(bytes)) return;
    diskBytes_ = std::move(bytes);
    std::string mine = std::move(text_);
    decode(diskBytes_);
    text_ = std::move(mine);
}

void EditedFile::takeDisk() {
    hasConflict_ = false;
    std::string bytes;
    if (!readBytes(bytes)) return;
    diskBytes_ = std::move(bytes);
    decode(diskBytes_);
    recordWhole();
}

Diagnostics EditedFile::changeFile(const std::string& bytes) {
    const auto refuse = [&](const char* why) {
        return Diagnostics{diagnose("view-E01", why, {path_.generic_string(), 1, 1})};
    };
    std::string onDisk;
    if (!readBytes(onDisk)) return refuse("the file cannot be read");
    if (onDisk != diskBytes_ && isChanged()) {
        hasConflict_ = true;
        return refuse("another program has changed this file");
    }
    const bool wasChanged = isChanged();
    const std::string before = savedText_, mine = text_;
    decode(bytes);
    std::optional<std::string> merged = wasChanged ? withChangedLines(before, text_, mine) : text_;
    Diagnostics problems;
    if (!merged)
        problems =
            refuse("the text that is not saved has other lines where these values stand; save it first");
    else
        problems = image::writeFileAtomically(path_, std::as_bytes(std::span(bytes)));
    if (!problems.empty()) {
        decode(diskBytes_);
        text_ = mine;
        return problems;
    }
    diskBytes_ = bytes;
    isGone_ = false;
    text_ = std::move(*merged);
    recordWhole();
    return {};
}

Diagnostics EditedFile::save() {
    if (!isChanged()) return {};
    std::string bytes;
    if (readBytes(bytes)) {
        hasConflict_ = bytes != diskBytes_;
        if (hasConflict_) return {};
    }
    whyReadOnly_.clear();
    const std::string written = encoded();
    Diagnostics problems = image::writeFileAtomically(path_, std::as_bytes(std::span(written)));
    if (!problems.empty()) return problems;
    diskBytes_ = written;
    savedText_ = text_;
    isGone_ = false;
    return {};
}

namespace fs = std::filesystem;

fs::path exampleRoot(const std::vector<fs::path>& roots, const fs::path& scene, const fs::path& program) {
    for (const fs::path& each : roots)
        if (base::isLibrary(each)) return each;
    for (const fs::path& each : {program, scene})
        if (!each.empty())
            if (fs::path root = base::libraryAbove(each.parent_path()); !root.empty()) return root;
    return {};
}

bool isExample(const fs::path& file) {
    static const fs::path kRoot = base::ownLibrary();
    if (kRoot.empty() || file.empty()) return false;
    std::error_code failure;
    // Windows has the folder by names in any case, too.
    for (fs::path at = fs::weakly_canonical(file, failure); at.has_relative_path(); at = at.parent_path())
        for (const fs::path each : {"glib", "shaders", "textures", "scenes/models"})
            if (base::sameWord(at.filename().generic_string(), each.filename().generic_string()) &&
                fs::equivalent(at, kRoot / each, failure))
                return true;
    return false;
}

Diagnostics writingProblem(const fs::path& file) {
    if (!isExample(file)) return {};
    return {diagnose("view-E03", "the folders of the examples are not written to; choose another one")};
}

std::string openInEditor(const Place& place) {
    const char* variable = std::getenv("VISUAL");
    if (!variable || !*variable) variable = std::getenv("EDITOR");
    std::vector<std::string> command = words(variable && *variable ? variable : system::usualEditor());
    if (command.empty())
        return "no editor is set: set the environment variable EDITOR, for example EDITOR=gedit";
    const std::string editor = editorName(command.front());
    if (std::ranges::find(kTerminalEditors, editor) != kTerminalEditors.end())
        command.insert(command.begin(), {kTerminal, "-e"});
    const bool isInTerminal = command.front() == kTerminal && command.size() > 2;
    addPlace(command, isInTerminal ? editorName(command[2]) : editor, place);
    const std::string failure = system::startDetached(command);
    if (!failure.empty()) return fmt::format("cannot start '{}': {}", command.front(), failure);
    return fmt::format("opened {}:{} with {}", place.file, place.line, editor);
}

}  // namespace glibra::view
