#pragma once
// What could stand where the arguments of a statement do not fit or end too early. Messages list it in words.

#include <string>
#include <string_view>

namespace glibra::glib {

struct Expectation {
    enum class Kind { word, number, value, expression, color, components, list, other };
    Kind kind = Kind::other;
    std::string text;    ///< as messages say it
    std::string name{};  ///< the word itself, for a key or one of several words; else empty

    /// True if an argument that begins with this word may be it.
    [[nodiscard]] bool mayBegin(std::string_view word) const;
};

}  // namespace glibra::glib
