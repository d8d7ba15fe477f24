#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "budget/budget.h"
#include "budget/least_counts.h"
#include "budget/program_facts.h"
#include "budget/sampling_model.h"
#include "glib/command_table.h"
#include "scene/primitives.h"
#include "scene/view.h"

namespace glibra::budget {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

/// "0.249 px", with as many digits as tell it from the bound.
std::string pixelText(double pixels) {
    return fmt::format("{:.3g} px", pixels);
}

std::string_view countName(const SurfaceModel& model, const CountArgument& count) {
    if (count.byDefault > 0) {
        if (model.command == glib::CommandId::teapot) return "cells a side";
        return model.command == glib::CommandId::soccerball ? "cuts" : "sides";
    }
    for (const glib::CommandRow& row : glib::commandTable())
        if (row.id == model.command) return row.arguments[count.index].name;
    return {};
}

/// "44 slices, 22 stacks"
std::string countsText(const SurfaceModel& model, const std::vector<double>& numbers) {
    std::string text;
    for (const CountArgument& each : model.usedCounts())
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", numbers[each.index], countName(model, each));
    return text;
}

/// One draw whose counts may be chosen, and how fine its mesh has to be.
struct Need {
    std::size_t pass = 0, step = 0;
    const scene::Draw* draw = nullptr;
    double scale = 0;    ///< pixels a model unit
    double allowed = 0;  ///< deviation in model units
    bool isMoved = false;
};

/// What draws must have in common to share a mesh.
using MeshKey = std::tuple<int, std::array<bool, 2>, std::array<int, 2>, Fidelity>;

class Chooser {
  public:
    Chooser(const scene::Scene& scene, const plan::FramePlan& plan, const Request& request)
        : scene_(scene), plan_(plan), request_(request) {}

    Choice choose() {
        for (const plan::PlannedPass& pass : plan_.passes) lookAt(pass);
        for (auto& [key, needs] : needs_) chooseCounts(key, needs);
        chooseNoise();
        chooseSamples();
        report();
        std::stable_sort(choice_.decisions.begin(), choice_.decisions.end(),
                         [](const Decision& a, const Decision& b) { return a.place.line < b.place.line; });
        return std::move(choice_);
    }

  private:
    /// The draw that is furthest from keeping the bound, and how many others do not.
    struct Worst {
        double pixels = 0;
        const scene::Draw* draw = nullptr;
        std::string counts;
        int others = -1;
        void add(double error, const scene::Draw& at, std::string with) {
            ++others;
            if (error <= pixels) return;
            pixels = error;
            draw = &at;
            counts = std::move(with);
        }
    };

    void decide(const scene::Draw& draw, std::string why) {
        choice_.decisions.push_back({draw.word, std::move(why), draw.place});
    }

    void lookAt(const plan::PlannedPass& planned) {
        const scene::Pass& pass = *planned.pass;
        const auto index = static_cast<std::size_t>(planned.pass - scene_.passes.data());
        const double windowAspect = static_cast<double>(request_.width) / request_.height;
        const double aspect = scene::aspectOf(scene_, pass, windowAspect);
        glm::dvec2 size(request_.width, request_.height);
        if (!pass.targets.empty())
            if (const auto* target = std::get_if<scene::EmptySource>(
                    &scene_.textures[static_cast<std::size_t>(pass.targets.front())].source))
                size = {target->width, target->height};
        std::map<const scene::Draw*, std::size_t> steps;
        for (std::size_t i = 0; i < pass.steps.size(); ++i)
            if (const auto* draw = std::get_if<scene::Draw>(&pass.steps[i])) steps[draw] = i;
        for (const auto& each : planned.steps)
            if (const auto* draw = std::get_if<plan::PlannedDraw>(&each))
                lookAt(*draw, {index, steps.at(draw->draw), draw->draw}, aspect, size);
    }

