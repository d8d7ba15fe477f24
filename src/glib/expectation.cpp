#include "glib/expectation.h"

#include "glib/text.h"

namespace glibra::glib {
namespace {

bool beginsNumber(std::string_view word) {
    const std::size_t at = word.find_first_not_of("+-.");
    return at < 3 && isDigit(word[at]);
}

}  // namespace

bool Expectation::mayBegin(std::string_view word) const {
    if (beginsNumber(word) || word.starts_with('('))
        return kind == Kind::number || kind == Kind::value || kind == Kind::expression;
    if (word.starts_with('{')) return kind == Kind::color || kind == Kind::components || kind == Kind::value;
    if (word.starts_with('[')) return kind == Kind::list || kind == Kind::components || kind == Kind::value;
    if (word.starts_with('<')) return kind == Kind::value;
    return !word.empty() && word == name;
}

}  // namespace glibra::glib
