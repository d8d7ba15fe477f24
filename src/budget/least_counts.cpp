#include "budget/least_counts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>
#include <variant>

#include "scene/primitives.h"

namespace glibra::budget {

std::vector<LevelUniform> levelUniforms(const plan::PlannedProgram& program, double mostLevel) {
    std::vector<LevelUniform> found;
    for (const plan::UniformBinding& binding : program.values) {
        const auto* literal = std::get_if<plan::Literal>(&binding.value);
        if (!literal || literal->values.size() != 1 || !(literal->values[0] > 0)) continue;
        const plan::ActiveUniform& uniform = at(program.interface->uniforms, binding.uniform);
        if (!program.interface->facts.levelUniforms.contains(uniform.name)) continue;
        LevelUniform level{binding.uniform, literal->values[0], 1, mostLevel};
        for (const plan::Control& control : program.controls)
            if (control.uniform == binding.uniform && control.maximum > 0) {
                level.least = std::max(control.minimum, std::min(1., control.maximum));
                level.most = control.maximum;
            }
        found.push_back(level);
    }
    return found;
}

namespace {

std::vector<LevelValue> scaled(const LevelsRequest& request, double factor) {
    std::vector<LevelValue> values;
    for (const LevelUniform& each : request.uniforms) {
        const double wanted = std::ceil(each.value * factor * 100) / 100;
        values.push_back({each.uniform, std::clamp(wanted, each.least, each.most)});
    }
    return values;
}

}  // namespace

std::optional<LeastLevels> leastLevels(const LevelsRequest& request) {
    const auto measure = [&](const std::vector<LevelValue>& values) -> std::optional<LeastLevels> {
        const std::optional<double> pixels = request.error(values);
        if (!pixels) return std::nullopt;
        return LeastLevels{values, *pixels, *pixels <= request.maxError};
    };
    if (!request.isFree) {
        std::vector<LevelValue> stated;
        for (const LevelUniform& each : request.uniforms) stated.push_back({each.uniform, each.value});
        return measure(stated);
    }
    double lowest = 1e9, highest = 0;
    for (const LevelUniform& each : request.uniforms) {
        lowest = std::min(lowest, each.least / each.value);
        highest = std::max(highest, each.most / each.value);
    }
    std::optional<LeastLevels> best = measure(scaled(request, lowest));
    if (!best || best->isKept) return best;
    best = measure(scaled(request, highest));
    if (!best || !best->isKept) return best;
    for (double tooLow = lowest, enough = highest; enough > 1.02 * tooLow;) {
        const double middle = std::sqrt(tooLow * enough);
        std::optional<LeastLevels> found = measure(scaled(request, middle));
        if (!found) return std::nullopt;
        (found->isKept ? enough : tooLow) = middle;
        if (found->isKept) best = std::move(found);
    }
    return best;
}

namespace {

/// The surfaces of some draws as finely as the driver can show them, to compare levels with.
class Reference {
  public:
    /// Nothing if they cannot be captured.
    static std::optional<Reference> of(const std::vector<TessellatedDraw>& draws, const Request& request) {
        Reference made(draws, request);
        for (const TessellatedDraw& each : draws) {
            auto finest = request.patches(each.pass, each.step, {{}, double(request.mostLevel)});
            if (!finest) return std::nullopt;
            made.finest_.push_back(std::move(*finest));
        }
        const std::optional<double> rest = made.difference({{}, request.mostLevel / 2.});
        if (!rest) return std::nullopt;
        made.own_ = *rest / 3;
        return made;
    }

    /// The error of the finest surface, in pixels: the error falls with the square of the level, so it is a
    /// third of the difference that halving the levels makes.
    [[nodiscard]] double own() const { return own_; }

    /// The largest error in pixels with these values; that of the finest surface is included.
    [[nodiscard]] std::optional<double> error(std::span<const LevelValue> values) const {
        const std::optional<double> found = difference({values});
        return found ? std::optional(*found + own_) : std::nullopt;
    }

  private:
    Reference(const std::vector<TessellatedDraw>& draws, const Request& request)
        : draws_(draws), request_(request) {}

    [[nodiscard]] std::optional<double> difference(const Levels& levels) const {
        double largest = 0;
        for (std::size_t draw = 0; draw < draws_.size(); ++draw) {
            const TessellatedDraw& of = draws_[draw];
            const auto coarse = request_.patches(of.pass, of.step, levels);
            const std::vector<Patch>& fine = finest_[draw];
            if (!coarse || coarse->size() != fine.size()) return std::nullopt;
            for (std::size_t i = 0; i < fine.size(); ++i) {
                if ((*coarse)[i].vertices.empty()) continue;  // the scene culls it
                const std::optional<double> pixels = patchError((*coarse)[i], fine[i], of.size);
                if (!pixels) return std::nullopt;
                largest = std::max(largest, *pixels);
            }
        }
        return largest;
    }

