#pragma once
// The text files of a scene, for an editor, and what a file is to a scene.

#include <filesystem>
#include <span>
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

// Names of files in a list, with as much of their folders as tells equal names apart.

/// The shortest end of each path that no other one has: "planet.glib", or "first/planet.glib" and
/// "second/planet.glib". Equal paths have equal names.
std::vector<std::string> namesApart(std::span<const std::filesystem::path> files);

// Finds out how a scene uses a file.

struct FileUse {
    enum class Kind {
        none,
        text,     ///< the scene itself, a shader or an included file
        texture,  ///< a texture on the device
        data      ///< a model, or a texture that no visible object samples
    };
    Kind kind = Kind::none;
    scene::TextureIndex texture{};
    Place place;  ///< the first line of a text; the statement that names a texture or data file
};

/// Links are followed: two names of the same file are equal.
FileUse useOf(const render::LiveScene& live, const std::filesystem::path& file);

}  // namespace glibra::view
