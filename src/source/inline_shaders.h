#pragma once
// Shaders in the text of a scene: the lines from `Fragment inline` to `EndFragment`, and so for each stage.

#include <optional>
#include <string>
#include <string_view>

#include "glsl/types/stage.h"

namespace glibra::source {

/// The word of the line that ends a shader of that stage: "EndFragment".
std::string endWordOf(glsl::Stage stage);
/// The stage whose shaders end with the word, in any case; nothing: none does.
std::optional<glsl::Stage> stageOfEndWord(std::string_view word);

/// Follows the lines of a scene in their order.
class InlineShaders {
  public:
    /// The stage of the shader that the next line belongs to. Nothing: the line is the scene's own, as those
    /// that begin and end a shader are. A text of Glsl, which any stage may include, counts as a fragment
    /// shader.
    std::optional<glsl::Stage> next(std::string_view line);

  private:
    std::optional<glsl::Stage> stage_;
    bool isShared_ = false;  ///< of Glsl
};

}  // namespace glibra::source
