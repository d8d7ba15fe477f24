#pragma once
// Messages about shaders that a scene must not show: files outside of its folder and the library.

#include <string_view>

namespace glibra::render {

/// How such a message begins. The line that it names must not be quoted either.
inline constexpr std::string_view kHiddenText = "the text of this message is not shown";

}  // namespace glibra::render
