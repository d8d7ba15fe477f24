#include "view/scene/shared_knobs.h"

#include <algorithm>

namespace glibra::view {
namespace {

bool isSameValue(const Knob& a, const Knob& b) {
    return a.tag == b.tag && a.type.word == b.type.word && a.widget == b.widget && a.form == b.form &&
           a.minimum == b.minimum && a.maximum == b.maximum && a.initial == b.initial;
}

}  // namespace

std::vector<std::vector<std::size_t>> sharedKnobs(std::span<const Knob> knobs) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        if (!knobs[i].program) continue;
        const auto known = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
            return isSameValue(knobs[group.front()], knobs[i]);
        });
        if (known == groups.end())
            groups.push_back({i});
        else if (knobs[known->back()].program != knobs[i].program)
            known->push_back(i);
    }
    std::erase_if(groups, [](const auto& group) { return group.size() < 2; });
    return groups;
}

}  // namespace glibra::view
