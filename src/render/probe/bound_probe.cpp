#include "render/probe/bound_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "budget/contour_shift.h"
#include "glib/number.h"
#include "render/probe/probe_options.h"
#include "render/scene_state.h"

namespace glibra::render {
namespace {

/// Smaller pictures do not resolve thin shadows and far objects: of 320 pixels they showed a quarter of some
/// shifts.
constexpr int kMostBoundSide = 800;
constexpr double kVisibleChange = 8. / 255;
/// A contour between black and white that moves by this much of a pixel changes values by kVisibleChange.
constexpr double kSeenShift = kVisibleChange;

/// Draws a scene with several values of its variables.
class BoundPictures {
  public:
    BoundPictures(gpu::Context& context, const InterpretedScene& interpreted, ProbeOptions probe,
                  const std::vector<budget::BoundVariable>& variables)
        : context_(context),
          source_(interpreted.source),
          inputs_(interpreted.inputs),
          probe_(std::move(probe)) {
        inputs_.width = probe_.options.width;
        inputs_.height = probe_.options.height;
        moments_ = momentsOf(probe_.options);
        for (const budget::BoundVariable& each : variables) names_.push_back(each.name);
    }

    /// The largest change of all moments.
    [[nodiscard]] Result<budget::PictureChange> change(std::span<const double> values,
                                                       std::span<const double> finest) {
        if (reference_.empty() || !std::equal(finest.begin(), finest.end(), finest_.begin(), finest_.end())) {
            Result<std::vector<image::Image>> drawn = pictures(finest);
            if (!drawn) return std::move(drawn.diagnostics);
            reference_ = std::move(*drawn);
            finest_.assign(finest.begin(), finest.end());
        }
        const Result<std::vector<image::Image>> drawn = pictures(values);
        if (!drawn) return drawn.diagnostics;
        budget::PictureChange change;
        for (std::size_t i = 0; i < drawn->size(); ++i) {
            const budget::ContourShifts shifts((*drawn)[i], reference_[i], probe_.shrink);
            const double pixels = shifts.ofChangesAbove(kVisibleChange);
            change.pixels = std::max(change.pixels, pixels);
            change.colored =
                std::max(change.colored, shifts.shareOfSmoothChangesAbove(kVisibleChange, pixels));
        }
        return change;
    }

    /// "at 0 s", "at 0, 1 and 2 s"
    [[nodiscard]] std::string when() const {
        std::vector<std::string> texts;
        for (const double each : moments_) texts.push_back(glib::numberText(each));
        return texts.size() == 1 ? fmt::format("at {} s", texts[0])
                                 : fmt::format("at {}, {} and {} s", texts[0], texts[1], texts[2]);
    }

  private:
    [[nodiscard]] Result<std::vector<image::Image>> pictures(std::span<const double> values) {
        RenderOptions options = probe_.options;
        for (std::size_t i = 0; i < values.size(); ++i) {
            inputs_.variables[names_[i]] = {values[i]};
            options.set.push_back(names_[i] + "=" + glib::numberText(values[i]));
        }
        InterpretedScene scene{source_->at(inputs_), source_, inputs_};
        if (hasError(scene.scene.diagnostics)) return std::move(scene.scene.diagnostics);
        scene.scene.diagnostics.clear();
        Stats stats;
        auto loaded = SceneState::load(context_, std::move(scene), options, stats, nullptr);
        if (!loaded) return std::move(loaded.diagnostics);
        std::vector<image::Image> drawn;
        for (const double each : moments_) {
            Result<image::Image> picture = (*loaded)->draw(each, stats);
            if (!picture) return std::move(picture.diagnostics);
            drawn.push_back(std::move(*picture));
        }
        return drawn;
    }

    gpu::Context& context_;
    std::shared_ptr<scene::Interpretation> source_;
    scene::FrameInputs inputs_;
    ProbeOptions probe_;
    std::vector<double> moments_;  ///< seconds
    std::vector<std::string> names_;
    std::vector<double> finest_;           ///< the values of `reference_`
    std::vector<image::Image> reference_;  ///< by moment
};

/// True if options.set states the variable.
bool isStated(const RenderOptions& options, const std::string& name) {
    return std::ranges::any_of(options.set,
                               [&](const std::string& each) { return each.starts_with(name + "="); });
}

}  // namespace

bool hasBounds(const scene::Scene& scene) {
    return std::ranges::any_of(scene.variables,
                               [](const scene::Variable& each) { return each.bound.has_value(); });
}

budget::ChosenBounds chooseBounds(gpu::Context& context, InterpretedScene& interpreted,
                                  RenderOptions& options, int width, int height) {
    budget::BoundRequest request;
    for (const scene::Variable& each : interpreted.scene.variables)
        if (each.bound)
            request.variables.push_back({each.name, each.bound->coarsest, each.current.front(),
                                         each.bound->finest, each.bound->isWhole,
                                         isStated(options, each.name), each.place});
    ProbeOptions probe = probeOptions(options, width, height, kMostBoundSide);
    probe.options.alpha = false;
    request.maxError = options.maxError;
    request.resolution = kSeenShift * probe.shrink;
    const std::string size = fmt::format("{} x {}", probe.options.width, probe.options.height);
    BoundPictures pictures(context, interpreted, std::move(probe), request.variables);
    request.how = fmt::format("measured {}, in pictures of {}", pictures.when(), size);
    request.change = [&](std::span<const double> values, std::span<const double> finest) {
        return pictures.change(values, finest);
    };
    budget::ChosenBounds chosen = budget::chooseBounds(request);
    for (std::size_t i = 0; i < request.variables.size(); ++i) {
        const budget::BoundVariable& each = request.variables[i];
        if (each.isGiven || chosen.values[i] == each.current) continue;
        interpreted.inputs.variables[each.name] = {chosen.values[i]};
        options.set.push_back(each.name + "=" + glib::numberText(chosen.values[i]));
    }
    interpreted.scene = interpreted.source->at(interpreted.inputs);
    interpreted.scene.diagnostics.clear();  // they are those of the scene before
    return chosen;
}

}  // namespace glibra::render
