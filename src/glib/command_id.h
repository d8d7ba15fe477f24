#pragma once

namespace glibra::glib {

/// The statements of the language; aliases have the id of their statement. Each has one row in
/// statement_rows.cpp, the stages and Program one for each form. Primitives have no names here: their ids are
/// firstPrimitive + index into geometry::primitives().
// clang-format off
enum class CommandId {
    // window, view, colour
    windowSize, perspective, ortho, lookAt, color, background, clear,
    translate, rotate, scale, pushMatrix, popMatrix,
    // geometry
    obj, wireObj, objAdj, objPatch, shp, linesAdjacency, triangles,
    glBegin, glVertex, glNormal, glColor, glTexCoord, glEnd,
    lineWidth, pointSize, pointSizeMode, numPatchVertices, flat, smooth,
    // textures and targets
    texture1D, texture2D, texture3D, texture, cubeMap, renderToTexture, clamp,
    // shaders and programs
    vertex, tessControl, tessEvaluation, geometry, fragment, program,
    geometryInput, geometryOutput, geometryVerticesOut, gstap,
    // noise, time, messages
    noise2D, noise3D, timer, messageBox, verbose,
    // modern statements
    let, bound, set, material, light, group, endGroup, draw, repeat, endRepeat, when, elseBranch, endWhen,
    include, glslText, use, key, multMatrix, fps, camera,
    namedTexture1D, namedTexture2D, namedTexture3D, textureArray1D, textureArray, textureRect, namedCubeMap, sampler,
    pass, endPass, fill, clearParts, viewport, scissor, state, instances, vertices, attribute, tessLevels,
    buffer, mesh, compute, dispatch, once, endOnce, step, endStep, expect, print,
    firstPrimitive,
};
// clang-format on

}  // namespace glibra::glib
