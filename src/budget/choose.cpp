#include "budget/budget.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "budget/least_counts.h"
#include "geometry/mesh.h"
#include "glsl/types/builtins.h"
#include "plan/accesses.h"
#include "plan/program_variant.h"
#include "scene/primitives.h"
#include "scene/textures.h"
#include "scene/view.h"

namespace glibra::budget {
namespace {

struct ProgramFacts {
    bool isBuiltin = false;          ///< draws one colour: at the vertices it computes only their positions
    bool placesByMatrix = false;     ///< provably places vertices by the model-view-projection alone
    bool readsTexCoord = false;      ///< reads texture coordinates
    bool worksOnPrimitives = false;  ///< has a tessellation or geometry stage
    bool hasTessellation = false;
    /// It reads normals or tangents, which between vertices differ from those of the surface, and its
    /// fragment stage looks into a cube map along a reflection, or refracts.
    bool magnifiesNormals = false;
    /// Its vertex stage calls functions other than constructors and normalize(), so its results may not be
    /// linear between the vertices.
    bool computesAtVertices = false;
    /// It shows the single triangles (glsl::StageFacts::showsPrimitives), so a mesh with other counts would
    /// show something else.
    bool showsPrimitives = false;
};

ProgramFacts programFacts(const plan::ProgramInterface& program) {
    ProgramFacts facts;
    facts.isBuiltin = program.isBuiltin;
    facts.placesByMatrix = program.isBuiltin || program.facts.placement != glsl::Placement::unknown;
    bool readsNormals = false;
    for (const plan::ActiveInput& each : program.inputs)
        if (const glsl::BuiltinInput* row = glsl::findBuiltinInput(each.name); row != nullptr) {
            facts.readsTexCoord = facts.readsTexCoord || row->attribute == geometry::kTexCoord;
            readsNormals =
                readsNormals || row->attribute == geometry::kNormal || row->attribute == geometry::kTangent;
        }
    for (const glsl::TranslatedStage& each : program.facts.stages) {
        const bool isVertex = each.stage == glsl::Stage::vertex;
        const bool isFragment = each.stage == glsl::Stage::fragment;
        facts.worksOnPrimitives = facts.worksOnPrimitives || !(isVertex || isFragment);
        facts.hasTessellation = facts.hasTessellation || each.stage == glsl::Stage::tessEvaluation;
        facts.computesAtVertices = facts.computesAtVertices || (isVertex && each.facts.callsFunctions);
        facts.showsPrimitives = facts.showsPrimitives || each.facts.showsPrimitives;
        if (isFragment) facts.magnifiesNormals = readsNormals && each.facts.magnifiesNormals;
    }
    return facts;
}

/// The factor by which counts must be larger than for smooth light: a reflected ray turns by twice the angle
/// of its normal, and a refracted one turns even more at a flat angle.
constexpr int kMirror = 2;

constexpr double kAny = std::numeric_limits<double>::infinity();

/// "44 slices, 22 stacks"
std::string countsText(const SurfaceModel& model, const std::vector<double>& numbers) {
    std::string text;
    for (const CountArgument& each : model.usedCounts())
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", numbers[each.index], each.name);
    return text;
}

/// One draw whose counts may be chosen, and how fine its mesh must be.
struct Need {
    std::size_t pass = 0, step = 0;
    const scene::Draw* draw = nullptr;
    double scale = 0;    ///< pixels per model unit
    double allowed = 0;  ///< deviation in model units
    plan::PlannedProgramIndex program{};
    bool isMoved = false;
    bool isMeasured = false;  ///< its program computes more at the vertices than their places
};

/// The result for the shape of one draw.
struct Drawn {
    Need need;
    const SurfaceModel* model = nullptr;
    std::vector<double> before, numbers;  ///< complete
    std::array<bool, 2> isFree{};
    Fidelity fidelity = Fidelity::shape;
    std::optional<VertexError> vertices{};

