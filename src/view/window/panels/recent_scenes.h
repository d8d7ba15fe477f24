#pragma once
// The list of recent scenes, as the welcome and the dialog that opens a scene have it.

#include <cstddef>
#include <filesystem>
#include <string>

namespace glibra::view {

struct Ui;

/// A row for each of the first `most` recent scenes: its name and its folder, which stands beside the name
/// or, with `isNarrow`, below it. A scene whose file is gone cannot be chosen; its row says so and has a
/// button that removes it. `name` is that of the list, for mark(). Returns the chosen scene; empty: none.
std::filesystem::path recentScenes(Ui& ui, std::size_t most, const std::string& name, bool isNarrow);

}  // namespace glibra::view
