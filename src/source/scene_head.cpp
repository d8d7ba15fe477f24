#include "source/scene_head.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>

#include "base/percent.h"
#include "base/text.h"
#include "glib/text.h"

namespace glibra::source {
namespace {

constexpr std::string_view kBlanks = " \t\r";

/// True for the id of a row: "SH030", "D09", "G14.7a", "Gx9.4", with or without a comma after it.
bool isRow(std::string_view word) {
    if (word.ends_with(',')) word.remove_suffix(1);
    std::size_t at = 0;
    while (at < word.size() && word[at] >= 'A' && word[at] <= 'Z') ++at;
    if (at == 0 || at > 2) return false;
    if (at == 1 && word.size() > 1 && word[1] == 'x') ++at;
    return at < word.size() && glib::isDigit(word[at]) &&
           std::all_of(
               word.begin() + static_cast<std::ptrdiff_t>(at), word.end(),
               [](char c) { return c == '.' || glib::isOfName(c); });
}

/// The text up to its first full stop that a blank follows.
std::string_view firstSentence(std::string_view text) {
    const std::size_t end = text.find(". ");
    return end == std::string_view::npos ? text : text.substr(0, end + 1);
}

/// The files that the links of a cell lead to: [a](a.glib), [a](<a b.glib>), [a](./a%20b.glib "title").
std::vector<std::string> linksIn(std::string_view cell) {
    std::vector<std::string> files;
    for (std::size_t at = cell.find("]("); at != std::string_view::npos; at = cell.find("](", at)) {
        at += 2;
        const bool isBracketed = cell.substr(at).starts_with('<');
        if (isBracketed) ++at;
        const std::size_t end = cell.find_first_of(isBracketed ? ">" : " )", at);
        if (end == std::string_view::npos) break;
        const std::filesystem::path file = base::percentDecoded(cell.substr(at, end - at));
        files.push_back(file.lexically_normal().generic_string());
    }
    return files;
}

void addChapters(std::string_view source, std::string_view numbers, std::vector<std::string>& to) {
    for (std::string_view word = base::nextWord(numbers, kBlanks); !word.empty();
         word = base::nextWord(numbers, kBlanks)) {
        if (word.ends_with(',')) word.remove_suffix(1);
        if (word != "and") to.push_back(std::string(source) + ", chapter " + std::string(word));
    }
}

}  // namespace

SceneHead headOf(std::string_view scene) {
    SceneHead head;
    std::string joined;  // the first paragraph
    bool hasParagraph = false;
    while (!scene.empty()) {
        std::string_view line = base::nextLine(scene);
        if (!line.starts_with('#')) break;
        line.remove_prefix(std::min(line.find_first_not_of('#'), line.size()));
        line = base::trimmed(line, kBlanks);
        if (head.text.empty())
            for (std::string_view rest = line; isRow(base::nextWord(rest, kBlanks));
                 line = base::trimmed(rest, kBlanks)) {
                std::string_view row = line.substr(0, line.find_first_of(kBlanks));
                if (row.ends_with(',')) row.remove_suffix(1);
                head.rows.emplace_back(row);
            }
        hasParagraph = hasParagraph || (line.empty() && !joined.empty());
        if (!hasParagraph) joined += (joined.empty() ? "" : " ") + std::string(line);
        head.text.emplace_back(line);
    }
    while (!head.text.empty() && head.text.back().empty()) head.text.pop_back();
    // A first line that ends with a full stop is the summary, however many sentences it has.
    if (!head.text.empty())
        head.summary = head.text.front().ends_with('.') ? head.text.front() : firstSentence(joined);
    return head;
}

std::map<std::string, std::string> chapterColumn(std::string_view table) {
    std::map<std::string, std::string> chapters;
    while (!table.empty()) {
        const std::string_view line = base::trimmed(base::nextLine(table), kBlanks);
        const std::size_t last =
            line.size() < 4 ? std::string_view::npos : line.rfind(" | ", line.size() - 3);
        if (!line.starts_with("| ") || last == std::string_view::npos) continue;
        const std::string_view chapter =
            base::trimmed(line.substr(last + 3, line.size() - last - 4), kBlanks);
        if (chapter.empty() || chapter == "-") continue;
        for (std::string& each : linksIn(line.substr(0, line.find(" | ")))) chapters.emplace(each, chapter);
    }
    return chapters;
}

std::vector<std::string> chaptersIn(std::string_view column) {
    std::vector<std::string> all;
    while (!column.empty()) {
        const std::size_t end = column.find(';');
        const std::string_view part = base::trimmed(column.substr(0, end), kBlanks);
        column.remove_prefix(end == std::string_view::npos ? column.size() : end + 1);
        const std::size_t one = part.find(", chapter "), several = part.find(", chapters ");
        if (several != std::string_view::npos)
            addChapters(part.substr(0, several), part.substr(several + 11), all);
        else if (one != std::string_view::npos)
            addChapters(part.substr(0, one), part.substr(one + 10), all);
        else if (!part.empty())
            all.emplace_back(part);
    }
    return all;
}

bool isBefore(std::string_view a, std::string_view b) {
    while (!a.empty() && !b.empty()) {
        if (glib::isDigit(a.front()) && glib::isDigit(b.front())) {
            std::uint64_t numberA = 0, numberB = 0;
            const auto endA = std::from_chars(a.data(), a.data() + a.size(), numberA).ptr;
            const auto endB = std::from_chars(b.data(), b.data() + b.size(), numberB).ptr;
            if (numberA != numberB) return numberA < numberB;
            a.remove_prefix(static_cast<std::size_t>(endA - a.data()));
            b.remove_prefix(static_cast<std::size_t>(endB - b.data()));
            continue;
        }
        if (glib::lower(a.front()) != glib::lower(b.front()))
            return glib::lower(a.front()) < glib::lower(b.front());
        a.remove_prefix(1);
        b.remove_prefix(1);
    }
    return a.size() < b.size();
}

}  // namespace glibra::source
