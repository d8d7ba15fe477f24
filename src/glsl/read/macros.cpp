#include "glsl/read/macros.h"

#include <algorithm>

namespace glibra::glsl {

bool Macro::isSameAs(const Macro& other) const {
    return takesArguments == other.takesArguments && parameters == other.parameters &&
           std::equal(body.begin(), body.end(), other.body.begin(), other.body.end(),
                      [&](const BodyToken& a, const BodyToken& b) {
                          const bool isFirst = &a == body.data();
                          return a.text == b.text && (isFirst || a.blank == b.blank) &&
                                 a.isPasted == b.isPasted;
                      });
}

void MacroTable::define(std::string_view name, Macro macro) {
    current_.insert_or_assign(name, &all_.emplace_back(std::move(macro)));
}

}  // namespace glibra::glsl