    const std::vector<TessellatedDraw>& draws_;
    const Request& request_;
    std::vector<std::vector<Patch>> finest_;  ///< by draw
    double own_ = 0;
};

/// The program's name as plan::Override::program has it.
std::string programOf(const scene::Scene& scene, const plan::PlannedProgram& planned) {
    return std::to_string(scene.programs[planned.variant.program].place.line);
}

/// Why comparing levels would not show how far the picture is off; empty: it shows it.
std::string whyUnknown(const plan::ProgramInterface& program) {
    for (const glsl::TranslatedStage& each : program.facts.stages) {
        if (each.stage == glsl::Stage::geometry) return "its geometry stage works on individual triangles";
        if (each.stage == glsl::Stage::tessEvaluation &&
            each.source.find("gl_TessLevel") != std::string::npos)
            return "its evaluation stage reads the levels";
    }
    return {};
}

/// "uOuter 8, uInner 4"
std::string namedValues(const plan::PlannedProgram& planned, const std::vector<LevelValue>& values) {
    std::string text;
    for (const LevelValue& each : values)
        text += fmt::format("{}{} {:.4g}", text.empty() ? "" : ", ",
                            at(planned.interface->uniforms, each.uniform).name, each.value);
    return text;
}

/// "8, 4"
std::string statedValues(const std::vector<LevelUniform>& levels) {
    std::string text;
    for (const LevelUniform& each : levels)
        text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", each.value);
    return text;
}

void chooseFor(const scene::Scene& scene, const plan::PlannedProgram& planned,
               const std::vector<TessellatedDraw>& draws, const Request& request, ChosenLevels& chosen) {
    const scene::Draw& first = *draws.front().draw;
    const auto decide = [&](std::string why) {
        chosen.decisions.push_back({first.word, std::move(why), first.place});
    };
    const auto give = [&](const std::string& why) {
        decide("kept: " + why + ", so no bound is known");
        chosen.unknown.push_back({&first, why});
    };
    if (!request.patches) return;
    if (planned.interface->facts.tessellationOutput == "points")
        return decide("kept: its program shows single vertices");
    if (const std::string why = whyUnknown(*planned.interface); !why.empty()) return give(why);
    const std::optional<Reference> reference = Reference::of(draws, request);
    if (!reference) return give("what its tessellation does cannot be measured");

    LevelsRequest levels{levelUniforms(planned, request.mostLevel), request.overrideCounts, request.maxError,
                         [&](std::span<const LevelValue> values) { return reference->error(values); }};
    const std::size_t all = levels.uniforms.size();
    std::erase_if(levels.uniforms, [&](const LevelUniform& each) {
        const std::string& name = at(planned.interface->uniforms, each.uniform).name;
        return std::ranges::any_of(request.overrides,
                                   [&](const plan::Override& set) { return set.name == name; });
    });
    const bool areSet = levels.uniforms.size() < all;
    levels.isFree = levels.isFree && !levels.uniforms.empty();
    const std::optional<LeastLevels> found = leastLevels(levels);
    if (!found) return give("what its tessellation does cannot be measured");
    if (!std::isfinite(found->pixels)) return give("it reaches behind the eye");

    const std::string with = namedValues(planned, found->values);
    std::string why = with + " as the scene states";
    Miss miss{found->pixels, &first, first.word, with, !levels.isFree};
    if (levels.isFree) {
        why = with + " in place of " + statedValues(levels.uniforms);
        for (const auto& [uniform, value] : found->values)
            chosen.overrides.push_back({at(planned.interface->uniforms, uniform).name,
                                        glib::UniformForm::number,
                                        {value},
                                        programOf(scene, planned)});
        // More does not help where other levels than those of the uniforms are too low.
        const bool areHighest = std::ranges::none_of(
            levels.uniforms, [&](const LevelUniform& each) { return each.most < request.mostLevel; });
        if (areHighest && reference->own() <= request.maxError) {
            miss.isStated = true;
            miss.fixedBy = "no uniform of the Program line decides its other levels alone";
        }
    } else if (levels.uniforms.empty()) {
        why = areSet ? "the levels of --set" : "the levels that its program has";
        miss.with = why;
        miss.fixedBy = areSet ? "--set states them" : "no uniform of the Program line decides them alone";
    }
    decide(fmt::format("{}: at most {}", why, pixelText(found->pixels)));
    if (!found->isKept) chosen.misses.push_back(std::move(miss));
}

}  // namespace

ChosenLevels chooseLevels(const scene::Scene& scene, const plan::FramePlan& plan,
                          const std::map<plan::PlannedProgramIndex, std::vector<TessellatedDraw>>& draws,
                          const Request& request) {
    ChosenLevels chosen;
    for (const auto& [program, each] : draws) chooseFor(scene, plan.programs[program], each, request, chosen);
    return chosen;
}

namespace {

/// "64 texels per side", "64 texels per side with 16 bits"
std::string noiseText(const NoiseFormat& format) {
    return fmt::format("{} texels per side{}", format.size,
                       format.texels == scene::NoiseTexels::shorts ? " with 16 bits" : "");
}

class NoiseChooser {
  public:
    NoiseChooser(const scene::Scene& scene, const std::map<scene::TextureIndex, NoiseUse>& uses,
                 const Request& request)
        : scene_(scene), uses_(uses), request_(request) {}

