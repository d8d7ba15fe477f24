#pragma once
// WebGL 2 has no geometry stage: its work is done by the vertex stage.

#include <string>
#include <vector>

#include "glsl/parse/unit.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// The vertex and the geometry stage of a program as one vertex stage. An instance is a primitive of the
/// mesh, and each of its vertices is one that the geometry stage delivers: it runs the vertex stage for all
/// corners, whose attributes it has as inputs of its own, then the geometry stage, and keeps what that emits
/// in its place. Primitives are numbered in the order in which they are emitted; those that are not emitted
/// lie outside of the picture.
class GeometryInVertex {
  public:
    /// Both were parsed. Call prepare() before they are adapted to GLSL ES.
    /// `fragment` may be null.
    GeometryInVertex(Unit& vertex, Unit& geometry, Unit* fragment, const TranslatedProgram& program)
        : vertex_(vertex), geometry_(geometry), fragment_(fragment), program_(program) {}

    /// Rewrites both. Returns what cannot be expressed, as a text, or nothing.
    std::string prepare();
    /// For a member of a block of inputs of the geometry stage: the size of the array that takes its place,
    /// "[3]".
    std::string pass(const std::string& block, const std::string& member);
    /// A variable in place of a member of a block of outputs of the geometry stage.
    void keep(std::string type, std::string name) {
        blockOutputs_.push_back({std::move(type), std::move(name), {}});
    }
    /// After that, and after the outputs were connected to the fragment stage: the text that follows both.
    [[nodiscard]] std::string ending() const;
    [[nodiscard]] ExpandedGeometry expansion() const;

  private:
    struct Attribute {
        std::string type, name;
    };
    /// A variable of the vertex stage, and the array that the geometry stage reads.
    struct Passed {
        std::string from, to;
    };
    /// What is kept of a vertex that is emitted.
    struct Kept {
        std::string type, name, sizes;
    };
    void prepareVertex();
    std::string prepareGeometry();
    [[nodiscard]] std::vector<Kept> kept() const;
    [[nodiscard]] int cornersOfOutput() const;
    /// How many primitives an invocation delivers at most.
    [[nodiscard]] int most() const;

    Unit& vertex_;
    Unit& geometry_;
    Unit* fragment_;
    const TranslatedProgram& program_;
    int corners_ = 0;  ///< of a primitive of the mesh
    int invocations_ = 1;
    std::vector<Attribute> attributes_;
    std::vector<Passed> passed_;
    std::vector<Kept> blockOutputs_;
};

/// How an input of the vertex stage is named for a corner; ExpandedGeometry says how they are placed.
inline constexpr const char* kCornerInput = "glibra_Corner";

}  // namespace glibra::glsl
