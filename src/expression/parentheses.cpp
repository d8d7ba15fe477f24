#include "expression/parentheses.h"

#include "expression/lexer.h"

namespace glibra::expression {

std::size_t partnerOf(std::string_view text, std::size_t open) {
    std::size_t depth = 0;
    for (std::size_t at = open; at < text.size(); ++at) {
        if (text[at] == '#' || text.substr(at, 2) == "//") {
            while (at < text.size() && !isLineEnd(text[at])) ++at;
        } else if (text[at] == '(') {
            ++depth;
        } else if (text[at] == ')' && --depth == 0) {
            return at;
        }
    }
    return std::string_view::npos;
}

}  // namespace glibra::expression
