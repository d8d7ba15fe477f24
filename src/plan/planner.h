#pragma once
// Decides which parts of a Scene are made and drawn for one picture, how, and why the rest is skipped. There
// is no GL here: what the plan must know of the driver and of compiled programs it asks by PlanQuestions.

#include "plan/frame_plan.h"
#include "plan/plan_questions.h"

namespace glibra::plan {

/// Plans a node list of the scene: `scene.frame`, or that of a Once or Step block. Scene and list must
/// outlive the plan. Errors are in the diagnostics. A plan with errors is good for a window, which shows the
/// rest, but not for a file: draws with an error are left out, while draws with an unusable program stay in
/// the plan.
FramePlan planFrame(const scene::Scene& scene, const scene::NodeList& nodes, const PlanQuestions& questions,
                    const PlanOptions& options);

}  // namespace glibra::plan