    [[nodiscard]] bool isAllStated() const { return !isFree[0] && !isFree[1]; }
    [[nodiscard]] bool isAnyStated() const {
        return !std::ranges::all_of(std::span(isFree).first(model->countsUsed), std::identity());
    }
};

/// Draws with equal keys may share a mesh.
using MeshKey = std::tuple<scene::ShapeIndex, std::array<bool, 2>, std::array<int, 2>, Fidelity>;

class Chooser {
  public:
    Chooser(const scene::Scene& scene, const plan::FramePlan& plan, const Request& request)
        : scene_(scene), plan_(plan), request_(request) {}

    Choice choose() {
        for (const plan::PlannedPass& pass : plan_.passes) lookAt(pass);
        for (auto& [key, needs] : needs_) chooseCounts(key, needs);
        measureVertices();
        for (const Drawn& each : drawn_) conclude(each);
        chooseLevels();
        chooseNoise();
        chooseSamples();
        report();
        std::ranges::stable_sort(choice_.decisions, [](const Decision& a, const Decision& b) {
            return a.place.line < b.place.line;
        });
        return std::move(choice_);
    }

  private:
    /// What exceeds the bound most, and how many others exceed it.
    struct Worst {
        Miss most;
        int others = -1;
        void add(Miss found) {
            ++others;
            if (!(found.pixels <= most.pixels)) most = std::move(found);
        }
    };

    /// The same for the values that programs compute at their vertices.
    struct WorstVertices {
        VertexError error;
        const scene::Draw* draw = nullptr;
        std::string counts;
        int others = -1;
        void add(const VertexError& found, const scene::Draw& at, std::string with) {
            ++others;
            if (draw != nullptr &&
                std::tie(found.pixels, found.colored) <= std::tie(error.pixels, error.colored))
                return;
            error = found;
            draw = &at;
            counts = std::move(with);
        }
    };

    void decide(const scene::Draw& draw, std::string why) {
        choice_.decisions.push_back({draw.word, std::move(why), draw.place});
    }

    void lookAt(const plan::PlannedPass& planned) {
        const scene::Pass& pass = plan_.passOf(planned);
        const double windowAspect = static_cast<double>(request_.width) / request_.height;
        const double aspect = scene::aspectOf(scene_, pass, windowAspect);
        glm::dvec2 size(request_.width, request_.height);
        if (!pass.isWindow)
            if (const auto target = scene::targetSize(scene_, pass)) size = {(*target)[0], (*target)[1]};
        for (const auto& each : planned.steps)
            if (const auto* draw = std::get_if<plan::PlannedDraw>(&each)) {
                if (pass.isWindow) noteEdges(*draw);
                lookAt(*draw, {draw->step.pass, draw->step.step, &plan_.drawOf(*draw)}, aspect, size);
            }
    }

