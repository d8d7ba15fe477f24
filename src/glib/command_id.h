#pragma once

namespace glibra::glib {

/// The commands of the language; aliases have the id of their command. Each classic command has one row in
/// the command table, each modern one in the statement table. Primitives have no names here: their ids are
/// firstPrimitive + index into geometry::primitives().
// clang-format off
enum class CommandId {
    // These act on the frame alone where they stand outside of Once and Step: drawsFrame().
    background, messageBox, verbose, translate, rotate, scale, pushMatrix, popMatrix,
    obj, wireObj, objAdj, objPatch, shp, linesAdjacency, triangles,
    // modern statements of that kind: rows of modern/statement_table.h
    draw, key, pass, endPass, fill, clearParts, viewport, scissor, state, vertices, dispatch, expect, print,

    // The others may decide what Once and Step make: window, view, colour
    windowSize, perspective, ortho, lookAt, color, clear,
    // geometry
    glBegin, glVertex, glNormal, glColor, glTexCoord, glEnd,
    lineWidth, pointSize, pointSizeMode, numPatchVertices, flat, smooth,
    // textures and targets
    texture1D, texture2D, texture3D, texture, cubeMap, renderToTexture, clamp,
    // shaders and programs
    vertex, tessControl, tessEvaluation, geometry, fragment, program,
    geometryInput, geometryOutput, geometryVerticesOut, gstap,
    // noise, time
    noise2D, noise3D, timer,
    // modern statements: rows of modern/statement_table.h
    let, bound, set, material, light, group, endGroup, repeat, endRepeat, when, elseBranch, endWhen,
    include, glslText, use, multMatrix, fps, camera,
    namedTexture1D, namedTexture2D, namedTexture3D, textureArray1D, textureArray, textureRect, namedCubeMap, sampler,
    instances, attribute, tessLevels,
    buffer, mesh, compute, once, endOnce, step, endStep,
    firstPrimitive,
};
// clang-format on

/// True for what acts on the frame alone where it stands outside of Once and Step. The window does not start
/// a simulation again if such a statement changes.
constexpr bool drawsFrame(CommandId id) {
    return id < CommandId::windowSize || id >= CommandId::firstPrimitive;
}

}  // namespace glibra::glib
