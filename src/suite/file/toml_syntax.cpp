#include "suite/file/toml_syntax.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.h"
#include "glib/text.h"

namespace glibra::suite {
namespace {

/// Hints for the most common mistakes; empty for others. `said` is the message of the parser about `offset`.
std::string_view syntaxHint(std::string_view said, std::string_view text, std::size_t offset) {
    const std::string_view rest = text.substr(offset);
    const bool endsLine = rest.empty() || rest[0] == '\n' || rest[0] == '\r';
    const std::string_view line = text.substr(0, offset).substr(text.substr(0, offset).rfind('\n') + 1);
    const bool isValue = line.find('=') != std::string_view::npos;
    if (rest.size() > 1 && rest[0] == '.' && glib::isDigit(rest[1]))
        return "a number needs a digit before its point, as 0.5";
    if (rest.size() > 1 && glib::isDigit(rest[0]) && rest[1] == '.' &&
        (rest.size() == 2 || !glib::isDigit(rest[2])))
        return "a number needs a digit after its point, as 1.0";
    if (said.starts_with("boolean") &&
        (glib::sameWord(rest.substr(0, 4), "true") || glib::sameWord(rest.substr(0, 5), "false")))
        return "true and false are written in small letters";
    if (rest.starts_with("\xe2\x80\x98") || rest.starts_with("\xe2\x80\x9c"))
        return "a text stands between plain quotes, as \"teapot.glib\"";
    if (said.starts_with("string") && endsLine) return "the closing quote is missing";
    if (said.starts_with("inline table") && endsLine)
        return "a table in braces stands on one line; of a long one each key gets a line: set.uKd = 0.5";
    if (!rest.empty() && rest[0] == ':' && !isValue) return "a key and its value have '=' between them";
    const bool isWord = said.starts_with("value") || said.starts_with("boolean") ||
                        (said.starts_with("decimal integer") && !rest.empty() && glib::isLetter(rest[0]));
    if (isWord && isValue) return "a text needs quotes, as \"teapot.glib\"";
    return {};
}

/// Returns the offset after the string that begins at `begin`: of one line, or of several lines between three
/// quotes.
std::size_t endOfString(std::string_view text, std::size_t begin) {
    const char quote = text[begin];
    const std::string three(3, quote);
    const bool isLong = text.substr(begin).starts_with(three);
    std::size_t at = begin + (isLong ? 3 : 1);
    for (; at < text.size(); ++at) {
        if (quote == '"' && text[at] == '\\')
            ++at;
        else if (isLong && text.substr(at).starts_with(three))
            return at + 3;
        else if (!isLong && (text[at] == quote || text[at] == '\n'))
            return at + 1;
    }
    return text.size();
}

}  // namespace

std::string syntaxMessage(std::string_view said, std::string_view text, std::size_t offset) {
    constexpr std::string_view kPreamble = "Error while parsing ";
    if (said.starts_with(kPreamble)) said.remove_prefix(kPreamble.size());
    if (said.find("TOML_MAX_NESTED_VALUES") != std::string_view::npos)
        return "not TOML: arrays and tables stand too deep in each other";
    const std::string_view hint = syntaxHint(said, text, offset);
    return fmt::format("not TOML: {}{}{}", base::printableText(said), hint.empty() ? "" : "; ", hint);
}

std::optional<std::size_t> endlessKey(std::string_view text) {
    constexpr int kMostParts = 16;
    int dots = 0;
    std::size_t begin = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"' || c == '\'') {
            at = endOfString(text, at) - 1;
        } else if (c == '#') {
            at = std::min(text.find('\n', at), text.size()) - 1;
        } else if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) {
            dots = 0;
            begin = at + 1;
        } else if (c == '.' && ++dots == kMostParts) {
            return std::min(text.find_first_not_of(" \t", begin), at);
        }
    }
    return std::nullopt;
}

}  // namespace glibra::suite
