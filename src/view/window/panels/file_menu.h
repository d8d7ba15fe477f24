#pragma once
// The menu "File": new scenes from templates, opening, saving, copies of examples, hardcopies.

#include <filesystem>
#include <optional>
#include <vector>

#include "view/browse/example_scenes.h"

namespace glibra::view {

struct Ui;

struct FileMenu {
    std::optional<std::vector<ExampleScene>> templates;  ///< of the menu "New", listed when it is first open
    std::filesystem::path exercise;                      ///< the scene that `solution` was looked up for
    std::filesystem::path solution;                      ///< of the tab's scene; empty: it is no exercise
    bool opens = false;                                  ///< the menu is to open, with the keyboard in it
};

/// Asks where a new scene is to be written, and makes it.
void askEmptyScene(Ui& ui);
/// The button "File" and its menu.
void fileMenu(Ui& ui, FileMenu& menu);
/// Shows the solution of the exercise beside the picture; says so if the scene is no exercise.
void compareWithSolution(Ui& ui);
/// Asks for a scene to show beside the picture.
void askCompareWith(Ui& ui);

}  // namespace glibra::view
