#include "render/check/nan_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <span>
#include <utility>

#include "base/text.h"
#include "gpu/object/buffer.h"
#include "gpu/object/timer.h"
#include "gpu/object/uniform.h"
#include "render/consequences.h"
#include "render/draw/frame.h"
#include "render/load/derived_program.h"
#include "scene/textures.h"

namespace glibra::render {

// ---- Positions

namespace {

constexpr GLuint kMostVertices = 1U << 25U;
constexpr std::size_t kPositionFloats = 4;  ///< per captured vertex

/// The primitives that leave the last stage before rasterisation.
struct Output {
    GLenum mode = GL_TRIANGLES;
    GLuint corners = 3;
    std::string kind = "triangles";
};

Output outputOf(const std::string& word) {
    if (word.starts_with("point")) return {GL_POINTS, 1, "points"};
    if (word.starts_with("line")) return {GL_LINES, 2, "lines"};
    return {};
}

Output outputOf(const glsl::TranslatedProgram& program, geometry::Topology topology) {
    if (!program.geometryOutput.empty()) return outputOf(program.geometryOutput);
    if (!program.tessellationOutput.empty()) return outputOf(program.tessellationOutput);
    if (topology == geometry::Topology::points) return outputOf("points");
    const bool isLines =
        topology == geometry::Topology::lines || topology == geometry::Topology::linesAdjacency;
    return outputOf(isLines ? "lines" : "triangles");
}

/// The count of a query around `work`.
template <class Work>
GLuint counted(GLenum what, const Work& work) {
    const gpu::Query query(what);
    query.begin();
    work();
    query.end();
    return static_cast<GLuint>(query.result());
}

/// The number of captured primitives with a component that is not finite.
std::uint64_t countLost(const gpu::Buffer& buffer, GLuint primitives, GLuint corners) {
    const std::size_t floats = std::size_t{primitives} * corners * kPositionFloats;
    if (floats == 0) return 0;
    std::vector<float> values(floats);
    buffer.read(0, std::as_writable_bytes(std::span(values)));
    std::uint64_t lost = 0;
    for (std::size_t at = 0; at < floats; at += corners * kPositionFloats)
        if (!std::all_of(values.data() + at, values.data() + at + corners * kPositionFloats,
                         [](float each) { return std::isfinite(each); }))
            ++lost;
    return lost;
}

}  // namespace

std::vector<LostPrimitives> PositionSearch::search(SceneRenderer& renderer, double time, Stats& stats) {
    std::vector<LostPrimitives> found;
    std::set<const plan::PlannedDraw*> seen;
    FrameDrawer& drawer = renderer.drawer();
    drawer.setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
        // A picture of several tiles draws it once per tile.
        if (!begins || !seen.insert(&draw).second) return;
        if (std::optional<LostPrimitives> lost = look(drawer, draw)) found.push_back(std::move(*lost));
    });
    const Result<image::Image> drawn = renderer.draw(time, stats);
    drawer.setDrawHook({});
    return drawn ? std::move(found) : std::vector<LostPrimitives>();
}

/// The program without its fragment stage, which captures gl_Position; null if it does not link.
const gpu::Program* PositionSearch::programFor(const BuiltProgram& built) {
    const auto [known, isNew] = programs_.try_emplace(&built);
    if (isNew) {
        std::vector<glsl::TranslatedStage> stages = built.interface.facts.stages;
        std::erase_if(stages, [](const auto& each) { return each.stage == glsl::Stage::fragment; });
        known->second = capturingProgram(*capabilities_, built, stages, {"gl_Position"});
    }
    return known->second ? &*known->second : nullptr;
}

std::optional<LostPrimitives> PositionSearch::look(FrameDrawer& drawer, const plan::PlannedDraw& draw) {
    const BuiltProgram* built = drawer.programOf(draw);
    const gpu::Program* program = built ? programFor(*built) : nullptr;
    if (!program) return std::nullopt;
    const Output output = outputOf(built->interface.facts, draw.submission.topology);
    program->use();
    copyUniforms(*built, *program, gpu::reflect(*program));
    glEnable(GL_RASTERIZER_DISCARD);
    const GLuint all = counted(GL_PRIMITIVES_GENERATED, [&] { drawer.submit(draw); });
    const GLuint most = std::min(all, kMostVertices / output.corners);
    std::uint64_t lost = 0;
    const Result<gpu::Buffer> buffer = gpu::Buffer::create(
        std::max<std::size_t>(1, std::size_t{most} * output.corners) * kPositionFloats * sizeof(float),
        GL_STREAM_READ);
    if (buffer) {
        buffer->bindBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0);
        const GLuint written = counted(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, [&] {
            glBeginTransformFeedback(output.mode);
            drawer.submit(draw);
            glEndTransformFeedback();
        });
        lost = countLost(*buffer, std::min(written, most), output.corners);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    }
    glDisable(GL_RASTERIZER_DISCARD);
    built->program->use();
    if (lost == 0) return std::nullopt;
    return LostPrimitives{&draw, output.kind, lost, all};
}

