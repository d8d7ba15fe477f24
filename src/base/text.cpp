#include "base/text.h"

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

}  // namespace glibra::base
