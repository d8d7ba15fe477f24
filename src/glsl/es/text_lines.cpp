#include "glsl/es/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>

#include "glsl/emit/emit.h"

namespace glibra::glsl {

std::vector<std::string_view> textLines(std::string_view text) {
    std::vector<std::string_view> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

std::string withSource(std::string_view directive, int before) {
    std::string text;
    std::ranges::copy_if(directive, std::back_inserter(text), [](char c) { return c != '"'; });
    const std::size_t lineAt = text.find(' ') + 1, sourceAt = text.find(' ', lineAt) + 1;
    if (lineAt == 0 || sourceAt == 0) return text;
    int line = 0, source = 0;
    std::from_chars(text.data() + lineAt, text.data() + text.size(), line);
    std::from_chars(text.data() + sourceAt, text.data() + text.size(), source);
    source += before;
    return fmt::format("#line {} {}", source * kLinesOfSource + line % kLinesOfSource, source);
}

}  // namespace glibra::glsl
