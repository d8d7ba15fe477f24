#pragma once
// Decides which parts of a Scene are made and drawn for one picture, how, and why the rest is skipped. There
// is no GL here: a plan is a function of values.

#include <utility>
#include <variant>

#include "plan/answers.h"
#include "plan/frame_plan.h"

namespace glibra::plan {

/// Plans a node list of the scene: `scene.frame`, or that of a Once or Step block. Scene and list must
/// outlive the plan. Questions that `answers` leave open are the result; with answers to them the caller asks
/// for the plan again, a few times in all. Errors are in the diagnostics. A plan with errors is good for a
/// window, which shows the rest, but not for a file: draws with an error are left out, while draws with an
/// unusable program stay in the plan.
std::variant<FramePlan, Questions> planFrame(const scene::Scene& scene, const scene::NodeList& nodes,
                                             const Answers& answers, const PlanOptions& options);

/// Plans with what `answer(questions, answers)` adds to the answers, until no question is open.
template <class Answer>
FramePlan planFrame(const scene::Scene& scene, const scene::NodeList& nodes, Answers answers,
                    const PlanOptions& options, Answer&& answer) {
    constexpr int kRounds = 4;  // passes that read each other in a long chain would need a round each
    for (int round = 0;; ++round) {
        std::variant<FramePlan, Questions> made = planFrame(scene, nodes, answers, options);
        if (auto* plan = std::get_if<FramePlan>(&made)) return std::move(*plan);
        answer(std::get<Questions>(made), answers);
        answers.asksAhead = round >= kRounds;
    }
}

}  // namespace glibra::plan
