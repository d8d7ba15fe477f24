#include "source/code_html.h"

#include <fmt/format.h>

#include <array>

#include "base/text.h"

namespace glibra::source {
namespace {

constexpr std::size_t kLongestLine = 2'000;  // bytes

std::string lineHtml(std::string_view line, SyntaxReader& reader) {
    constexpr std::array kClasses{"", "keyword", "type", "number", "comment", "directive", "builtin"};
    std::string html;
    std::size_t at = 0;
    for (const SyntaxPiece& each : reader.next(line)) {
        html += base::escapeXml(line.substr(at, each.begin - at));
        html += fmt::format("<span class=\"{}\">{}</span>", kClasses.at(static_cast<std::size_t>(each.kind)),
                            base::escapeXml(line.substr(each.begin, each.end - each.begin)));
        at = each.end;
    }
    return html + base::escapeXml(line.substr(at));
}

}  // namespace

std::string codeHtml(std::string_view text, CodeLanguage language) {
    SyntaxReader reader(language);
    std::string html = "<ol>";
    for (int number = 1; !text.empty(); ++number) {
        const std::string_view line = base::nextLine(text);
        html += fmt::format("<li data-line=\"{}\">{}</li>", number,
                            lineHtml(line.substr(0, kLongestLine), reader));
    }
    return html + "</ol>";
}

}  // namespace glibra::source
