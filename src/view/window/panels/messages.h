#pragma once
// The list of messages about the scene.

#include <filesystem>

namespace glibra::view {

struct Ui;

/// The messages as a list; a click goes to the place. `file`: the shown one, whose name is left out.
void messageList(Ui& ui, const std::filesystem::path& file);

}  // namespace glibra::view
