#include "view/edit/saved_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "image/file.h"
#include "scene/file_lookup.h"
#include "system/folder.h"

namespace glibra::view {
namespace {

struct Replacement {
    std::size_t begin = 0, end = 0;
    std::string text;
};

/// The byte offset of a line and column, both counted from 1. Lines end with LF, CR LF or CR.
std::optional<std::size_t> offsetOf(std::string_view text, const Place& place) {
    std::size_t at = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    for (int line = 1; line < place.line; ++line) {
        at = text.find_first_of("\r\n", at);
        if (at == std::string_view::npos) return std::nullopt;
        at += text.substr(at, 2) == "\r\n" ? 2 : 1;
    }
    at += static_cast<std::size_t>(place.column - 1);
    return at < text.size() ? std::optional(at) : std::nullopt;
}

/// The numbers and words of a value, as positions in its text.
std::vector<std::pair<std::size_t, std::size_t>> piecesOf(std::string_view value) {
    std::vector<std::pair<std::size_t, std::size_t>> pieces;
    constexpr std::string_view kBetween = " \t\v\f\r\n<>[]{}()\\,";
    for (std::size_t at = 0; at < value.size();) {
        const std::size_t begin = value.find_first_not_of(kBetween, at);
        if (begin == std::string_view::npos) break;
        at = std::min(value.find_first_of(kBetween, begin), value.size());
        pieces.emplace_back(begin, at);
    }
    return pieces;
}

std::optional<double> numberIn(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

/// The new text of a value: the old one, in which only the numbers that differ are replaced. If the two are
/// not of the same form, it is `wanted`.
std::string changedText(std::string_view old, std::string_view wanted) {
    const auto before = piecesOf(old), after = piecesOf(wanted);
    if (before.size() != after.size() || old.front() != wanted.front()) return std::string(wanted);
    std::string text;
    std::size_t copied = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const auto [begin, end] = before[i];
        const std::string_view piece = wanted.substr(after[i].first, after[i].second - after[i].first);
        const auto was = numberIn(old.substr(begin, end - begin)), is = numberIn(piece);
        if (was && is && *was == *is) continue;
        text += old.substr(copied, begin - copied);
        text += piece;
        copied = end;
    }
    return text + std::string(old.substr(copied));
}

/// True if all of the text is numbers, and others than those that the knob was made from: the place has
/// another value now.
bool isOther(std::string_view text, const render::Knob& knob) {
    std::vector<double> numbers;
    for (const auto& [begin, end] : piecesOf(text)) {
        const auto number = numberIn(text.substr(begin, end - begin));
        if (!number) return false;
        numbers.push_back(*number);
    }
    return numbers != knob.written;
}

/// The end of the value that begins at `begin`: after its closing bracket, or at the end of the number.
std::optional<std::size_t> valueEnd(std::string_view text, std::size_t begin) {
    constexpr std::string_view kOpening = "<[{(";
    constexpr std::string_view kClosing = ">]})";
    if (kOpening.find(text[begin]) != std::string_view::npos) {
        int depth = 0;  // of expressions, which may have brackets of their own
        for (std::size_t at = begin; at < text.size() && text[at] != '#'; ++at) {
            const bool isInside = depth > 1 || (depth == 1 && text[begin] == '(');
            if (text[at] == '(' || at == begin) ++depth;
            const bool closes =
                isInside ? text[at] == ')' : kClosing.find(text[at]) != std::string_view::npos;
            if (closes && --depth == 0) return at + 1;
        }
        return std::nullopt;
    }
    const std::size_t end = text.find_first_of(" \t\v\f\r\n<>[]{}()#\"", begin);
    return std::min(end, text.size());
}

constexpr std::string_view kBlanks = " \t\v\f";

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

/// Splits off the first line, with its end. Lines end with LF, CR LF or CR.
std::string_view takeLine(std::string_view& rest) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    const std::string_view line = rest.substr(0, end + (rest.substr(end, 2) == "\r\n" ? 2 : 1));
    rest.remove_prefix(line.size());
    return line;
}

std::string_view withoutEnd(std::string_view line) {
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
    return line;
}

/// The length of the statement: what stands before a comment, without blanks at the end.
std::size_t statementLength(std::string_view line) {
    bool isQuoted = false;
    std::size_t end = 0;
    for (; end < line.size(); ++end) {
        if (line[end] == '"') isQuoted = !isQuoted;
        const bool isFirst = end == 0 || kBlanks.find(line[end - 1]) != std::string_view::npos;
        if (!isQuoted && (line[end] == '#' || (line[end] == '/' && isFirst))) break;
    }
    return line.substr(0, end).find_last_not_of(kBlanks) + 1;
}

namespace fs = std::filesystem;

bool isSameFile(const fs::path& a, const fs::path& b) {
    std::error_code failure;
    return a == b || fs::equivalent(a, b, failure);
}

/// The path relative to the folder; empty if it is not below it.
fs::path below(const fs::path& file, const fs::path& folder) {
    const fs::path inside = system::wholePath(file).lexically_relative(system::wholePath(folder));
    return inside.empty() || *inside.begin() == ".." ? fs::path() : inside;
}

/// The place of a file beside the copy, if a name in the scene leads to it.
fs::path placeByName(const scene::Scene& scene, const fs::path& file, const fs::path& folder) {
    for (const scene::FileReference& each : scene.files) {
        if (each.path.empty() || !isSameFile(each.path, file)) continue;
        std::string name = each.name;
        std::replace(name.begin(), name.end(), '\\', '/');
        const fs::path path = fs::path(name).lexically_normal();
        if (path.is_relative() && !path.empty() && *path.begin() != "..") return folder / path;
    }
    return {};
}

/// The place of an included file: relative to a copied file as the original is to that one.
fs::path placeByInclude(const std::vector<CopiedFile>& known, const fs::path& file) {
    for (const CopiedFile& each : known)
        if (const fs::path inside = below(file, each.from.parent_path()); !inside.empty())
            return each.to.parent_path() / inside;
    return {};
}

/// True if the copy finds the file by the scene's own name for it.
bool isFound(const scene::Scene& scene, const fs::path& file, const scene::SearchFolders& folders) {
    return std::any_of(scene.files.begin(), scene.files.end(), [&](const scene::FileReference& each) {
        if (each.path.empty() || !isSameFile(each.path, file)) return false;
        scene::FolderListings listings;
        return isSameFile(scene::findFile(each.name, each.place, folders, listings).path, file);
    });
}

Result<std::vector<std::byte>> bytesOf(const fs::path& file) {
    std::error_code failure;
    if (fs::is_regular_file(file, failure) && fs::is_empty(file, failure)) return std::vector<std::byte>();
    return image::readFile(file, {file.generic_string(), {}});
}

}  // namespace

