#include "glsl/read/source_line.h"

namespace glibra::glsl {

std::string SourceLine::includedName() const {
    if (significant.size() < 3) return {};
    const char* const begin = significant[2]->text.data();
    // The tokens of a line are adjacent in the text. What looks like a comment may belong to the name.
    const char* end = begin;
    for (const Token* each = significant[2]; each <= &tokens.back(); ++each)
        if (each->kind != TokenKind::splice && each->kind != TokenKind::newline)
            end = each->text.data() + each->text.size();
    const std::string_view rest(begin, static_cast<std::size_t>(end - begin));
    if (rest.empty()) return {};
    if (rest.front() != '<' && rest.front() != '"')
        return significant.size() == 3 && significant[2]->kind == TokenKind::word
                   ? std::string(significant[2]->text)
                   : std::string();
    const std::size_t close = rest.find(rest.front() == '<' ? '>' : '"', 1);
    return close == std::string_view::npos ? std::string{} : std::string(rest.substr(1, close - 1));
}

std::string SourceLine::joined() const {
    std::string text;
    for (const Token* each = significant.front(); each <= significant.back(); ++each)
        text += isSignificant(each->kind) ? each->text : std::string_view(" ");
    return text;
}

}  // namespace glibra::glsl
