#include "budget/program_facts.h"

#include "geometry/mesh.h"
#include "glsl/types/builtins.h"

namespace glibra::budget {

ProgramFacts programFacts(const plan::ProgramInterface& program) {
    ProgramFacts facts;
    facts.isBuiltin = program.isBuiltin;
    facts.placesByMatrix = program.isBuiltin || program.facts.placement != glsl::Placement::unknown;
    bool readsNormals = false;
    for (const plan::ActiveInput& each : program.inputs)
        if (const glsl::BuiltinInput* row = glsl::findBuiltinInput(each.name); row != nullptr) {
            facts.readsTexCoord = facts.readsTexCoord || row->attribute == geometry::kTexCoord;
            readsNormals =
                readsNormals || row->attribute == geometry::kNormal || row->attribute == geometry::kTangent;
        }
    for (const glsl::TranslatedStage& each : program.facts.stages) {
        const bool isVertex = each.stage == glsl::Stage::vertex;
        const bool isFragment = each.stage == glsl::Stage::fragment;
        facts.worksOnPrimitives = facts.worksOnPrimitives || !(isVertex || isFragment);
        facts.hasTessellation = facts.hasTessellation || each.stage == glsl::Stage::tessEvaluation;
        facts.computesAtVertices = facts.computesAtVertices || (isVertex && each.facts.callsFunctions);
        facts.showsPrimitives = facts.showsPrimitives || each.facts.showsPrimitives;
        if (isFragment) facts.magnifiesNormals = readsNormals && each.facts.magnifiesNormals;
    }
    return facts;
}

}  // namespace glibra::budget