    void lookAt(const plan::PlannedDraw& planned, Need need, double aspect, const glm::dvec2& size) {
        const scene::Draw& draw = plan_.drawOf(planned);
        const scene::Shape& shape = scene_.shapes[draw.shape];
        const plan::ProgramInterface& program = *plan_.programs[planned.program].interface;
        const SurfaceModel* model = shape.list ? nullptr : surfaceModel(shape.command);
        const glm::dmat4 matrix = request_.clipFromModel(draw, aspect);
        const std::vector<double> numbers = model != nullptr ? model->complete(shape) : std::vector<double>();
        std::optional<double> scale;
        if (model != nullptr) scale = pixelsPerUnit(matrix, model->extent(numbers), size.x, size.y);
        noteNoise(planned, scale, size.y);
        if (scene::drawsNothing(shape)) return;
        const ProgramFacts facts = programFacts(program);
        if (facts.hasTessellation && planned.submission.patchVertices > 0)
            tessellated_[planned.program].push_back({need.pass, need.step, &draw, size});
        if (model == nullptr) return noteMesh(draw);

        if (draw.flatColors || facts.showsPrimitives)
            return decide(draw, "kept: its program shows individual triangles");
        if (facts.worksOnPrimitives)
            return decide(draw, "kept: its tessellation or geometry stage works on individual triangles");
        if (!scale) {
            unknown_.push_back({&draw, "it reaches behind the eye"});
            return decide(draw, "kept: reaches behind the eye, so no bound is known");
        }

        need.scale = *scale;
        need.allowed = *scale > 0 ? request_.maxError / *scale : kAny;
        need.program = planned.program;
        need.isMoved = !facts.placesByMatrix || givesAny(draw, program.facts.placementNames);
        need.isMeasured = *scale > 0 && !need.isMoved && facts.computesAtVertices;
        const Fidelity fidelity = facts.readsTexCoord ? Fidelity::pattern : Fidelity::shape;
        std::array<bool, 2> isFree{};
        std::array<int, 2> least{};
        for (std::size_t i = 0; i < model->countsUsed; ++i) {
            const CountArgument& count = model->counts[i];
            const int asGiven = static_cast<int>(numbers[count.index]);
            isFree[i] = request_.overrideCounts || count.isFixed || count.index >= draw.givenNumbers;
            // Straight lines need no vertices between their ends, if pictures show that nothing else does.
            const bool isStraight = count.smooth == kAsGiven && request_.contourShift && *scale > 0;
            least[i] = facts.isBuiltin || isStraight ? 1 : count.smooth == kAsGiven ? asGiven : count.smooth;
            if (!facts.isBuiltin && isStraight && !need.isMoved && isFree[i] && asGiven > 1)
                need.isMeasured = true;
            if (facts.magnifiesNormals && count.smooth != kAsGiven) least[i] *= kMirror;
            if (need.isMoved) least[i] = std::max(least[i], asGiven);
        }
        if (isFree[0] || isFree[1])
            needs_[{draw.shape, isFree, least, fidelity}].push_back(need);
        else
            drawn_.push_back({need, model, numbers, numbers, isFree, fidelity});
    }

    /// Draws with about the same need share one mesh, made for the draw that needs most.
    void chooseCounts(const MeshKey& key, std::vector<Need>& needs) {
        std::ranges::stable_sort(needs, [](const Need& a, const Need& b) { return a.allowed < b.allowed; });
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
        const scene::Shape& shape = scene_.shapes[shapeIndex];
        const SurfaceModel& model = *surfaceModel(shape.command);
        const std::vector<double> before = model.complete(shape);
        const std::vector<double> chosen = leastCounts({.model = &model,
                                                        .numbers = before,
                                                        .isFree = isFree,
                                                        .least = least,
                                                        .fidelity = fidelity,
                                                        .allowed = needs.front().allowed});
        for (const Need& need : needs) drawn_.push_back({need, &model, before, chosen, isFree, fidelity});
    }

    /// Raises counts where pictures show that light, normals or moved vertices need it.
    void measureVertices() {
        if (!request_.contourShift) return;
        VertexRequest vertices{{}, request_.maxError, {}};
        std::vector<Drawn*> measured;
        for (Drawn& each : drawn_)
            if (each.need.isMeasured) {
                const Need& need = each.need;
                vertices.draws.push_back({need.pass, need.step, each.model, each.numbers, each.before,
                                          each.isFree, need.program, each.fidelity, need.scale});
                measured.push_back(&each);
            }
        if (measured.empty()) return;
        vertices.shift = [&](std::span<const ShapeChoice> from, std::span<const ShapeChoice> to) {
            Choice coarse, fine;
            coarse.shapes.assign(from.begin(), from.end());
            fine.shapes.assign(to.begin(), to.end());
            // A single sample would show edges moving by whole pixels or not at all.
            coarse.samples = fine.samples = std::min(4, std::max(1, request_.mostSamples));
            return request_.contourShift(coarse, fine);
        };
        const std::optional<VertexValues> found = vertexValues(vertices);
        if (!found) {
            for (Drawn* each : measured) keepStraight(*each);
            return;
        }
        for (std::size_t i = 0; i < measured.size(); ++i) {
            measured[i]->numbers = found->numbers[i];
            for (const VertexResult& each : found->programs)
                if (each.program == measured[i]->need.program) measured[i]->vertices = each.error;
        }
    }

    /// Nothing is known of what the program shows along straight lines.
    static void keepStraight(Drawn& drawn) {
        for (const CountArgument& each : drawn.model->usedCounts())
            if (each.smooth == kAsGiven)
                drawn.numbers[each.index] = std::max(drawn.numbers[each.index], drawn.before[each.index]);
    }

