#pragma once
// The state of the window that shows another scene beside the one of the tab: the solution of an exercise
// beside a student's own picture.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "gpu/object/texture.h"
#include "view/session/comparison.h"

namespace glibra::view {

struct Ui;

struct CompareWindow {
    bool isOpen = false;
    std::unique_ptr<Comparison> comparison;  ///< null: nothing was chosen yet
    std::string problem;                     ///< why the other scene cannot be read
    std::optional<gpu::Texture> own, other;  ///< of the last pictures
    std::filesystem::path exercise;          ///< the scene that `solution` was looked up for
    std::filesystem::path solution;          ///< of the tab's scene; empty: it is no exercise
};

/// Opens the window with that scene.
void compareWith(Ui& ui, const std::filesystem::path& scene);
/// The solution of the shown scene if an exercise begins with it; otherwise empty.
const std::filesystem::path& solutionOfShown(Ui& ui);
/// Asks for the scene to compare with.
void askCompareWith(Ui& ui);
void compareWindow(Ui& ui);

}  // namespace glibra::view
