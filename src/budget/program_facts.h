#pragma once
// The facts about a program that decide how fine the meshes that it draws have to be.

#include "plan/program_variant.h"

namespace glibra::budget {

struct ProgramFacts {
    bool isBuiltin = false;          ///< draws one colour: at the vertices it computes only their positions
    bool placesByMatrix = false;     ///< provably places vertices by the model-view-projection alone
    bool readsTexCoord = false;      ///< reads texture coordinates
    bool worksOnPrimitives = false;  ///< has a tessellation or geometry stage
    bool hasTessellation = false;
    /// It reads normals or tangents, which between vertices differ from those of the surface, and its
    /// fragment stage looks into a cube map along a reflection, or refracts.
    bool magnifiesNormals = false;
    /// Its vertex stage calls functions other than constructors and normalize(), so its results may not be
    /// linear between the vertices.
    bool computesAtVertices = false;
    /// It shows the single triangles (glsl::StageFacts::showsPrimitives), so a mesh with other counts would
    /// show something else.
    bool showsPrimitives = false;
};

ProgramFacts programFacts(const plan::ProgramInterface& program);

}  // namespace glibra::budget
