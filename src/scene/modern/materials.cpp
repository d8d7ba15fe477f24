#include "scene/modern/materials.h"

#include <array>

#include "glib/text.h"

namespace glibra::scene {
namespace {

struct MaterialNumbers {
    std::string_view name;
    std::array<double, 4> ambient, diffuse, specular;
    double shininess;
};

/// Source: V. S. Gordon and J. Clevenger, Computer Graphics Programming in OpenGL, section 7.3, whose numbers
/// are those of the OpenGL teapots example.
constexpr MaterialNumbers kMaterials[] = {
    {"gold", {.2473, .1995, .0745, 1}, {.7516, .6065, .2265, 1}, {.6283, .5558, .3661, 1}, 51.2},
    {"silver", {.1923, .1923, .1923, 1}, {.5075, .5075, .5075, 1}, {.5083, .5083, .5083, 1}, 51.2},
    {"bronze", {.2125, .1275, .054, 1}, {.714, .4284, .1814, 1}, {.3935, .2719, .1667, 1}, 25.6},
    {"pewter", {.11, .06, .11, 1}, {.43, .47, .54, 1}, {.33, .33, .52, 1}, 9.85},
    {"jade", {.135, .2225, .1575, .95}, {.54, .89, .63, .95}, {.3162, .3162, .3162, .95}, 12.8},
    {"pearl", {.25, .2073, .2073, .922}, {1, .829, .829, .922}, {.2966, .2966, .2966, .922}, 11.264},
};

MaterialMember member(const char* name, std::span<const double> numbers) {
    MaterialMember made{name, {numbers.begin(), numbers.end()}, {}};
    made.tag.key = name;
    return made;
}

const std::vector<MaterialRow>& rows() {
    static const std::vector<MaterialRow> kRows = [] {
        std::vector<MaterialRow> made;
        for (const MaterialNumbers& each : kMaterials)
            made.push_back({each.name,
                            {member("ambient", each.ambient), member("diffuse", each.diffuse),
                             member("specular", each.specular), member("shininess", {&each.shininess, 1})}});
        return made;
    }();
    return kRows;
}

}  // namespace

const MaterialRow* findMaterial(std::string_view name) {
    for (const MaterialRow& each : rows())
        if (glib::sameWord(each.name, name)) return &each;
    return nullptr;
}

std::span<const std::string_view> materialNames() {
    static const auto kNames = [] {
        std::array<std::string_view, std::size(kMaterials)> names;
        for (std::size_t i = 0; i < names.size(); ++i) names[i] = kMaterials[i].name;
        return names;
    }();
    return kNames;
}

}  // namespace glibra::scene
