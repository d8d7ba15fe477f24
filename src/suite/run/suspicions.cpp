#include "suite/run/suspicions.h"

#include <algorithm>
#include <utility>

namespace glibra::suite {

void Suspicions::add(const ShotReference& drawn, std::vector<ShotReference> prepared, ShotResult ended,
                     bool isForgiven) {
    suspicions_.push_back({drawn, std::move(prepared), std::move(ended), std::nullopt, false, isForgiven});
}

bool Suspicions::concerns(const Suspicion& suspicion, const ShotReference& shot) {
    return suspicion.drawn == shot || std::ranges::find(suspicion.open, shot) != suspicion.open.end();
}

bool Suspicions::isUnder(const ShotReference& shot) const {
    return std::ranges::any_of(suspicions_, [&](const Suspicion& each) { return concerns(each, shot); });
}

std::vector<ShotResult> Suspicions::settle(const ShotReference& shot, const ShotResult& result) {
    const auto found =
        std::ranges::find_if(suspicions_, [&](const Suspicion& each) { return concerns(each, shot); });
    if (found == suspicions_.end()) return {result};
    const bool isGuilty = result.verdict == Verdict::crashed || result.verdict == Verdict::timedOut;
    std::vector<ShotResult> told;
    if (found->drawn == shot && !isGuilty) {
        found->result = result;
    } else {
        told.push_back(result);
        if (std::erase(found->open, shot) > 0 && isGuilty) found->isOtherGuilty = true;
    }
    if (found->result && found->open.empty()) {
        if (found->isForgiven && !found->isOtherGuilty && found->result->verdict == Verdict::passed)
            makeFlaky(*found->result, 2, found->ended);
        told.push_back(found->isOtherGuilty || found->isForgiven ? *found->result : found->ended);
    }
    return told;
}

}  // namespace glibra::suite