    void lookAt(const plan::PlannedDraw& planned, Need need, double aspect, const glm::dvec2& size) {
        const scene::Draw& draw = *planned.draw;
        const scene::Shape& shape = scene_.shapes[static_cast<std::size_t>(draw.shape)];
        const plan::ProgramInterface& program =
            *plan_.programs[static_cast<std::size_t>(planned.program)].interface;
        const SurfaceModel* model = shape.list ? nullptr : surfaceModel(shape.command);
        const glm::dmat4 matrix = request_.clipFromModel(draw, aspect);
        const auto scaleOf = [&](const Bounds& bounds) {
            return pixelsPerUnit(matrix, bounds, size.x, size.y);
        };
        const std::vector<double> numbers = model != nullptr ? model->complete(shape) : std::vector<double>();
        const std::optional<double> scale =
            model != nullptr ? scaleOf(model->bounds(numbers)) : std::optional<double>();
        noteNoise(planned, scale, size.y);
        if (model == nullptr || scene::drawsNothing(shape)) return;

        const ProgramFacts facts = programFacts(program);
        if (draw.flatColors || facts.showsPrimitives)
            return decide(draw, "kept: its program shows the single triangles");
        if (facts.worksOnPrimitives)
            return decide(draw, "kept: its tessellation or geometry stage works on the single triangles");
        if (!scale) return decide(draw, "kept: reaches behind the eye, so no bound is known");

        need.scale = *scale;
        need.allowed = *scale > 0 ? request_.maxError / *scale : kAny;
        need.isMoved = !facts.placesByMatrix;
        const Fidelity fidelity = facts.readsTexCoord ? Fidelity::pattern : Fidelity::shape;
        std::array<bool, 2> isFree{};
        std::array<int, 2> least{};
        for (std::size_t i = 0; i < model->countsUsed; ++i) {
            const CountArgument& count = model->counts[i];
            const int asGiven = static_cast<int>(numbers[count.index]);
            isFree[i] = request_.overrideCounts || count.byDefault > 0 || count.index >= draw.givenNumbers;
            least[i] = facts.isBuiltin ? 1 : count.smooth == kAsGiven ? asGiven : count.smooth;
            if (need.isMoved) least[i] = std::max(least[i], asGiven);
        }
        if (isFree[0] || isFree[1])
            needs_[{draw.shape, isFree, least, fidelity}].push_back(need);
        else
            keepStated(*model, numbers, fidelity, need);
    }

    void keepStated(const SurfaceModel& model, const std::vector<double>& numbers, Fidelity fidelity,
                    const Need& need) {
        const double pixels = model.deviation(numbers, fidelity) * need.scale;
        decide(*need.draw, fmt::format("{} as the scene states: {}", countsText(model, numbers),
                                       boundText(pixels, need.isMoved)));
        if (pixels > request_.maxError && !need.isMoved)
            stated_.add(pixels, *need.draw, countsText(model, numbers));
    }

    static std::string boundText(double pixels, bool isMoved) {
        return isMoved ? "no bound, its program moves the vertices"
                       : fmt::format("at most {}", pixelText(pixels));
    }

    /// Draws that need about the same get one mesh, made for the one that needs most.
    void chooseCounts(const MeshKey& key, std::vector<Need>& needs) {
        std::stable_sort(needs.begin(), needs.end(),
                         [](const Need& a, const Need& b) { return a.allowed < b.allowed; });
        for (auto first = needs.begin(); first != needs.end();) {
            constexpr double kHalfTheCounts = 4;
            const auto end = std::find_if(first + 1, needs.end(), [&](const Need& each) {
                return each.allowed >= kHalfTheCounts * first->allowed;
            });
            chooseCounts(key, std::span(first, end));
            first = end;
        }
    }

    void chooseCounts(const MeshKey& key, std::span<const Need> needs) {
        const auto& [shapeIndex, isFree, least, fidelity] = key;
        const scene::Shape& shape = scene_.shapes[static_cast<std::size_t>(shapeIndex)];
        const SurfaceModel& model = *surfaceModel(shape.command);
        const std::vector<double> before = model.complete(shape);
        const LeastCounts chosen = leastCounts({.model = &model,
                                                .numbers = before,
                                                .isFree = isFree,
                                                .least = least,
                                                .fidelity = fidelity,
                                                .allowed = needs.front().allowed});
        for (const Need& need : needs) {
            const double pixels = chosen.deviation * need.scale;
            if (chosen.numbers != before) choice_.shapes.push_back({need.pass, need.step, chosen.numbers});
            decide(*need.draw, fmt::format("{}{}: {}", countsText(model, chosen.numbers),
                                           chosen.numbers == before
                                               ? " kept"
                                               : fmt::format(" in place of {}", countsText(model, before)),
                                           need.scale > 0 ? boundText(pixels, need.isMoved) : "not in view"));
            if (pixels <= request_.maxError || need.isMoved) continue;
            const bool isStated =
                std::find(isFree.begin(), isFree.begin() + static_cast<std::ptrdiff_t>(model.countsUsed),
                          false) != isFree.begin() + static_cast<std::ptrdiff_t>(model.countsUsed);
            (isStated ? stated_ : beyond_).add(pixels, *need.draw, countsText(model, chosen.numbers));
        }
    }

