#include "budget/choose_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "budget/error_models.h"
#include "glib/number.h"

namespace glibra::budget {
namespace {

/// Values depend on each other, as the offset of a shadow map does on its size: what is chosen for one may
/// allow less for another.
constexpr int kMostBoundRounds = 3;

class BoundSearch {
  public:
    explicit BoundSearch(const BoundRequest& request) : request_(request) {
        for (const BoundVariable& each : request.variables) {
            result_.values.push_back(each.current);
            steps_.push_back(each.isGiven ? std::vector{each.current} : boundSteps(each));
            why_.emplace_back(each.isGiven ? "stated by --set" : "");
        }
        finest();
    }

    ChosenBounds find() {
        while (isAnyFree()) {
            const std::optional<PictureChange> own = stepBack(everything());
            if (!own) {
                keepAll("a picture with the finest values cannot be drawn: " + failure_);
                break;
            }
            own_ = std::max(own->pixels, request_.resolution);
            if (own_ <= request_.maxError && own->colored <= kMostColored) {
                choose();
                break;
            }
            if (!keepRoughest()) break;
        }
        report();
        return std::move(result_);
    }

  private:
    using Places = std::vector<std::size_t>;  ///< indices into `steps_`

    [[nodiscard]] bool isFree(std::size_t variable) const { return why_[variable].empty(); }
    [[nodiscard]] bool isAnyFree() const {
        return std::ranges::any_of(why_, [](const std::string& each) { return each.empty(); });
    }
    [[nodiscard]] Places everything() const {
        Places all(steps_.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        return all;
    }
    [[nodiscard]] std::vector<double> valuesAt(const Places& places) const {
        std::vector<double> values;
        for (std::size_t i = 0; i < places.size(); ++i) values.push_back(steps_[i][places[i]]);
        return values;
    }
    /// Begins at the finest values.
    void finest() {
        chosen_.clear();
        for (const std::vector<double>& each : steps_) chosen_.push_back(each.size() - 1);
        finest_ = valuesAt(chosen_);
        known_.clear();
    }

    /// Nothing if the picture cannot be drawn; `failure_` says why.
    std::optional<PictureChange> measure(const Places& places) {
        if (const auto known = known_.find(places); known != known_.end()) return known->second;
        Result<PictureChange> change = request_.change(valuesAt(places), finest_);
        if (!change) {
            failure_ = change.diagnostics.empty() ? "the driver" : change.diagnostics.front().text;
            return std::nullopt;
        }
        known_.emplace(places, *change);
        return *change;
    }

    /// The change of the last step before the finest values of these variables, all together. For a method of
    /// first order that is the error of the finest values; for others it is more.
    std::optional<PictureChange> stepBack(const Places& variables) {
        Places before = chosen_;
        for (const std::size_t each : variables) before[each] -= before[each] > 0 ? 1 : 0;
        return measure(before);
    }

    void keep(std::size_t variable, std::string why) {
        why_[variable] = std::move(why);
        steps_[variable] = {request_.variables[variable].current};
    }
    void keepAll(const std::string& why) {
        for (std::size_t i = 0; i < steps_.size(); ++i)
            if (isFree(i)) keep(i, why);
        isMissed_ = true;
    }

    /// Keeps the variable whose last step changes the picture most. False if the pictures cannot be drawn.
    bool keepRoughest() {
        std::size_t roughest = 0;
        PictureChange most{-1, -1};
        for (const std::size_t i : everything()) {
            if (!isFree(i)) continue;
            const std::optional<PictureChange> step = stepBack({i});
            if (!step) {
                keepAll("a picture cannot be drawn: " + failure_);
                return false;
            }
            if (std::tie(step->pixels, step->colored) > std::tie(most.pixels, most.colored)) {
                roughest = i;
                most = *step;
            }
        }
        most.pixels = std::max(most.pixels, request_.resolution);
        keep(roughest,
             fmt::format("its error is not known, because the step from {} to {} still leaves the "
                         "picture {}",
                         glib::numberText(*(steps_[roughest].end() - 2)),
                         glib::numberText(steps_[roughest].back()), changeText(most.pixels, most.colored)));
        isMissed_ = true;
        finest();
        return true;
    }

    bool isWithin(const Places& places) {
        const std::optional<PictureChange> found = measure(places);
        return found && found->pixels + own_ <= request_.maxError && found->colored <= kMostColored;
    }

    /// Finds the coarsest value of a variable that keeps the bound with the present ones of the others.
    bool coarsen(std::size_t variable) {
        const std::size_t before = chosen_[variable];
        std::size_t least = 0, kept = before;
        while (least < kept) {
            Places tried = chosen_;
            tried[variable] = (least + kept) / 2;
            if (isWithin(tried))
                kept = tried[variable];
            else
                least = tried[variable] + 1;
        }
        chosen_[variable] = kept;
        return kept != before;
    }

    void choose() {
        bool isChanged = true;
        for (int round = 0; isChanged && round < kMostBoundRounds; ++round) {
            isChanged = false;
            for (std::size_t i = 0; i < steps_.size(); ++i) isChanged |= coarsen(i);
        }
        result_.values = valuesAt(chosen_);
        change_ = measure(chosen_);
    }

    void report() {
        for (std::size_t i = 0; i < request_.variables.size(); ++i) {
            const BoundVariable& each = request_.variables[i];
            const std::string number = glib::numberText(result_.values[i]);
            std::string why = fmt::format("{} kept: {}", number, why_[i]);
            if (isFree(i) && change_)
                why = fmt::format("{}: {} (\u00b1 {}) against the finest, {}; {}",
                                  result_.values[i] == each.current
                                      ? number
                                      : number + " in place of " + glib::numberText(each.current),
                                  changeText(change_->pixels, change_->colored), pixelText(own_),
                                  glib::numberText(each.finest), request_.how);
            result_.decisions.push_back({each.name, std::move(why), each.place});
        }
        if (!isMissed_) return;
        for (std::size_t i = 0; i < request_.variables.size(); ++i) {
            const BoundVariable& each = request_.variables[i];
            if (isFree(i) || each.isGiven) continue;
            result_.diagnostics.push_back(about(
                diagnose("draw-W07",
                         fmt::format("'{}' is kept at {}, which may break the bound of {}: {}", each.name,
                                     glib::numberText(each.current), pixelText(request_.maxError), why_[i]),
                         each.place),
                each.name));
        }
    }

    const BoundRequest& request_;
    std::vector<std::vector<double>> steps_;  ///< by variable; one value for those that are kept
    std::vector<std::string> why_;            ///< by variable: why it is kept, or an empty text
    Places chosen_;
    std::vector<double> finest_;
    std::map<Places, PictureChange> known_;
    double own_ = 0;                       ///< pixels: the error of the finest values
    std::optional<PictureChange> change_;  ///< of the chosen values
    bool isMissed_ = false;
    std::string failure_;
    ChosenBounds result_;
};

}  // namespace

std::vector<double> boundSteps(const BoundVariable& variable) {
    const double logRatio = std::log2(variable.finest / variable.coarsest);
    const int doublings = std::max(1, static_cast<int>(std::lround(std::abs(logRatio))));
    std::vector<double> steps;
    for (int i = 0; i <= doublings; ++i) {
        double value = variable.coarsest * std::exp2(logRatio * i / doublings);
        if (variable.isWhole) value = std::round(value);
        if (i == doublings) value = variable.finest;
        if (steps.empty() || steps.back() != value) steps.push_back(value);
    }
    return steps;
}

ChosenBounds chooseBounds(const BoundRequest& request) {
    return BoundSearch(request).find();
}

}  // namespace glibra::budget