    ChosenNoise choose() {
        measure();
        for (const auto& [texture, use] : uses_) {
            const scene::NoiseSource& noise = noiseOf(texture);
            if (noise.file)
                say(noise, use, "kept: its texels come from a file");
            else if (isFree(noise))
                chooseOne(texture, use);
            else
                keepStated(noise, use);
        }
        return std::move(chosen_);
    }

  private:
    [[nodiscard]] const scene::NoiseSource& noiseOf(scene::TextureIndex texture) const {
        return std::get<scene::NoiseSource>(scene_.textures[texture].source);
    }
    [[nodiscard]] bool isFree(const scene::NoiseSource& noise) const {
        return !noise.file && (!noise.isSizeGiven || request_.overrideCounts);
    }

    /// Measures on two pictures how contours move. Programs stretch noise, add octaves of their own and raise
    /// its contrast, so the contours that they draw move further than those of the noise itself.
    void measure() {
        Choice from, to;
        for (const auto& [texture, use] : uses_) {
            if (noiseOf(texture).file) continue;
            from.noise.push_back({texture, {kNoiseProbeSizes[0], scene::NoiseTexels::shorts}});
            to.noise.push_back({texture, {kNoiseProbeSizes[1], scene::NoiseTexels::shorts}});
        }
        if (!from.noise.empty() && request_.contourShift) measured_ = request_.contourShift(from, to);
    }

    /// In pixels. Changes of a value that nobody can see move nothing.
    [[nodiscard]] double errorOf(int dimensions, const NoiseFormat& format, double period) const {
        constexpr double kVisible = 4. / 255;
        const double periods = noiseError(dimensions, format);
        if (!measured_) return periods * period;
        const double step = meanNoiseStep(dimensions);
        // The largest change in a square relates to the mean as noiseError, which bounds 999 of 1000 errors,
        // relates to the mean error.
        const double largestStep = noiseError(dimensions, {kNoiseProbeSizes[1], scene::NoiseTexels::shorts});
        return measured_->ofChangesAbove(kVisible * largestStep / periods) * periods / step;
    }

    void say(const scene::NoiseSource& noise, const NoiseUse& use, std::string why) {
        chosen_.decisions.push_back(
            {fmt::format("Noise{}D", noise.dimensions), std::move(why), use.draw->place});
    }

    void miss(const scene::NoiseSource& noise, const NoiseUse& use, double pixels, int size, bool isStated) {
        chosen_.misses.push_back({pixels, use.draw, fmt::format("Noise{}D", noise.dimensions),
                                  fmt::format("{} texels per side", size), isStated});
    }

    [[nodiscard]] std::string_view sourceText() const {
        return measured_ ? ", as two pictures tell" : " if a period is one unit of the model";
    }

    void keepStated(const scene::NoiseSource& noise, const NoiseUse& use) {
        const double pixels = errorOf(noise.dimensions, {noise.size, noise.texels}, use.period);
        say(noise, use,
            fmt::format("{} as the scene states: about {}{}", noise.size, pixelText(pixels), sourceText()));
        if (pixels > request_.maxError) miss(noise, use, pixels, noise.size, true);
    }

    void chooseOne(scene::TextureIndex texture, const NoiseUse& use) {
        const scene::NoiseSource& noise = noiseOf(texture);
        const NoiseFormat before{noise.size, noise.texels};
        const auto pixelsOf = [&](const NoiseFormat& format) {
            return errorOf(noise.dimensions, format, use.period);
        };
        const NoiseFormat best = leastNoise(noise.dimensions, request_.maxError, pixelsOf);
        const double pixels = pixelsOf(best);
        if (best != before) chosen_.choices.push_back({texture, best});
        say(noise, use,
            fmt::format("{}{}: about {}{}", noiseText(best),
                        best == before ? " kept" : fmt::format(" in place of {}", noiseText(before)),
                        pixelText(pixels), sourceText()));
        if (pixels > request_.maxError) miss(noise, use, pixels, best.size, false);
    }

