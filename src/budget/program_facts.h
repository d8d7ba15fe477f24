#pragma once
// What of a program decides how fine the meshes have to be that it draws.

#include <string_view>

#include "plan/program_interface.h"

namespace glibra::budget {

struct ProgramFacts {
    bool isBuiltin = false;       ///< one colour: nothing is computed at the vertices but their places
    bool placesByMatrix = false;  ///< by the model-view-projection alone, as its text proves
    bool readsTexCoord = false;
    bool worksOnPrimitives = false;  ///< has a tessellation or geometry stage
    bool hasTessellation = false;
    /// It reads normals or tangents, which between vertices are not those of the surface, and its fragment
    /// stage looks into a cube map along a reflection or refracts, as far as the words in its text say.
    bool magnifiesNormals = false;
    /// Its vertex stage calls functions but constructors and normalize(), as far as the words in its text
    /// say: what it makes of the vertices may not be linear between them.
    bool computesAtVertices = false;
    /// Something is flat on a triangle, counts triangles or vertices, or takes a normal from derivatives, as
    /// far as the words in its text say: with other counts it would show something else.
    bool showsPrimitives = false;
};

/// True if the text has it as a word of its own.
bool hasWord(std::string_view text, std::string_view word);

ProgramFacts programFacts(const plan::ProgramInterface& program);

}  // namespace glibra::budget
