#include "geometry/obj/file_remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text.h"

namespace glibra::geometry {
namespace {
constexpr std::size_t kMostOfAKind = 100;
}

std::string shown(std::string_view text) {
    constexpr std::size_t kLongest = 40;
    std::string out(text.substr(0, kLongest));
    for (char& c : out)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    if (text.size() > kLongest) out += "...";
    return out;
}

std::string_view fileName(std::string_view path) {
    return path.substr(path.find_last_of("/\\") + 1);
}

void FileRemarks::warn(std::string_view id, std::string_view text, int line, int column) {
    auto count = warningCounts_.find(id);
    if (count == warningCounts_.end()) count = warningCounts_.emplace(id, 0).first;
    if (count->second++ < kMostOfAKind)
        warnings_.push_back(diagnose(std::string(id), std::string(text), place(line, column)));
}

void FileRemarks::ignored(std::string_view word, int line, int column) {
    auto known = ignored_.find(word);
    if (known == ignored_.end()) {
        if (ignored_.size() == kMostOfAKind) {
            ++otherIgnored_;
            return;
        }
        known = ignored_.emplace(word, Ignored{0, line, column}).first;
    }
    ++known->second.count;
}

Diagnostics FileRemarks::finish() && {
    for (const auto& [word, where] : ignored_)
        warnings_.push_back(diagnose("file-W04",
                                     fmt::format("{} '{}' {} ignored", base::groupedText(where.count),
                                                 shown(word), where.count == 1 ? "line" : "lines"),
                                     place(where.line, where.column)));
    std::ranges::stable_sort(warnings_, [](const Diagnostic& a, const Diagnostic& b) {
        return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    if (otherIgnored_ > 0)
        warnings_.push_back(diagnose(
            "file-W04", fmt::format("{} lines with other words ignored", base::groupedText(otherIgnored_)),
            place(1, 1)));
    for (const auto& [id, count] : warningCounts_)
        if (count > kMostOfAKind)
            warnings_.push_back(
                diagnose(id, fmt::format("{} more of this kind", base::groupedText(count - kMostOfAKind)),
                         place(1, 1)));
    return std::move(warnings_);
}

}  // namespace glibra::geometry
