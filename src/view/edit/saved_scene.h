#pragma once
// Writes the current values of knobs, and the names of files that the user has chosen, into the text of a
// scene.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/live/knobs.h"
#include "render/live/live_scene.h"
#include "view/edit/edited_file.h"

namespace glibra::view {

/// The scene's text with the value of every changed knob replaced; all other bytes stay. If a value is no
/// longer where it was read from, the result is the error view-E01.
Result<std::string> withValues(std::string_view text, std::span<const render::Knob> knobs);

/// A file that the user has chosen for a statement that names none. Edits may move the line, so it is found
/// by its text.
struct ChosenFile {
    std::string line;    ///< the text of the line, without blanks at its ends
    int occurrence = 0;  ///< among the lines of that text, counted from 0
    std::string name;    ///< as the scene would name the file
};

/// The choice of `file` for the statement in that line. The file is named relative to the scene if it is
/// below the scene's folder. Nothing if the text has no such line.
std::optional<ChosenFile> chosenFile(std::string_view text, const Place& place,
                                     const std::filesystem::path& file);

/// The text with the names of the files at the ends of their statements, before comments. The numbers of
/// lines stay.
std::string withFiles(std::string_view text, std::span<const ChosenFile> files);

/// Writes values and names of files into the text of a scene, which is written atomically. `edited`: the text
/// of the scene in an editor, which gets them too (EditedFile::changeFile); may be null.
Diagnostics saveValues(const std::filesystem::path& scene, std::span<const render::Knob> knobs,
                       std::span<const ChosenFile> files = {}, EditedFile* edited = nullptr);

// Copies a scene to another place, with the files that it would not find there.

/// A file of a scene that goes along with a copy of the scene.
struct CopiedFile {
    std::filesystem::path from, to;
};

/// The files that a copy of the scene at `target` needs beside it: those that `live` has read and that the
/// copy would not find, or, with `all`, each of them. Files in or below the folder of the scene keep their
/// relative places, and others go where the scene's names for them lead. The scene itself is not among them.
std::vector<CopiedFile> filesOfCopy(const render::LiveScene& live, const std::filesystem::path& target,
                                    bool all, const std::vector<std::filesystem::path>& libraryRoots);

/// Writes the text as the scene `target`, and copies the files. Folders are made. A file that exists with
/// the same content is kept; one with another content is an error (file-E10), and then nothing is written.
Diagnostics writeCopy(std::string_view text, const std::filesystem::path& target,
                      const std::vector<CopiedFile>& files);

}  // namespace glibra::view
