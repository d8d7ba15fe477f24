#include "render/check/open_checks.h"

#include <algorithm>
#include <iterator>

namespace glibra::render {

using scene::Check;

OpenChecks::OpenChecks(const scene::Scene& scene, double time)
    : time_(time), all_(scene.checks), idle_(scene.idleChecks) {
    for (const Check& each : all_)
        if (each.kind != Check::Kind::error) open_.push_back(each);
    for (const Check& each : open_) times_.insert(timeOf(each));
    for (const scene::IdleCheck& each : idle_)
        if (each.seconds) times_.insert(*each.seconds);
    if (times_.empty()) times_.insert(time);
}

std::vector<Check> OpenChecks::take(double moment, const std::vector<Check>& there) {
    std::vector<Check> taken;
    const auto laterOf = [&](const Check& check) {
        const auto found = std::ranges::find_if(there, [&](const Check& each) { return each.isSame(check); });
        return found != there.end() && found->kind == check.kind ? *found : check;
    };
    for (const Check& each : open_)
        if (timeOf(each) == moment) taken.push_back(laterOf(each));
    std::erase_if(open_, [&](const Check& each) { return timeOf(each) == moment; });
    for (const Check& each : there) {
        const auto isSame = [&](const Check& other) { return other.isSame(each); };
        if (each.kind == Check::Kind::error || !each.seconds || *each.seconds != moment ||
            std::ranges::any_of(all_, isSame))
            continue;
        taken.push_back(each);
        all_.push_back(each);
        std::erase_if(idle_, [&](const scene::IdleCheck& other) { return other.place == each.place; });
    }
    return taken;
}

std::vector<Check> OpenChecks::unanswered() const {
    std::vector<Check> checks = open_;
    std::copy_if(all_.begin(), all_.end(), std::back_inserter(checks),
                 [](const Check& each) { return each.kind == Check::Kind::error; });
    return checks;
}

}  // namespace glibra::render
