#pragma once

#include <functional>
#include <string_view>

namespace glibra::glib {

/// What is known about names. A misspelt key is not a declared name.
struct DeclaredNames {
    std::function<bool(std::string_view name)> has;      ///< declared before the statement
    std::function<bool(std::string_view name)> mayHave;  ///< the same, or an included file may declare it
};

}  // namespace glibra::glib
