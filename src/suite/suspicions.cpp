#include "suite/suspicions.h"

#include <algorithm>
#include <utility>

namespace glibra::suite {

void Suspicions::add(const ShotReference& drawn, const ShotReference& prepared, ShotResult ended) {
    suspicions_.push_back({drawn, prepared, std::move(ended), std::nullopt, std::nullopt});
}

bool Suspicions::isUnder(const ShotReference& shot) const {
    return std::any_of(suspicions_.begin(), suspicions_.end(),
                       [&](const Suspicion& each) { return each.drawn == shot || each.prepared == shot; });
}

std::vector<ShotResult> Suspicions::settle(const ShotReference& shot, const ShotResult& result) {
    const auto found = std::find_if(suspicions_.begin(), suspicions_.end(), [&](const Suspicion& each) {
        return each.drawn == shot || each.prepared == shot;
    });
    if (found == suspicions_.end()) return {result};
    const bool isGuilty = result.verdict == Verdict::crashed || result.verdict == Verdict::timedOut;
    std::vector<ShotResult> told;
    if (found->drawn == shot && !isGuilty) {
        found->result = result;
    } else {
        told.push_back(result);
        if (found->prepared == shot) found->isPreparedGuilty = isGuilty;
    }
    if (found->result && found->isPreparedGuilty)
        told.push_back(*found->isPreparedGuilty ? *found->result : found->ended);
    return told;
}

}  // namespace glibra::suite