    void conclude(const Drawn& drawn) {
        const Need& need = drawn.need;
        const SurfaceModel& model = *drawn.model;
        const bool isChanged = drawn.numbers != drawn.before;
        const std::string counts = countsText(model, drawn.numbers);
        if (isChanged) choice_.shapes.push_back({need.pass, need.step, drawn.numbers});
        if (need.isMoved && need.scale > 0) unknown_.push_back({need.draw, "its program moves the vertices"});
        const double pixels = model.deviation(drawn.numbers, drawn.fidelity) * need.scale;
        const std::string kept = drawn.isAllStated() ? " as the scene states" : " kept";
        decide(*need.draw,
               fmt::format("{}{}: {}", counts,
                           isChanged ? fmt::format(" in place of {}", countsText(model, drawn.before)) : kept,
                           need.scale > 0 ? boundText(pixels, drawn) : "not in view"));
        if (!need.isMoved && pixels > request_.maxError)
            miss({pixels, need.draw, need.draw->word, counts, drawn.isAnyStated()});
        if (drawn.vertices && !drawn.vertices->isKept)
            (drawn.isAnyStated() ? statedVertices_ : beyondVertices_)
                .add(*drawn.vertices, *need.draw, counts);
    }

    static std::string boundText(double pixels, const Drawn& drawn) {
        if (drawn.need.isMoved) return "no bound, its program moves the vertices";
        std::string shape = fmt::format("at most {}", pixelText(pixels));
        if (!drawn.vertices) return shape;
        return shape + "; values computed at the vertices " +
               changeText(drawn.vertices->pixels, drawn.vertices->colored);
    }

    /// True if the scene or the command line gives a uniform or input of such a name a value.
    bool givesAny(const scene::Draw& draw, std::span<const std::string> names) const {
        const auto isOne = [&](std::string_view name) {
            return std::ranges::find(names, name) != names.end();
        };
        const auto isGiven = [&](const glib::UniformSpec& each) { return isOne(each.tag); };
        return !names.empty() &&
               (draw.attributes || std::ranges::any_of(scene_.programs[draw.program].uniforms, isGiven) ||
                (draw.uniforms && std::ranges::any_of(scene_.uniformSets[draw.uniforms].values, isGiven)) ||
                std::ranges::any_of(scene_.namedValues, isGiven) ||
                std::ranges::any_of(plan_.nodes->namedValues, isGiven) ||
                std::ranges::any_of(request_.overrides, isOne, &plan::Override::name));
    }

    /// The counts that a Mesh statement has stay, whoever reads its vertices.
    void noteMesh(const scene::Draw& draw) {
        if (!draw.attributes) return;
        for (const scene::AttributeBinding& each : scene_.attributeSets[draw.attributes].bindings) {
            const auto* view = std::get_if<scene::BufferView>(&each.source);
            if (view == nullptr) continue;
            const scene::Buffer& buffer = scene_.buffers[view->buffer];
            const SurfaceModel* model = buffer.meshOf ? surfaceModel(*buffer.meshOf) : nullptr;
            if (model == nullptr || model->countsUsed == 0) continue;
            const std::string why =
                fmt::format("'{}' has the counts that its Mesh statement states", buffer.name);
            unknown_.push_back({&draw, why});
            return decide(draw, "kept: " + why);
        }
    }

    void noteEdges(const plan::PlannedDraw& planned) {
        const auto edges = plan::paintedEdges(plan_.programs[planned.program], planned.textures);
        paintsEdges_ = paintsEdges_ || edges == plan::PaintedEdges::shown;
        if (edges == plan::PaintedEdges::perPixel) perPixel_.push_back(&plan_.drawOf(planned));
    }

    void noteNoise(const plan::PlannedDraw& planned, const std::optional<double>& scale, double height) {
        for (const plan::TextureUse& each : planned.textures) {
            if (!each.view.texture ||
                !std::holds_alternative<scene::NoiseSource>(scene_.textures[each.view.texture].source))
                continue;
            NoiseUse& use = noise_[each.view.texture];
            use.period = std::max(use.period, scale.value_or(height / 2));
            use.draw = &plan_.drawOf(planned);
        }
    }

