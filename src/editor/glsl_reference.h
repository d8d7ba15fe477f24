#pragma once
// The functions and built-in variables of GLSL: one row each, with its signature and a short description
// (The OpenGL Shading Language 4.50, chapters 7 and 8; 1.20 for the functions that later versions lack).

#include <span>
#include <string_view>

#include "glsl/types/stage.h"

namespace glibra::editor {

/// T stands for float and vectors of floats, I for int, uint and vectors of them, S for any type of sampler,
/// G for any type of image, and P for the coordinates that the sampler or image takes.
struct GlslRow {
    std::string_view name;
    std::string_view signature;
    std::string_view summary;
    int since = 110;           ///< the first #version that has it
    std::string_view where{};  ///< letters of stages: v c e g f k (compute); empty: all
    int until = 1000;          ///< the first #version that has it no more
};

/// All rows, grouped by subject.
std::span<const GlslRow> glslTable();

/// The row of that name; null if there is none.
const GlslRow* findGlsl(std::string_view name);

/// True if shaders of that stage have the row.
bool isIn(const GlslRow& row, glsl::Stage stage);
/// True if the keyword has a meaning in shaders of that stage: "discard" in the fragment stage alone.
bool isKeywordIn(std::string_view keyword, glsl::Stage stage);

}  // namespace glibra::editor
