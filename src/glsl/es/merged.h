#pragma once
// GLSL ES 3.00 has no stages but that of vertices and that of fragments: those between them become parts of
// the first.

#include <optional>
#include <string>
#include <vector>

#include "glsl/es/geometry.h"
#include "glsl/es/parts.h"
#include "glsl/es/stage.h"
#include "glsl/es/tessellation.h"
#include "glsl/parse/unit.h"
#include "glsl/types/request.h"
#include "glsl/types/translated_program.h"

namespace glibra::glsl {

/// The stages before the fragment stage as one vertex stage, where there are more than that.
class MergedStages {
  public:
    MergedStages(std::vector<Unit>& units, std::vector<EsStage>& stages, const TranslatedProgram& program,
                 const DrawForms& draws);

    /// Of what the stages become.
    [[nodiscard]] ExpandedGeometry expansion() const;
    /// In place of the stages of `program`.
    void join(std::vector<TranslatedStage>& stages) const;

  private:
    EsStage& of(const Unit& unit) { return stages_[static_cast<std::size_t>(&unit - first_)]; }

    /// The fragment stage discards what lies behind a plane: pixels whose centres are cut away have a
    /// negative distance (OpenGL 4.6 Core, 13.7.1).
    void clip(Unit* fragment, int count);
    /// The fragment stage gets the number of its primitive from the vertices.
    void numberPrimitives(Unit& fragment);
    [[nodiscard]] bool isFetched() const;
    /// Reports that the stage is needed, if `problem` or the forms of the draws keep it from becoming a part.
    void lacks(const Unit& unit, const char* what, std::string problem);
    void tessellate(const TranslatedProgram& program);
    void build(Unit* fragment, const TranslatedProgram& program);
    /// The main function of the merged stage, and the functions that it calls.
    [[nodiscard]] std::string ending() const;

    std::vector<EsStage>& stages_;
    const DrawForms& draws_;
    Unit *vertex_, *control_, *evaluation_, *geometry_;  ///< null: there is none
    Unit* last_;                                         ///< before the fragment stage
    const Unit* first_;
    static constexpr const char* kPrimitive = "glibra_PrimitiveID";
    static constexpr const char* kDistances = "glibra_ClipDistance";
    int corners_ = 0;  ///< of a primitive of the mesh
    bool numbersPrimitives_ = false;
    std::optional<TessellationInVertex> tessellation_;
    std::optional<CornerStage> own_;  ///< the vertex stage before a geometry stage
    std::optional<GeometryInVertex> built_;
};

}  // namespace glibra::glsl
