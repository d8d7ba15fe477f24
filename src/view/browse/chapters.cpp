#include "view/browse/chapters.h"

#include <algorithm>

#include "source/scene_head.h"

namespace glibra::view {

std::vector<std::string> chaptersOf(std::span<const ExampleScene> scenes) {
    std::vector<std::string> chapters;
    for (const ExampleScene& scene : scenes)
        for (std::string& each : source::chaptersIn(scene.source)) chapters.push_back(std::move(each));
    std::sort(chapters.begin(), chapters.end(), source::isBefore);
    chapters.erase(std::unique(chapters.begin(), chapters.end()), chapters.end());
    return chapters;
}

bool isOfChapter(const ExampleScene& scene, const std::string& chapter) {
    if (chapter.empty()) return true;
    const std::vector<std::string> own = source::chaptersIn(scene.source);
    return std::find(own.begin(), own.end(), chapter) != own.end();
}

}  // namespace glibra::view
