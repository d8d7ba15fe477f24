// Draws a part of a larger picture. The positions from the last stage before rasterisation are moved and
// scaled to the tile, and the fragment stage sees the coordinates of the whole picture. This happens after
// the user's own arithmetic, so that it also works for positions that no matrix computes. The groups of a
// compute program are counted likewise if they run in several dispatches.

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
    if (!program.request->inPieces || !compute) return;
    struct Row {
        const char* name;
        const char* uniform;
        const char* seen;
    };
    constexpr Row kRows[] = {
        {"gl_WorkGroupID", "glibra_FirstGroup", "(gl_WorkGroupID + glibra_FirstGroup)"},
        {"gl_GlobalInvocationID", "glibra_FirstInvocation",
         "(gl_GlobalInvocationID + glibra_FirstInvocation)"},
        {"gl_NumWorkGroups", "glibra_GroupCount", "glibra_GroupCount"},
    };
    for (const Row& row : kRows) {
        if (!compute->isUsed(row.name) || compute->isDeclared(row.name)) continue;
        compute->declare(std::string("uniform uvec3 ") + row.uniform + ";");
        compute->renames[row.name] = row.seen;
    }
    program.result->inPieces = true;
}

}  // namespace glibra::glsl