Result<std::string> withValues(std::string_view text, std::span<const render::Knob> knobs) {
    std::vector<Replacement> replacements;
    for (const render::Knob& each : knobs) {
        if (!each.isChanged() || !each.words.empty()) continue;
        const auto begin = offsetOf(text, each.place);
        const auto end = begin ? valueEnd(text, *begin) : std::nullopt;
        if (!end || isOther(text.substr(*begin, *end - *begin), each))
            return diagnose(
                "view-E01",
                fmt::format("the value of '{}' is no longer at this place; reload the scene", each.tag),
                each.place);
        replacements.push_back(
            {*begin, *end, changedText(text.substr(*begin, *end - *begin), valueText(each))});
    }
    std::sort(replacements.begin(), replacements.end(),
              [](const Replacement& a, const Replacement& b) { return a.begin > b.begin; });
    std::string result(text);
    for (const Replacement& each : replacements) result.replace(each.begin, each.end - each.begin, each.text);
    return result;
}

std::optional<ChosenFile> chosenFile(std::string_view text, const Place& place,
                                     const std::filesystem::path& file) {
    std::vector<std::string_view> lines;
    for (std::string_view rest = text; !rest.empty();) lines.push_back(trimmed(withoutEnd(takeLine(rest))));
    const auto index = static_cast<std::size_t>(place.line - 1);
    if (place.line < 1 || index >= lines.size()) return std::nullopt;
    const std::filesystem::path whole = system::wholePath(file);
    const auto near = whole.lexically_relative(system::wholePath(place.file).parent_path());
    const bool isBelow = !near.empty() && *near.begin() != "..";
    const auto before = lines.begin() + static_cast<std::ptrdiff_t>(index);
    return ChosenFile{std::string(lines[index]),
                      static_cast<int>(std::count(lines.begin(), before, lines[index])),
                      (isBelow ? near : whole).generic_string()};
}

