#pragma once
// The text files of a scene, for an editor.

#include <filesystem>
#include <string>
#include <vector>

#include "render/live/live_scene.h"
#include "source/syntax.h"

namespace glibra::view {

struct SourceFile {
    std::filesystem::path path;
    std::string label;  ///< its name; with its folder if another file has the same name
    std::string role;   ///< "scene", "vertex shader of Dots, Lines", "included"
};

/// The scene, the shaders in the order of pipeline stages and programs, and the files that they include. Each
/// file is listed once; missing files are left out.
std::vector<SourceFile> sourceFiles(const render::LiveScene& live);

// The names of source/syntax.h that the editor uses.

using source::CodeLanguage;
using source::SyntaxKind;
using source::syntaxOf;
using source::SyntaxPiece;
using source::SyntaxReader;

}  // namespace glibra::view