    const scene::Scene& scene_;
    const std::map<scene::TextureIndex, NoiseUse>& uses_;
    const Request& request_;
    std::optional<ContourShifts> measured_;
    ChosenNoise chosen_;
};

}  // namespace

ChosenNoise chooseNoise(const scene::Scene& scene, const std::map<scene::TextureIndex, NoiseUse>& uses,
                        const Request& request) {
    return NoiseChooser(scene, uses, request).choose();
}

namespace {

constexpr int kMostCount = geometry::kMostSubdivisions;

class Search {
  public:
    explicit Search(const CountsRequest& request) : request_(request) {
        const auto counts = request.model->usedCounts();
        for (std::size_t i = 0; i < counts.size(); ++i)
            if (request.isFree[i])
                free_.push_back({counts[i].index, std::max(counts[i].least, request.least[i])});
    }

    [[nodiscard]] std::vector<double> find() {
        if (free_.empty()) return request_.numbers;
        if (const auto found = within(request_.allowed)) return *found;
        if (free_.size() == request_.model->countsUsed) return nearest();
        // A stated count is too small. The others are chosen as if it were free.
        CountsRequest all = request_;
        all.isFree.fill(true);
        const std::vector<double> wanted = Search(all).find();
        std::vector<double> numbers = request_.numbers;
        for (const Free& each : free_) numbers[each.index] = wanted[each.index];
        return numbers;
    }

  private:
    struct Free {
        std::size_t index;
        int least;
    };

    [[nodiscard]] double deviation(const std::vector<double>& numbers) const {
        return request_.model->deviation(numbers, request_.fidelity);
    }
    [[nodiscard]] std::uint64_t vertices(const std::vector<double>& numbers) const {
        return scene::countsOf({request_.model->command, numbers, {}, nullptr})
            .value_or(geometry::Counts{})
            .vertices;
    }
    /// Sets one count to the smallest that keeps the bound together with the others. Returns false if there
    /// is none.
    bool lower(std::vector<double>& numbers, const Free& count, double allowed) const {
        double& number = numbers[count.index];
        const auto keeps = [&](int n) {
            number = n;
            return deviation(numbers) <= allowed;
        };
        if (keeps(count.least)) return true;
        int tooFew = count.least, enough = kMostCount;
        // Most counts are small, so the search begins there.
        while (tooFew < kMostCount) {
            const int next = std::min(2 * tooFew, kMostCount);
            if (keeps(next)) {
                enough = next;
                break;
            }
            if (next == kMostCount) return false;
            tooFew = next;
        }
        while (enough - tooFew > 1) {
            const int middle = tooFew + (enough - tooFew) / 2;
            (keeps(middle) ? enough : tooFew) = middle;
        }
        number = enough;
        return true;
    }

    [[nodiscard]] std::optional<std::vector<double>> within(double allowed) const {
        std::vector<double> numbers = request_.numbers;
        if (free_.size() == 1) {
            if (!lower(numbers, free_[0], allowed) || vertices(numbers) > kMostBudgetVertices)
                return std::nullopt;
            return numbers;
        }
        // The first count is smallest if the second is as large as possible.
        numbers[free_[1].index] = kMostCount;
        if (!lower(numbers, free_[0], allowed)) return std::nullopt;
        std::optional<std::vector<double>> best;
        std::uint64_t fewest = kMostBudgetVertices + 1;
        for (int first = static_cast<int>(numbers[free_[0].index]); first <= kMostCount; ++first) {
            numbers[free_[0].index] = first;
            numbers[free_[1].index] = free_[1].least;
            if (vertices(numbers) >= fewest) break;
            if (!lower(numbers, free_[1], allowed)) continue;
            if (const std::uint64_t all = vertices(numbers); all < fewest) {
                fewest = all;
                best = numbers;
            }
        }
        return best;
    }

    /// Finds the smallest bound that can be kept, to a thousandth.
    [[nodiscard]] std::vector<double> nearest() const {
        double kept = deviation(request_.numbers), tooSmall = request_.allowed;
        std::optional<std::vector<double>> best = within(kept);
        if (!best) return request_.numbers;
        while (kept > 1.001 * tooSmall && kept > 0) {
            // Bounds differ by powers of ten, so the geometric middle is used.
            const double middle = tooSmall > 0 ? std::sqrt(kept * tooSmall) : kept / 1000;
            if (auto found = within(middle)) {
                kept = middle;
                best = std::move(found);
            } else {
                tooSmall = middle;
            }
        }
        return *best;
    }

    const CountsRequest& request_;
    std::vector<Free> free_;
};

}  // namespace

std::vector<double> leastCounts(const CountsRequest& request) {
    return Search(request).find();
}

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