std::string withFiles(std::string_view text, std::span<const ChosenFile> files) {
    std::string result;
    std::map<std::string_view, int> seen;
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view line = takeLine(rest);
        const std::string_view statement = trimmed(withoutEnd(line));
        const int occurrence = seen[statement]++;
        const auto chosen = std::find_if(files.begin(), files.end(), [&](const ChosenFile& each) {
            return each.line == statement && each.occurrence == occurrence;
        });
        const std::size_t length = statementLength(withoutEnd(line));
        result += line.substr(0, length);
        if (chosen != files.end()) result += " \"" + chosen->name + "\"";
        result += line.substr(length);
    }
    return result;
}

Diagnostics saveValues(const std::filesystem::path& scene, std::span<const render::Knob> knobs,
                       std::span<const ChosenFile> files, EditedFile* edited) {
    if (isExample(scene))
        return {diagnose("view-E03", "this scene is an example of glibra; save a copy to keep your values",
                         {scene.generic_string(), 1, 1})};
    const auto bytes = image::readFile(scene, {scene.generic_string(), {scene.generic_string(), 1, 1}});
    if (!bytes) return bytes.diagnostics;
    const Result<std::string> text = withValues(withFiles(base::asText(*bytes), files), knobs);
    if (!text) return text.diagnostics;
    if (edited != nullptr) return edited->changeFile(*text);
    return image::writeFileAtomically(scene, std::as_bytes(std::span(*text)));
}

std::vector<CopiedFile> filesOfCopy(const render::LiveScene& live, const fs::path& target, bool all,
                                    const std::vector<fs::path>& libraryRoots) {
    const scene::Scene& scene = live.scene();
    const fs::path from = system::wholePath(scene.path).parent_path();
    const fs::path to = system::wholePath(target).parent_path();
    if (from == to) return {};
    const scene::SearchFolders folders =
        scene::searchFolders(system::wholePath(target), {.libraryRoots = libraryRoots});
    std::vector<CopiedFile> copied;
    std::vector<fs::path> included;
    for (const fs::path& file : live.files()) {
        if (isSameFile(file, scene.path) || (!all && isFound(scene, file, folders))) continue;
        fs::path place = placeByName(scene, file, to);
        if (const fs::path inside = below(file, from); place.empty() && !inside.empty()) place = to / inside;
        if (place.empty())
            included.push_back(file);
        else
            copied.push_back({file, place});
    }
    for (const fs::path& file : included) {
        const fs::path place = placeByInclude(copied, file);
        copied.push_back({file, place.empty() ? to / file.filename() : place});
    }
    return copied;
}

Diagnostics writeCopy(std::string_view text, const fs::path& target, const std::vector<CopiedFile>& files) {
    std::vector<std::pair<fs::path, std::vector<std::byte>>> wanted;
    for (const CopiedFile& each : files) {
        Result<std::vector<std::byte>> content = bytesOf(each.from);
        if (!content) return content.diagnostics;
        std::error_code failure;
        if (fs::exists(each.to, failure)) {
            const Result<std::vector<std::byte>> there = bytesOf(each.to);
            if (there && *there == *content) continue;
            return {image::cannotWrite(each.to, "another file has this name; choose an empty folder")};
        }
        wanted.emplace_back(each.to, std::move(*content));
    }
    std::error_code failure;
    fs::create_directories(system::wholePath(target).parent_path(), failure);
    for (const auto& [file, content] : wanted) {
        fs::create_directories(file.parent_path(), failure);
        if (Diagnostics problems = image::writeFileAtomically(file, content, image::NamedBy::program);
            !problems.empty())
            return problems;
    }
    return image::writeFileAtomically(target, std::as_bytes(std::span(text)));
}

}  // namespace glibra::view
