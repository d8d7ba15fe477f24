// Draws a part of a larger picture. The positions from the last stage before rasterisation are moved and
// scaled to the tile, and the fragment stage sees the coordinates of the whole picture. This happens after
// the user's own arithmetic, so that it also works for positions that no matrix computes. The groups of a
// compute program are counted likewise if they run in several dispatches, or in reverse.

#include "glsl/rules/rules.h"

namespace glibra::glsl {

void placeInTile(ProgramUnits& program) {
    if (!program.request->tiled) return;
    if (Unit* last = program.lastBeforeRaster()) {
        const std::string moved =
            "vec4(gl_Position.xy * glibra_Tile.xy + glibra_Tile.zw * gl_Position.w, gl_Position.zw)";
        last->declare("uniform vec4 glibra_Tile;");
        if (last->stage == Stage::geometry) {
            // The position is restored for shaders that emit it twice.
            last->declare("void glibra_emitInTile() { vec4 whole = gl_Position; gl_Position = " + moved +
                          "; EmitVertex(); gl_Position = whole; }");
            last->renames["EmitVertex"] = "glibra_emitInTile";
            program.result->userNames["glibra_emitInTile"] = "EmitVertex";
        } else {
            last->mainEnd.push_back("gl_Position = " + moved + ";");
        }
    }
    Unit* fragment = program.find(Stage::fragment);
    if (!fragment || !fragment->isUsed("gl_FragCoord") || fragment->isDeclared("gl_FragCoord")) return;
    fragment->declare("uniform vec2 glibra_TileOrigin;");
    fragment->renames["gl_FragCoord"] = "(gl_FragCoord + vec4(glibra_TileOrigin, 0., 0.))";
}

void runInPieces(ProgramUnits& program) {
    Unit* compute = program.find(Stage::compute);
    const bool inPieces = program.request->inPieces;
    const bool isReversed = program.request->reversesOrder;
    if ((!inPieces && !isReversed) || !compute) return;
    struct Row {
        std::string name, uniform, seen;
        std::string count{};  ///< of what the name numbers
    };
    const std::string groups = inPieces ? "glibra_GroupCount" : "gl_NumWorkGroups";
    const Row rows[] = {
        {"gl_WorkGroupID", "glibra_FirstGroup", "(gl_WorkGroupID + glibra_FirstGroup)", groups},
        {"gl_GlobalInvocationID", "glibra_FirstInvocation",
         "(gl_GlobalInvocationID + glibra_FirstInvocation)", groups + " * gl_WorkGroupSize"},
        {"gl_NumWorkGroups", "glibra_GroupCount", "glibra_GroupCount"},
        {"gl_LocalInvocationID", "", "", "gl_WorkGroupSize"},
        {"gl_LocalInvocationIndex", "", "", "gl_WorkGroupSize.x * gl_WorkGroupSize.y * gl_WorkGroupSize.z"},
    };
    for (const Row& row : rows) {
        if (!compute->isUsed(row.name) || compute->isDeclared(row.name)) continue;
        const bool isOfPieces = inPieces && !row.uniform.empty();
        const bool isCounted = isReversed && !row.count.empty();
        if (!isOfPieces && !isCounted) continue;
        const auto uniform = [&](const std::string& name) {
            compute->declare("uniform uvec3 " + name + ";");
        };
        if (isOfPieces) uniform(row.uniform);
        if (isCounted && row.count.starts_with("glibra_")) uniform(groups);
        const std::string seen = isOfPieces ? row.seen : row.name;
        compute->renames[row.name] = isCounted ? "(" + row.count + " - 1u - " + seen + ")" : seen;
    }
    program.result->inPieces = inPieces;
}

}  // namespace glibra::glsl
