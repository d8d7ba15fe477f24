#include "base/text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <new>
#include <stdexcept>

#include "base/utf8.h"

namespace glibra::base {
namespace {

constexpr bool isXmlCharacter(std::uint32_t code) {
    return code == '\t' || code == '\n' || code == '\r' || (code >= 0x20 && code < 0x7F) ||
           (code >= 0xA0 && code != 0xFFFE && code != 0xFFFF);
}

}  // namespace

std::string escapeXml(std::string_view text) {
    std::string escaped;
    escaped.reserve(text.size());
    while (!text.empty()) {
        const Character next = firstCharacter(text);
        switch (next.code) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                appendUtf8(escaped, isXmlCharacter(next.code) ? next.code : kReplacement);
        }
        text.remove_prefix(next.bytes);
    }
    return escaped;
}

std::string readableBytes(std::uint64_t bytes) {
    constexpr std::array kUnits{"MiB", "GiB", "TiB", "PiB", "EiB"};
    double value = static_cast<double>(bytes) / (1 << 20);
    if (value < 1) return fmt::format("{} bytes", bytes);
    std::size_t unit = 0;
    for (; value >= 1024 && unit + 1 < kUnits.size(); ++unit) value /= 1024;
    return fmt::format("{} {}", std::ceil(value * 10) / 10, kUnits[unit]);
}

std::string reasonOf(const std::exception& problem) {
    if (dynamic_cast<const std::bad_alloc*>(&problem) || dynamic_cast<const std::length_error*>(&problem))
        return "out of memory (--memory)";
    // nlohmann: "[json.exception.type_error.302] type must be number, but is string"
    std::string text = problem.what();
    if (text.starts_with("[json.exception.")) text.erase(0, std::min(text.find("] "), text.size() - 2) + 2);
    constexpr std::string_view kExpected = "type must be ", kFound = ", but is ";
    if (const std::size_t found = text.find(kFound); text.starts_with(kExpected) && found != text.npos)
        return fmt::format("expected {}, found {}", text.substr(kExpected.size(), found - kExpected.size()),
                           text.substr(found + kFound.size()));
    return text;
}

Place placeOfByte(std::string_view text, std::size_t byte, const std::string& file) {
    const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
    const std::size_t lineStart = before.rfind('\n') + 1;  // npos + 1 is 0
    return {file, static_cast<int>(std::ranges::count(before, '\n')) + 1,
            static_cast<int>(before.size() - lineStart) + 1};
}

}  // namespace glibra::base
