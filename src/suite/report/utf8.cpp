#include "suite/report/utf8.h"

#include <algorithm>

namespace glibra::suite {
namespace {

constexpr std::uint32_t kReplacement = 0xFFFD;

constexpr bool isXmlCharacter(std::uint32_t code) {
    return code == '\t' || code == '\n' || code == '\r' || (code >= 0x20 && code < 0x7F) ||
           (code >= 0xA0 && code != 0xFFFE && code != 0xFFFF);
}

}  // namespace

Character firstCharacter(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
    };
    const std::uint32_t lead = byte(0);
    if (lead < 0x80) return {lead, 1, true};
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    constexpr Character kBad{kReplacement, 1, false};
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return kBad;
    std::uint32_t code = lead & (0x7FU >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0U) != 0x80) return kBad;
        code = code << 6U | (byte(i) & 0x3FU);
    }
    const bool tooLong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    if (tooLong || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF)) return kBad;
    return {code, length, true};
}

bool isUtf8(std::string_view text) {
    while (!text.empty()) {
        const Character next = firstCharacter(text);
        if (!next.valid) return false;
        text.remove_prefix(next.bytes);
    }
    return true;
}

void appendUtf8(std::string& text, std::uint32_t code) {
    const auto put = [&](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0U | code >> 6U);
        put(0x80U | (code & 0x3FU));
    } else if (code < 0x10000) {
        put(0xE0U | code >> 12U);
        put(0x80U | (code >> 6U & 0x3FU));
        put(0x80U | (code & 0x3FU));
    } else {
        put(0xF0U | code >> 18U);
        put(0x80U | (code >> 12U & 0x3FU));
        put(0x80U | (code >> 6U & 0x3FU));
        put(0x80U | (code & 0x3FU));
    }
}

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

std::string printableText(std::string_view text, bool keepLines) {
    std::string printable;
    printable.reserve(text.size());
    while (!text.empty()) {
        const Character next = firstCharacter(text);
        if (next.code == '\t' || (next.code == '\n' && !keepLines))
            printable += ' ';
        else if (next.code == '\n' || (next.code >= 0x20 && isXmlCharacter(next.code)))
            appendUtf8(printable, next.code);
        else
            appendUtf8(printable, kReplacement);
        text.remove_prefix(next.bytes);
    }
    return printable;
}

}  // namespace glibra::suite