// ---- Pictures

namespace {

constexpr std::size_t kMostNamed = 8;

/// True for each pixel with a component that is not finite; empty if there is none.
std::vector<bool> brokenPixels(const image::Image& picture) {
    std::vector<bool> broken;
    const auto components = static_cast<std::size_t>(picture.components);
    const std::size_t pixels =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    for (std::size_t i = 0; i < pixels * components; ++i) {
        float value = 0;
        std::memcpy(&value, picture.data.data() + i * sizeof value, sizeof value);
        if (std::isfinite(value)) continue;
        if (broken.empty()) broken.resize(pixels);
        broken[i / components] = true;
    }
    return broken;
}

/// One colour of one pass's target, and the range [first, end) of the draws into it, counted over all passes.
struct Searched {
    std::size_t pass = 0;
    int color = 0;
    std::size_t first = 0, end = 0;
};

struct Found {
    const plan::PlannedDraw* draw = nullptr;
    std::size_t pixels = 0;
    std::size_t x = 0, y = 0;       ///< of the first one, from the top left
    scene::TextureIndex texture{};  ///< that was drawn into; none: the window
};

class Search {
  public:
    Search(SceneRenderer& renderer, double time) : renderer_(renderer), time_(time) {
        renderer.plan().visitDraws(
            [&](const plan::PlannedDraw& draw, const auto&...) { draws_.push_back(&draw); });
    }

    std::vector<Found> run() {
        for (const Searched& searched : targets()) {
            const std::vector<bool> after = brokenAfter(searched.end, searched);
            if (after.empty()) continue;
            halve(searched, searched.first, brokenAfter(searched.first, searched), searched.end, after);
        }
        return std::move(found_);
    }

  private:
    /// The window and the textures that can hold NaN.
    [[nodiscard]] std::vector<Searched> targets() const {
        std::vector<Searched> all;
        const plan::FramePlan& plan = renderer_.plan();
        std::size_t first = 0;
        for (std::size_t pass = 0; pass < plan.passes.size(); ++pass) {
            const auto& steps = plan.passes[pass].steps;
            const std::size_t end =
                first + static_cast<std::size_t>(std::ranges::count_if(steps, [](const auto& step) {
                    return std::holds_alternative<plan::PlannedDraw>(step);
                }));
            const scene::Pass& drawn = passOf(pass);
            if (first < end && drawn.isWindow) all.push_back({pass, 0, first, end});
            for (std::size_t i = 0; first < end && i < drawn.targets.size(); ++i)
                if (isFloat(drawn.targets[i])) all.push_back({pass, static_cast<int>(i), first, end});
            first = end;
        }
        return all;
    }

    [[nodiscard]] const scene::Pass& passOf(std::size_t pass) const {
        const plan::FramePlan& plan = renderer_.plan();
        return plan.passOf(plan.passes[pass]);
    }

    [[nodiscard]] bool isFloat(scene::TextureIndex texture) const {
        const auto* made = std::get_if<scene::EmptySource>(&renderer_.scene().textures[texture].source);
        return made != nullptr && base::isFloat(made->format);
    }

    std::vector<bool> brokenAfter(std::size_t draws, const Searched& where) {
        Stats stats;
        const Result<image::Image> content =
            renderer_.drawFirst(draws, where.pass, where.color, time_, stats);
        return content ? brokenPixels(*content) : std::vector<bool>();
    }

