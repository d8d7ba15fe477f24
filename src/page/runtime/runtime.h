#pragma once
// What a live page calls in the module of WebAssembly: one scene in memory, drawn into the page's canvas, whose
// functions of WebGL 2 the page gives as imports. Texts are UTF-8 and end with a zero byte. Answers are JSON, valid
// until the next call. What ends the module (no memory, a lost context) traps; the page then makes a new one.

#include <cstddef>

extern "C" {

/// Memory for the bytes of a text or a file, which the page fills; it ends with glibra_release().
char* glibra_memory(std::size_t bytes);
void glibra_release(char* memory);

/// The content of a file, in place of an earlier one. Names are relative to the folder of the page, with '/', as
/// the answers have them.
void glibra_file(const char* name, const char* content, std::size_t bytes);

/// Reads the scene of that name with what the files have now. Programs, meshes and textures that are still the same
/// are kept, and so are values that were set. A faulty statement is left out, and the rest is drawn:
/// { "drawn": false if there is nothing to draw,
///   "messages": [{ "severity": "error", "id", "text", "suggestion", "file", "line", "column" }],
///   "title", "width", "height": of its window, "animated", "readsMouse", "hasSteps",
///   "files": [{ "name", "language": "glib", "glsl" or "" }], "missing": [names],
///   "cameras": [names],
///   "keys": [{ "key", "text", ... }],
///   "knobs": [{ "owner": the program or "", "name", "widget": "slider", "checkBox", "color", "choice" or "numbers",
///               "declaration", "isInteger", "minimum", "maximum", "components", "initial": [numbers],
///               "current": [numbers], "words": [of a choice], "shared": [indices of knobs that move together] }] }
const char* glibra_open(const char* scene);

/// Sets the value of a knob: { "knob": index, "values": [numbers] }. Answers like glibra_open() what has changed.
const char* glibra_set(const char* change);

/// Draws a frame into the canvas: { "width", "height": pixels, "time": seconds, "samples",
/// "view": { "scene", "eye", "texture": [16 numbers], "projection": "scene", "perspective" or "orthographic" },
/// "camera": name or "", "mouse": [x, y, 1 while the button is down], "restart": true to begin steps anew }.
/// Answers { "messages": [...], "knobs": changed current values }.
const char* glibra_draw(const char* frame);

/// The lines of a text as HTML, coloured: { "name": of the file, for its language, "text" }.
const char* glibra_colour(const char* source);
}
