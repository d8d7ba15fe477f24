#pragma once
// The inputs and outputs of a translated stage, for programs that read them.

#include <map>
#include <string>
#include <vector>

#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// An input or output of a stage; members of a block are listed one by one.
struct StageVariable {
    std::string name;        ///< as the user wrote it: "vST", "gl_TexCoord", "surface.normal"
    std::string expression;  ///< GLSL that reads it in the translated stage
    std::string type;        ///< GLSL word of a number, vector or matrix
    int elements = 0;        ///< of an array; 0: it is none
    bool isOutput = false;

    /// Numbers of one element.
    [[nodiscard]] int components() const;
    /// GLSL for the number at `component` of an element, converted to float.
    [[nodiscard]] std::string number(int element, int component) const;
};

/// The declared inputs and outputs, in the order of the source. Left out are structures, arrays of arrays and
/// of unknown size, arrays of blocks, and built-in variables. `userNames`: TranslatedProgram::userNames.
std::vector<StageVariable> stageVariables(const TranslatedStage& stage,
                                          const std::map<std::string, std::string>& userNames);

}  // namespace glibra::glsl
