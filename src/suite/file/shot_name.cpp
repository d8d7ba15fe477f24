#include "suite/file/shot_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "glib/text.h"

namespace glibra::suite {
namespace {

constexpr std::size_t kLongestPart = 200;  // leaves room for ".nvidia.png" in the 255 bytes of a file name
constexpr std::size_t kLongestName = 1000;

bool isNameCharacter(char c) {
    return glib::isLetter(c) || glib::isDigit(c) ||
           std::string_view("._-=,@+").find(c) != std::string_view::npos;
}

}  // namespace

std::string whyNotAName(std::string_view name) {
    if (name.empty()) return "is empty";
    if (name.size() > kLongestName) return fmt::format("has more than {} bytes", kLongestName);
    if (name.starts_with('/')) return "begins with '/'; names are relative";
    std::string_view rest = name;
    while (true) {
        const std::size_t slash = rest.find('/');
        const std::string_view part = rest.substr(0, slash);
        if (part.empty()) return "has an empty part";
        if (part == "." || part == "..") return fmt::format("has '{}' in it", part);
        if (part.starts_with('.')) return "has a part that begins with '.'";
        if (part.size() > kLongestPart) return fmt::format("has a part of more than {} bytes", kLongestPart);
        const auto* const bad = std::ranges::find_if_not(part, isNameCharacter);
        if (bad != part.end()) {
            std::size_t length = 1;
            while (bad + length != part.end() && (static_cast<unsigned char>(bad[length]) & 0xc0U) == 0x80U)
                ++length;
            const std::string_view character(bad, length);
            const bool isControl = length == 1 && (static_cast<unsigned char>(*bad) < 0x20 || *bad == 0x7f);
            return fmt::format("has {} in it; letters, digits and . _ - = , @ + can be in a name",
                               isControl ? "a control character" : fmt::format("'{}'", character));
        }
        if (slash == std::string_view::npos) return {};
        rest.remove_prefix(slash + 1);
    }
}

std::string nameOnAnyDisk(std::string_view name) {
    std::string folded;
    for (const char c : name) {
        while (c == '/' && folded.ends_with('.')) folded.pop_back();
        folded += glib::lower(c);
    }
    return folded;
}

std::string_view shotOfVariant(std::string_view name) {
    const std::size_t dot = name.rfind('.');
    if (dot == std::string_view::npos) return {};
    std::string_view family = name.substr(dot + 1);
    constexpr std::string_view kOsmesa = "osmesa-";
    if (family.starts_with(kOsmesa)) family.remove_prefix(kOsmesa.size());
    const bool isWord = !family.empty() && std::ranges::all_of(family, glib::isLetter);
    const bool isFurther = family.starts_with(kFurtherVariant) &&
                           family.size() == kFurtherVariant.size() + 1 && family.back() >= '1' &&
                           family.back() <= '9';
    return isWord || isFurther || family == "d3d12" ? name.substr(0, dot) : std::string_view();
}

std::string nameOfScene(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    const std::size_t dot = path.rfind('.');
    if (dot != std::string_view::npos && (slash == std::string_view::npos || dot > slash + 1) && dot > 0)
        path = path.substr(0, dot);
    std::string name;
    for (const char c : path) {
        const bool beginsPart = name.empty() || name.back() == '/';
        if ((static_cast<unsigned char>(c) & 0xc0U) == 0x80U) continue;
        const bool stays = (isNameCharacter(c) && !(c == '.' && beginsPart)) || (c == '/' && !beginsPart);
        name += stays ? c : '_';
    }
    return name;
}

bool isAddress(std::string_view store) {
    return store.find("://") != std::string_view::npos;
}

std::string whyNoStore(std::string_view text) {
    if (!isAddress(text)) {
        if (text.find(kHashSlot) == std::string_view::npos) return {};
        return "expected a folder without {hash}, or an address as \"https://host/place/{hash}.png\"";
    }
    const auto scheme = text.substr(0, text.find("://"));
    if (scheme != "https" && scheme != "http")
        return "expected a folder, or an address that begins with https://, as buckets have one, too";
    const std::size_t at = text.find(kHashSlot);
    if (at == std::string_view::npos || text.find(kHashSlot, at + 1) != std::string_view::npos ||
        text.find('/', at) != std::string_view::npos || text.rfind('/', at) < scheme.size() + 3)
        return "expected {hash} once, after the last '/', as in \"https://host/place/{hash}.png\"";
    std::string rest(text);
    rest.erase(at, kHashSlot.size());
    if (std::ranges::any_of(rest, [](unsigned char c) {
            return c <= ' ' || c >= 0x7F ||
                   std::string_view("{}[]?#\"'\\<>@`^|").find(static_cast<char>(c)) != std::string_view::npos;
        }))
        return "expected an address of letters, digits and -._~%/:!$&()*+,;= only";
    return {};
}

}  // namespace glibra::suite
