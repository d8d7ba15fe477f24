#pragma once
// What a live page calls in the module of WebAssembly: one scene in memory, drawn into the page's canvas,
// whose functions of WebGL 2 the page gives as imports. Texts are UTF-8. Answers are JSON and end with a zero
// byte; they are valid until the next call. What ends the module (no memory, a lost context) traps; the page
// then makes a new one.

#include <cstddef>

#define GLIBRA_CALLED_BY_PAGE(name) [[clang::export_name(name)]]

extern "C" {

/// Memory for a text or a file, which the page fills; the function that gets it releases it. Null: no memory.
GLIBRA_CALLED_BY_PAGE("glibra_memory") char* glibra_memory(std::size_t bytes);

/// The content of a file, in place of an earlier one. Names are relative to the root of the page, with '/',
/// as the answers have them. The folders `shaders`, `textures` and `scenes/models` of the root are searched
/// as those of a library are.
GLIBRA_CALLED_BY_PAGE("glibra_file")
void glibra_file(char* name, std::size_t nameBytes, char* content, std::size_t bytes);

/// Reads the scene of that name with what the files have now. Programs, meshes and textures that are still
/// the same are kept, and so are values that were set. A faulty statement is left out, and the rest is drawn.
/// Answers
/// { "drawn": false if there is nothing to draw; then only "messages" follow, and an earlier state stays,
///   "messages": [{ "severity": "error", "warning" or "note", "id", "text", "suggestion", "file", "line",
///                  "column" }],
///   "summary": the first sentence of the first comment, "width", "height": of the scene's window in pixels,
///   "boxes": [texts of MessageBox], "animated", "readsMouse", "hasSteps", "stepRate": steps per second of
///   the fastest Step block, or 0, "files": [{ "name", "language": "glib", "glsl", or "" for pictures, models
///   and other data,
///               "role": "scene", "fragment shader of Wood", "included" or "" }],
///   "missing": [names at which files would be found], "camera": that is looked through, "cameras": [names],
///   "keys": [{ "key": as "k" or "space", "what": it does, "isHeld": it acts while it is down }],
///   "knobs": [{ "owner": the program or "", "name", "widget": "slider", "checkBox", "color" or "numbers",
///               "declaration": as "vec3 uColor", "isInteger", "isShared": other programs have it, too,
///               "minimum", "maximum", "components": of one element of an array,
///               "initial": [numbers], "current": [numbers], "words": [of a choice], "file", "line" }],
///   "shared": [[indices of knobs that one control moves together]] }
GLIBRA_CALLED_BY_PAGE("glibra_open") const char* glibra_open(char* scene, std::size_t bytes);

/// Changes something of the scene:
/// { "knob": index, "values": [numbers], "shared": true for all that move together },
/// { "reset": index, or -1 for all knobs },
/// { "key": that was pressed }, { "key": that is down, "seconds": since the last call },
/// { "camera": name, or "" for the scene's own } or { "restart": true }. Answers
/// { "messages": all so far, if there are others than before,
///   "knobs": [{ "knob": index, "current": [numbers] }] that have changed,
///   "animated", "camera", "restart": true if the time begins at 0 again,
///   "unsure": true if the second frame from now on will report loops that do not end }
GLIBRA_CALLED_BY_PAGE("glibra_set") const char* glibra_set(char* change, std::size_t bytes);

/// Draws a frame into the canvas:
/// { "width", "height": pixels, "time": seconds, "samples": per pixel, "axes": true to show them,
///   "wireframe": true for edges alone,
///   "view": { "scene", "eye", "texture": [16 numbers, column by column],
///             "projection": "scene", "perspective" or "orthographic" },
///   "mouse": [x, y from 0 to 1 from the lower left corner, 1 while the button is down] }
/// What is left out is as at the beginning; the mouse stays as it was. Answers
/// { "drawn", "messages": all so far, if there are others than before, "animated",
///   "around": { "before": the camera's view without "view", "projection": [16 numbers] }, with which the
///   page computes
///             a drag of the mouse, or null, if it has changed }
GLIBRA_CALLED_BY_PAGE("glibra_draw") const char* glibra_draw(char* frame, std::size_t bytes);

/// The lines of a scene or a shader as HTML: an item of a list per line, with its number in `data-line`, and
/// words in <span class="keyword"> and the like. No JSON.
GLIBRA_CALLED_BY_PAGE("glibra_colour")
const char* glibra_colour(bool isScene, char* text, std::size_t bytes);
}
