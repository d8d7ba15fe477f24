#include "base/utf8.h"

#include <fmt/format.h>

#include <array>
#include <iterator>

namespace glibra::base {
namespace {

struct Range {
    std::uint32_t first, last;
};
/// Characters from U+0080 on that a terminal obeys, does not show, or shows in another order.
constexpr std::array kUnsafe{
    Range{0x80, 0x9F},        // C1 controls, such as U+009B for ESC [
    Range{0x61C, 0x61C},      // Arabic letter mark
    Range{0x200B, 0x200B},    // zero width space
    Range{0x200E, 0x200F},    // directional marks
    Range{0x2028, 0x202E},    // line separators, directional embeddings and overrides
    Range{0x2060, 0x206F},    // invisible operators, directional isolates
    Range{0xFEFF, 0xFEFF},    // byte order mark
    Range{0xFFF9, 0xFFFB},    // interlinear annotation
    Range{0xE0000, 0xE0FFF},  // tags
};

bool isUnsafe(std::uint32_t code) {
    if (code < 0x20 || code == 0x7F) return true;
    if ((code & 0xFFFEU) == 0xFFFE) return true;  // no characters, in every plane
    for (const Range& each : kUnsafe)
        if (code >= each.first && code <= each.last) return true;
    return false;
}

/// What nobody sees: "no-break space". Empty for other characters.
std::string_view invisibleName(std::uint32_t code) {
    switch (code) {
        case 0x00A0:
        case 0x202F:
            return "no-break space";
        case 0x00AD:
            return "soft hyphen";
        case 0x200B:
            return "zero-width space";
        case 0x200C:
        case 0x200D:
            return "zero-width joiner";
        case 0x200E:
        case 0x200F:
            return "mark of direction";
        case 0x2028:
        case 0x2029:
            return "line separator";
        case 0x2060:
            return "word joiner";
        case 0x3000:
            return "ideographic space";
        case 0xFEFF:
            return "byte order mark";
        default:
            break;
    }
    const bool isBlank = code == 0x1680 || (code >= 0x2000 && code <= 0x200A) || code == 0x205F;
    if (isBlank) return "wide or narrow blank";
    return isUnsafe(code) ? "invisible character" : "";
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

std::string onlyUtf8(std::string_view text) {
    std::string valid;
    while (!text.empty()) {
        const Character next = firstCharacter(text);
        appendUtf8(valid, next.code);
        text.remove_prefix(next.bytes);
    }
    return valid;
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

std::string visibleCharacter(std::string_view text) {
    const Character first = firstCharacter(text);
    const std::string_view name = invisibleName(first.code);
    if (name.empty()) return fmt::format("'{}'", text.substr(0, first.bytes));
    return fmt::format("'\\u{:04x}' ({})", first.code, name);
}

std::string printableText(std::string_view text, bool keepLines) {
    std::string printable;
    printable.reserve(text.size());
    const auto to = std::back_inserter(printable);
    while (!text.empty()) {
        const Character next = firstCharacter(text);
        if (!next.valid ||
            (next.code != '\n' && next.code != '\t' && next.code < 0x80 && isUnsafe(next.code)))
            fmt::format_to(to, "\\x{:02x}", static_cast<unsigned char>(text.front()));
        else if (next.code == '\t' || (next.code == '\n' && !keepLines))
            printable += ' ';
        else if (next.code == '\n' || !isUnsafe(next.code))
            printable.append(text.substr(0, next.bytes));
        else if (next.code < 0x10000)
            fmt::format_to(to, "\\u{:04x}", next.code);
        else
            fmt::format_to(to, "\\U{:08x}", next.code);
        text.remove_prefix(next.bytes);
    }
    return printable;
}

}  // namespace glibra::base
