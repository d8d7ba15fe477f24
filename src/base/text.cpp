#include "base/text.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

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

}  // namespace glibra::base
