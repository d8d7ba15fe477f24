#pragma once
// The chapters of the sources that examples are about, for the list of examples.

#include <span>
#include <string>
#include <vector>

#include "view/browse/example_scenes.h"

namespace glibra::view {

/// All chapters of the scenes, in their order.
std::vector<std::string> chaptersOf(std::span<const ExampleScene> scenes);

/// True if the scene is about that chapter; an empty one stands for all.
bool isOfChapter(const ExampleScene& scene, const std::string& chapter);

}  // namespace glibra::view
