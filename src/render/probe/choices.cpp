// What a bound in pixels chooses for a scene, measured on small pictures of it.

#include "render/probe/choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "budget/budget.h"
#include "budget/choose_bounds.h"
#include "budget/contour_shift.h"
#include "glib/number.h"
#include "render/probe/patch_probe.h"

namespace glibra::render {
namespace {

// The values of Bound variables.

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

/// Chooses the values for options.maxError, at options.time and up to options.lastTime, and runs the scene
/// with them: `interpreted` then holds that scene, and `options` states the values by `set`. The picture has
/// `width` x `height` pixels; the longer side of the small ones has at most 800. Nothing changes if nothing
/// can be chosen.
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

// Counts of shapes, samples, sizes of noise and tessellation levels.

constexpr int kNoiseSide = 200, kLeastSide = 320, kMostSide = 800;

/// For meshes, shifts of a tenth of a pixel can be measured, so a picture in which the bound is that much is
/// large enough.
int largestSide(const budget::Choice& choice, const RenderOptions& options, int side) {
    if (!choice.noise.empty()) return kNoiseSide;
    return static_cast<int>(std::clamp(.1 * side / options.maxError, double{kLeastSide}, double{kMostSide}));
}

/// How far contours move, in pixels of the whole picture, between the picture of a state with the shapes,
/// noise and samples of `from` and that with those of `to`, at the moment that shows most. The view is fixed:
/// it does not depend on the meshes. The longer side of the small pictures has at most 200 pixels for noise;
/// for meshes 320, or up to 800 if the bound is less than a tenth of a pixel. Nothing if they cannot be
/// drawn; drawing the scene itself then reports why.
std::optional<budget::ContourShifts> shift(const SceneState& state, const std::vector<double>& moments,
                                           const budget::Choice& from, const budget::Choice& to) {
    const Conductor& conductor = state.conductor;
    const int side = largestSide(from, conductor.options, std::max(state.width, state.height));
    ProbeOptions probe = probeOptions(conductor.options, state.width, state.height, side);
    // Noise changes values by less than a byte can show. Meshes use bytes, so that the driver runs the same
    // code as for the picture.
    probe.options.floatPixels = !from.noise.empty();
    probe.options.alpha = false;
    Stats stats;
    const auto picturesOf = [&](const budget::Choice& choice) -> std::optional<std::vector<image::Image>> {
        scene::Scene chosen = conductor.scene;
        budget::apply(choice, chosen);
        probe.options.samples = choice.samples;
        auto loaded =
            SceneState::load(conductor.context, {std::move(chosen), conductor.source, conductor.inputs},
                             probe.options, stats, conductor.parts);
        if (!loaded) return std::nullopt;
        (*loaded)->conductor.view = conductor.view;
        std::vector<image::Image> pictures;
        for (const double each : moments) {
            Result<image::Image> picture = (*loaded)->draw(each, stats);
            if (!picture) return std::nullopt;
            pictures.push_back(std::move(*picture));
        }
        return pictures;
    };
    const auto before = picturesOf(from), after = picturesOf(to);
    if (!before || !after) return std::nullopt;
    budget::ContourShifts shifts(before->front(), after->front(), probe.shrink);
    for (std::size_t i = 1; i < moments.size(); ++i) shifts.add((*before)[i], (*after)[i]);
    return shifts;
}

}  // namespace

bool hasBounds(const scene::Scene& scene) {
    return std::ranges::any_of(scene.variables,
                               [](const scene::Variable& each) { return each.bound.has_value(); });
}

Result<std::unique_ptr<SceneState>> chooseValues(const SceneState& state, Stats& stats) {
    const StageTimer timer(stats, "budget");
    const Conductor& first = state.conductor;
    InterpretedScene interpreted{first.scene, first.source, first.inputs};
    RenderOptions options = first.options;
    budget::ChosenBounds chosen =
        chooseBounds(first.context, interpreted, options, state.width, state.height);
    stats.decisions.insert(stats.decisions.end(), chosen.decisions.begin(), chosen.decisions.end());
    Result<std::unique_ptr<SceneState>> made = SceneState::of(first.context, std::move(interpreted), options,
                                                              stats, first.ownParts ? nullptr : first.parts);
    if (made) (*made)->conductor.condition = first.condition;
    made.diagnostics.insert(made.diagnostics.begin(), chosen.diagnostics.begin(), chosen.diagnostics.end());
    return made;
}

Diagnostics chooseCounts(SceneState& state, plan::PlanOptions& planOptions) {
    Conductor& conductor = state.conductor;
    scene::Scene& scene = conductor.scene;
    RenderOptions& options = conductor.options;
    Stats& stats = conductor.loadStats;
    const plan::FramePlan first = conductor.planList(scene.frame, planOptions);
    if (hasError(first.diagnostics)) return {};
    const StageTimer timer(stats, "budget");
    const gpu::Capabilities& driver = conductor.context.capabilities();
    const std::vector<double> moments =
        conductor.changesWithTime ? std::vector{conductor.inputs.time} : momentsOf(options);
    PatchProbe probe(state, moments);
    budget::Choice choice = budget::choose(
        scene, first,
        {.maxError = options.maxError,
         .overrideCounts = options.overrideCounts,
         .width = state.width,
         .height = state.height,
         .areSamplesFree = state.areSamplesChosen,
         .mostSamples = driver.maxSamples,
         .clipFromModel =
             [&](const scene::Draw& draw, double aspect) {
                 return conductor.view.projection(*draw.projection, aspect) * conductor.view.modelView(draw);
             },
         .contourShift = [&](const budget::Choice& from,
                             const budget::Choice& to) { return shift(state, moments, from, to); },
         .mostLevel = driver.maxTessellationLevel,
         .overrides = planOptions.overrides,
         .patches = [&](std::size_t pass, std::size_t step,
                        const budget::Levels& levels) { return probe.patches(pass, step, levels); }});
    if (state.areSamplesChosen) options.samples = choice.samples;
    for (const scene::ShapeIndex shape : budget::apply(choice, scene))
        conductor.device.meshes().forget(shape);
    planOptions.overrides.insert(planOptions.overrides.end(), choice.levels.begin(), choice.levels.end());
    if (conductor.hasPlan())
        return std::move(choice.diagnostics);  // decisions are those of the first picture
    stats.decisions.insert(stats.decisions.end(), choice.decisions.begin(), choice.decisions.end());
    if (conductor.changesWithTime && options.lastTime > options.time)
        stats.decisions.push_back(
            {"scene",
             "it changes with time: each picture has its own choice; that of the first:",
             {scene.path, 1, 1}});
    std::ranges::stable_sort(stats.decisions, {}, [](const budget::Decision& each) {
        return std::pair(each.place.line, each.what != "scene");
    });
    return std::move(choice.diagnostics);
}

}  // namespace glibra::render