    void chooseLevels() {
        ChosenLevels chosen = budget::chooseLevels(scene_, plan_, tessellated_, request_);
        choice_.levels = std::move(chosen.overrides);
        take(std::move(chosen.decisions), std::move(chosen.misses));
        std::ranges::move(chosen.unknown, std::back_inserter(unknown_));
    }

    void chooseNoise() {
        ChosenNoise chosen = budget::chooseNoise(scene_, noise_, request_);
        choice_.noise = std::move(chosen.choices);
        take(std::move(chosen.decisions), std::move(chosen.misses));
    }

    void take(std::vector<Decision> decisions, std::vector<Miss> misses) {
        std::ranges::move(decisions, std::back_inserter(choice_.decisions));
        for (Miss& each : misses) miss(std::move(each));
    }

    void miss(Miss found) { (found.isStated ? stated_ : beyond_).add(std::move(found)); }

    void chooseSamples() {
        if (!request_.areSamplesFree) return;
        choice_.samples = leastSamples(request_.maxError, request_.mostSamples);
        const double pixels = edgeError(choice_.samples);
        choice_.decisions.push_back(
            {"samples",
             fmt::format("{} per pixel: edges at most {} off{}", choice_.samples, pixelText(pixels),
                         paintsEdges_ && choice_.samples > 1
                             ? "; fragment stages that may paint edges run for each sample"
                             : ""),
             {scene_.path, 1, 1}});
        const double once = edgeError(1);
        for (const scene::Draw* each : perPixel_)
            decide(*each, fmt::format("its fragment stage writes memory, so it runs once per pixel: edges "
                                      "that it paints at most {} off",
                                      pixelText(once)));
        if (!perPixel_.empty() && once > request_.maxError)
            choice_.diagnostics.push_back(diagnose(
                "draw-W07",
                fmt::format("edges that the fragment stage of {} paints may be {} off, because it writes "
                            "memory and so runs once per pixel; the bound is {}{}",
                            perPixel_.front()->word, pixelText(once), pixelText(request_.maxError),
                            others(static_cast<int>(perPixel_.size()) - 1)),
                perPixel_.front()->place));
        if (pixels > request_.maxError)
            choice_.diagnostics.push_back(diagnose(
                "draw-W07",
                fmt::format(
                    "the driver has {} samples per pixel, with which edges are up to {} off; the bound is {}",
                    choice_.samples, pixelText(pixels), pixelText(request_.maxError)),
                {scene_.path, 1, 1}));
    }

    static std::string others(int count) {
        return count > 0 ? fmt::format("; the same holds for {} more", count) : std::string();
    }

    void report() {
        const auto say = [&](const char* id, const scene::Draw& draw, std::string text) {
            choice_.diagnostics.push_back(diagnose(id, std::move(text), draw.place));
        };
        if (const Miss& most = beyond_.most; most.draw != nullptr)
            say("draw-W07", *most.draw,
                fmt::format("{} with {}, the largest possible, is up to {} off; the bound is {}{}", most.what,
                            most.with, pixelText(most.pixels), pixelText(request_.maxError),
                            others(beyond_.others)));
        if (const WorstVertices& worst = beyondVertices_; worst.draw != nullptr)
            say("draw-W07", *worst.draw,
                fmt::format(
                    "the values that the program computes at the vertices of {} with {} are {}; finer "
                    "counts do not help, the bound is {}{}",
                    worst.draw->word, worst.counts, changeText(worst.error.pixels, worst.error.colored),
                    pixelText(request_.maxError), others(worst.others)));
        const Miss& stated = stated_.most;
        if (const WorstVertices& worst = statedVertices_; stated.draw == nullptr && worst.draw != nullptr)
            say("draw-N03", *worst.draw,
                fmt::format(
                    "the values that the program computes at the vertices of {} with {}, as the scene "
                    "states, are {}; use --override-counts to choose finer ones{}",
                    worst.draw->word, worst.counts, changeText(worst.error.pixels, worst.error.colored),
                    others(worst.others)));
        if (stated.draw != nullptr) {
            const bool isFixed = !stated.fixedBy.empty();
            say("draw-N03", *stated.draw,
                fmt::format("{} with {}{} is up to {} off; {}{}", stated.what, stated.with,
                            isFixed ? "" : ", as the scene states,", pixelText(stated.pixels),
                            isFixed ? stated.fixedBy + ", so nothing finer is chosen"
                                    : "use --override-counts to choose finer ones",
                            others(stated_.others)));
        }
        if (!unknown_.empty())
            say("draw-N05", *unknown_.front().draw,
                fmt::format("no bound is known for {}: {}{}", unknown_.front().draw->word,
                            unknown_.front().why, others(static_cast<int>(unknown_.size()) - 1)));
    }