    /// Finds every draw from low to high after which a pixel is not finite that was finite before it.
    void halve(const Searched& where, std::size_t low, const std::vector<bool>& before, std::size_t high,
               const std::vector<bool>& after) {
        Found added;
        for (std::size_t i = 0; i < after.size(); ++i) {
            if (!after[i] || (!before.empty() && before[i])) continue;
            if (added.pixels++ == 0) {
                const auto width = static_cast<std::size_t>(widthOf(where));
                added.x = i % width;
                added.y = i / width;
            }
        }
        if (added.pixels == 0) return;
        if (high - low > 1) {
            const std::size_t middle = low + (high - low) / 2;
            const std::vector<bool> between = brokenAfter(middle, where);
            halve(where, low, before, middle, between);
            halve(where, middle, between, high, after);
            return;
        }
        const std::vector<scene::TextureIndex>& textures = passOf(where.pass).targets;
        added.draw = draws_[low];
        if (!textures.empty()) added.texture = textures[static_cast<std::size_t>(where.color)];
        found_.push_back(added);
    }

    [[nodiscard]] int widthOf(const Searched& where) const {
        const scene::Pass& drawn = passOf(where.pass);
        if (drawn.targets.empty()) return renderer_.width();
        return scene::targetSize(renderer_.scene(), drawn).value()[0];
    }

    SceneRenderer& renderer_;
    double time_;
    std::vector<const plan::PlannedDraw*> draws_;
    std::vector<Found> found_;
};

/// "Sphere draws NaN or infinity into 12 pixels of texture unit 6, the first at 3, 4".
std::string describeFound(const Found& found, const scene::Draw& draw, const scene::Scene& scene,
                          const std::map<scene::TextureIndex, int>& lines) {
    std::string text =
        fmt::format("{} leaves NaN or infinity in {}", draw.word, base::counted(found.pixels, "pixel"));
    if (found.texture) {
        const scene::Texture& texture = scene.textures[found.texture];
        text += texture.name.empty() ? fmt::format(" of the texture of unit {}", texture.unit)
                                     : fmt::format(" of the texture '{}'", texture.name);
    }
    text += fmt::format(", the first at {}, {}", found.x, found.y);
    for (const plan::TextureUse& use : found.draw->textures)
        if (const auto line = lines.find(use.view.texture); line != lines.end())
            return text + fmt::format("; it samples what line {} drew", line->second);
    return text;
}

std::string describeLost(const LostPrimitives& lost, const scene::Draw& draw) {
    return fmt::format("{}: gl_Position is NaN or infinite in {} of {} {}, which {} lost", draw.word,
                       base::groupedText(lost.lost), base::groupedText(lost.all), lost.kind,
                       lost.lost == 1 ? "is" : "are");
}

/// The last message that is shown counts those that are not.
std::string countingRest(std::string text, std::size_t index, std::size_t count) {
    if (index + 1 == kMostNamed && count > kMostNamed)
        text += fmt::format("; {} more draws do so", count - kMostNamed);
    return text;
}

}  // namespace

Result<NanSearch> NanSearch::load(gpu::Context& context, const std::filesystem::path& scene,
                                  const RenderOptions& options) {
    RenderOptions floats = options;
    floats.floatPixels = true;
    floats.checkNan = true;
    auto stats = std::make_unique<Stats>();
    Result<SceneRenderer> loaded = SceneRenderer::load(context, scene, floats, *stats);
    if (!loaded) return std::move(loaded.diagnostics);
    return NanSearch(context, std::move(stats), std::move(*loaded), options.strict);
}

Diagnostics NanSearch::at(double time) {
    const std::vector<Found> found = Search(renderer_, time).run();
    Diagnostics diagnostics;
    std::map<scene::TextureIndex, int> lines;  // texture -> scene line of the first draw that broke it
    for (std::size_t i = 0; i < found.size(); ++i) {
        const scene::Draw& draw = renderer_.plan().drawOf(*found[i].draw);
        const Place& place = draw.place;
        const std::string text = describeFound(found[i], draw, renderer_.scene(), lines);
        if (found[i].texture) lines.emplace(found[i].texture, place.line);
        diagnostics.push_back(diagnose("draw-W06", countingRest(text, i, found.size()), place));
        if (i + 1 == kMostNamed) break;
    }
    const std::vector<LostPrimitives> lost = positions_.search(renderer_, time, *stats_);
    for (std::size_t i = 0; i < std::min(lost.size(), kMostNamed); ++i) {
        const scene::Draw& draw = renderer_.plan().drawOf(*lost[i].draw);
        diagnostics.push_back(
            diagnose("draw-W09", countingRest(describeLost(lost[i], draw), i, lost.size()), draw.place));
    }
    applyStrict(diagnostics, strict_);
    return diagnostics;
}

}  // namespace glibra::render
