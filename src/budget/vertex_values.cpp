#include "budget/vertex_values.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "budget/least_counts.h"
#include "budget/pixel_scale.h"
#include "scene/primitives.h"

namespace glibra::budget {
namespace {

constexpr double kFiner = 1.5, kShareOfStep = 1 - 1 / (kFiner * kFiner);
constexpr double kVisible = 8. / 255;
constexpr int kMostRounds = 5;

using Numbers = std::vector<double>;

Numbers more(const VertexDraw& draw, const Numbers& numbers, double factor, bool onlyFree) {
    Numbers raised = numbers;
    for (std::size_t i = 0; i < draw.model->countsUsed; ++i)
        if (double& number = raised[draw.model->counts[i].index]; !onlyFree || draw.isFree[i])
            number = std::ceil(number * factor);
    return raised;
}

bool isSmallEnough(const VertexDraw& draw, const Numbers& numbers) {
    const auto counts = scene::countsOf({draw.model->command, numbers, {}, nullptr});
    return counts && counts->vertices <= kMostBudgetVertices;
}

class Refinement {
  public:
    explicit Refinement(const VertexRequest& request) : request_(request), draws_(request.draws) {
        for (const VertexDraw& each : draws_) {
            values_.numbers.push_back(each.numbers);
            programs_.insert(each.program);
        }
    }

    std::optional<VertexValues> find() {
        // In most scenes all programs keep the bound, and two pictures show that for all of them.
        const std::optional<VertexError> all = measure(programs_, 1);
        if (!all) return std::nullopt;
        for (const plan::PlannedProgramIndex program : programs_) {
            std::optional<VertexError> error = all;
            if (!all->isKept && programs_.size() > 1) error = measure({program}, 1);
            if (!error) return std::nullopt;
            values_.programs.push_back({program, error->isKept ? *error : refine(program, *error)});
        }
        return std::move(values_);
    }

  private:
    /// Measures the error when the draws of these programs have their free counts times `factor`.
    [[nodiscard]] std::optional<VertexError> measure(const std::set<plan::PlannedProgramIndex>& programs,
                                                     double factor) const {
        std::vector<ShapeChoice> from, to;
        double shapes = 0;
        for (std::size_t i = 0; i < draws_.size(); ++i) {
            const VertexDraw& draw = draws_[i];
            Numbers coarse = values_.numbers[i];
            Numbers fine = coarse;
            if (programs.contains(draw.program)) {
                coarse = more(draw, draw.numbers, factor, true);
                fine = more(draw, coarse, kFiner, false);
                for (const CountArgument& each : draw.model->usedCounts())
                    if (each.smooth == kAsGiven)
                        fine[each.index] = std::max(fine[each.index], draw.before[each.index]);
                if (!isSmallEnough(draw, fine)) return std::nullopt;
                shapes = std::max(shapes, draw.scale * draw.model->deviation(coarse, draw.fidelity));
            }
            from.push_back({draw.pass, draw.step, std::move(coarse)});
            to.push_back({draw.pass, draw.step, std::move(fine)});
        }
        const std::optional<ContourShifts> step = request_.shift(from, to);
        if (!step) return std::nullopt;
        constexpr double kSeen = kVisible * kShareOfStep;
        VertexError error{std::max(0., step->ofChangesAbove(kSeen) / kShareOfStep - shapes),
                          step->shareOfSmoothChangesAbove(kSeen, kShareOfStep * shapes)};
        error.isKept =
            error.pixels <= std::max(request_.maxError, .1 * step->pixel()) && error.colored <= kMostColored;
        return error;
    }

    /// The counts along straight lines of a program's draws are at least those of the scene. True if any was
    /// less.
    bool keepStraight(plan::PlannedProgramIndex program) {
        bool isRaised = false;
        for (VertexDraw& draw : draws_)
            if (draw.program == program)
                for (const CountArgument& each : draw.model->usedCounts())
                    if (each.smooth == kAsGiven && draw.numbers[each.index] < draw.before[each.index]) {
                        draw.numbers[each.index] = draw.before[each.index];
                        isRaised = true;
                    }
        return isRaised;
    }

    VertexError refine(plan::PlannedProgramIndex program, const VertexError& first) {
        double factor = 1;
        VertexError error = first;
        if (keepStraight(program)) error = measure({program}, 1).value_or(first);
        const bool isFree = std::ranges::any_of(draws_, [&](const VertexDraw& each) {
            return each.program == program && (each.isFree[0] || each.isFree[1]);
        });
        for (int round = 0; isFree && !error.isKept && round < kMostRounds; ++round) {
            const double growth = std::clamp(1.1 * std::sqrt(error.pixels / request_.maxError), 1.5, 3.);
            const std::optional<VertexError> found = measure({program}, factor * growth);
            constexpr double kHelps = .8;
            if (!found || (!found->isKept && found->pixels > kHelps * error.pixels &&
                           found->colored > kHelps * error.colored))
                break;
            factor *= growth;
            error = *found;
        }
        for (std::size_t i = 0; i < draws_.size(); ++i)
            if (const VertexDraw& draw = draws_[i]; draw.program == program)
                values_.numbers[i] = more(draw, draw.numbers, factor, true);
        return error;
    }

    const VertexRequest& request_;
    std::vector<VertexDraw> draws_;
    std::set<plan::PlannedProgramIndex> programs_;
    VertexValues values_;
};

}  // namespace

std::optional<VertexValues> vertexValues(const VertexRequest& request) {
    return Refinement(request).find();
}

}  // namespace glibra::budget