    const scene::Scene& scene_;
    const plan::FramePlan& plan_;
    const Request& request_;
    std::map<MeshKey, std::vector<Need>> needs_;
    std::map<plan::PlannedProgramIndex, std::vector<TessellatedDraw>> tessellated_;
    std::map<scene::TextureIndex, NoiseUse> noise_;
    std::vector<Drawn> drawn_;
    std::vector<Unknown> unknown_;
    bool paintsEdges_ = false;
    std::vector<const scene::Draw*> perPixel_;  ///< that may paint edges
    Worst beyond_, stated_;
    WorstVertices beyondVertices_, statedVertices_;
    Choice choice_;
};

}  // namespace

Choice choose(const scene::Scene& scene, const plan::FramePlan& plan, const Request& request) {
    return Chooser(scene, plan, request).choose();
}

namespace {

using Key = std::pair<glib::CommandId, std::vector<double>>;

/// Returns the shapes that are drawn. A draw whose shape is about to be replaced has none.
std::set<scene::ShapeIndex> drawnShapes(const scene::Scene& scene) {
    std::set<scene::ShapeIndex> drawn;
    scene.frame.visitDraws([&](const scene::Draw& draw, const auto&) {
        if (draw.shape) drawn.insert(draw.shape);
    });
    return drawn;
}

}  // namespace

std::vector<scene::ShapeIndex> apply(const Choice& choice, scene::Scene& scene) {
    std::vector<scene::Draw*> draws;
    std::vector<scene::Shape> wanted;
    for (const ShapeChoice& each : choice.shapes) {
        auto& draw = std::get<scene::Draw>(scene.frame.passes.at(each.pass).steps.at(each.step));
        wanted.push_back({scene.shapes[draw.shape].command, each.numbers, {}, nullptr});
        draws.push_back(&draw);
        draw.shape = {};
    }
    // Shapes that are no longer drawn are replaced by the new ones, so that none is left over.
    const std::set<scene::ShapeIndex> stillDrawn = drawnShapes(scene);
    std::vector<scene::ShapeIndex> vacant, replaced;
    for (const scene::ShapeIndex each : scene.shapes.indices())
        if (!stillDrawn.contains(each)) vacant.push_back(each);
    std::map<Key, scene::ShapeIndex> known;
    for (const scene::ShapeIndex each : stillDrawn)
        if (const scene::Shape& shape = scene.shapes[each]; !shape.list && !shape.file)
            known.emplace(Key{shape.command, shape.numbers}, each);
    for (std::size_t i = 0; i < draws.size(); ++i) {
        scene::ShapeIndex& shape = known[Key{wanted[i].command, wanted[i].numbers}];
        if (!shape && replaced.size() < vacant.size()) {
            shape = vacant[replaced.size()];
            replaced.push_back(shape);
            scene.shapes[shape] = std::move(wanted[i]);
        } else if (!shape) {
            shape = scene.shapes.add(std::move(wanted[i]));
        }
        draws[i]->shape = shape;
    }
    for (const NoiseChoice& each : choice.noise) {
        scene::Texture& texture = scene.textures[each.texture];
        auto& noise = std::get<scene::NoiseSource>(texture.source);
        noise.size = each.format.size;
        noise.texels = each.format.texels;
    }
    return replaced;
}

}  // namespace glibra::budget