    /// A noise texture's period is taken to be one unit of the model that it is seen on; without a bound for
    /// that, half the height of the picture.
    void noteNoise(const plan::PlannedDraw& planned, const std::optional<double>& scale, double height) {
        for (const plan::TextureUse& each : planned.textures) {
            if (each.texture < 0 || !std::holds_alternative<scene::NoiseSource>(
                                        scene_.textures[static_cast<std::size_t>(each.texture)].source))
                continue;
            auto& [period, draw] = noise_[each.texture];
            period = std::max(period, scale.value_or(height / 2));
            draw = planned.draw;
        }
    }

    void chooseNoise() {
        for (const auto& [texture, use] : noise_) {
            const auto& source =
                std::get<scene::NoiseSource>(scene_.textures[static_cast<std::size_t>(texture)].source);
            const auto& [period, draw] = use;
            const std::string word = fmt::format("Noise{}D", source.dimensions);
            const auto say = [&](std::string why) {
                choice_.decisions.push_back({word, std::move(why), draw->place});
            };
            const auto errorOf = [&](int size) {
                return pixelText(noiseError(source.dimensions, size) * period);
            };
            if (source.file != scene::kNone) {
                say("kept: its texels come from a file");
            } else if (source.isSizeGiven && !request_.overrideCounts) {
                say(fmt::format("{} as the scene states: about {}", source.size, errorOf(source.size)));
            } else {
                const int size = leastNoiseSize(source.dimensions, period, request_.maxError);
                if (size != source.size) choice_.noise.push_back({texture, size});
                say(fmt::format("{}{}: about {} where a period is {:.3g} px long", size,
                                size == source.size ? " kept" : fmt::format(" in place of {}", source.size),
                                errorOf(size), period));
            }
        }
    }

    void chooseSamples() {
        if (!request_.areSamplesFree) return;
        choice_.samples = leastSamples(request_.maxError, request_.mostSamples);
        const double pixels = edgeError(choice_.samples);
        choice_.decisions.push_back(
            {"samples",
             fmt::format("{} a pixel: edges at most {} off", choice_.samples, pixelText(pixels)),
             {scene_.path, 1, 1}});
        if (pixels > request_.maxError)
            choice_.diagnostics.push_back(warning(
                "draw-W07",
                fmt::format(
                    "the driver has {} samples a pixel, with which edges are up to {} off; the bound is {}",
                    choice_.samples, pixelText(pixels), pixelText(request_.maxError)),
                {scene_.path, 1, 1}));
    }

    void report() {
        const auto others = [](int count) {
            return count > 0 ? fmt::format("; so {} {} more", count > 1 ? "are" : "is", count)
                             : std::string();
        };
        if (beyond_.draw != nullptr)
            choice_.diagnostics.push_back(warning(
                "draw-W07",
                fmt::format("{} with {}, the most a mesh may have, is up to {} off; the bound is {}{}",
                            beyond_.draw->word, beyond_.counts, pixelText(beyond_.pixels),
                            pixelText(request_.maxError), others(beyond_.others)),
                beyond_.draw->place));
        if (stated_.draw != nullptr)
            choice_.diagnostics.push_back(
                note("draw-N03",
                     fmt::format("{} with {}, as the scene states, is up to {} off; --override-counts "
                                 "chooses for it{}",
                                 stated_.draw->word, stated_.counts, pixelText(stated_.pixels),
                                 others(stated_.others)),
                     stated_.draw->place));
    }

    const scene::Scene& scene_;
    const plan::FramePlan& plan_;
    const Request& request_;
    std::map<MeshKey, std::vector<Need>> needs_;
    std::map<int, std::pair<double, const scene::Draw*>> noise_;  ///< pixels a period, by texture
    Worst beyond_, stated_;
    Choice choice_;
};

}  // namespace

Choice choose(const scene::Scene& scene, const plan::FramePlan& plan, const Request& request) {
    return Chooser(scene, plan, request).choose();
}

}  // namespace glibra::budget
