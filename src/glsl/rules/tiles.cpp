// Draws a part of a larger picture. The positions from the last stage before rasterisation are moved and
// scaled to the tile, and the fragment stage sees the coordinates of the whole picture. This happens after
// the user's own arithmetic, so that it also works for positions that no matrix computes.

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

}  // namespace glibra::glsl
