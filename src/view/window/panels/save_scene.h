#pragma once
// Saves the shown scene: its values, or a copy with the files that it reads.

#include <filesystem>

namespace glibra::view {

struct Ui;

/// Writes the values and the chosen files into the scene, or asks where to save a copy of an example.
void saveScene(Ui& ui);
/// Asks where to save the scene with its values, and opens the result in a tab.
void saveSceneAs(Ui& ui);
/// Where users keep their own scenes: beside this one, unless it is an example; else beside a recent one
/// whose folder is there.
std::filesystem::path ownFolder(const Ui& ui);

}  // namespace glibra::view
