#include "view/debug_view/pixel_probe.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "glsl/facts/stage_variables.h"
#include "gpu/object/uniform.h"
#include "view/debug_view/bound_target.h"
#include "view/debug_view/debug_program.h"
#include "view/scene/window_target.h"

namespace glibra::view {
namespace {

constexpr int kMostElements = 16;
constexpr int kNumbersAtOnce = 4;
using Four = std::array<float, kNumbersAtOnce>;
constexpr std::string_view kChoice = "glibra_debugChoice";
constexpr int kOnes = -1;  ///< the choice that writes 1
constexpr std::string_view kDeclarations =
    "layout(location = 7) out vec4 glibra_debugNumber;\nuniform int glibra_debugChoice;\n";

/// A value that the fragment stage is asked for, with GLSL for each of its numbers.
struct Asked {
    ProbedValue value;
    std::vector<std::string> numbers;
    const char* whyNot = "";  ///< why no program that reads it links
    bool isOutput = false;
    [[nodiscard]] int passes() const {
        return (static_cast<int>(numbers.size()) + kNumbersAtOnce - 1) / kNumbersAtOnce;
    }
};

Asked askedOf(const glsl::StageVariable& variable) {
    Asked asked;
    asked.value.name = variable.name;
    asked.value.type = variable.type;
    if (variable.elements > 0) asked.value.type += fmt::format("[{}]", variable.elements);
    for (int element = 0; element < std::clamp(variable.elements, 1, kMostElements); ++element)
        for (int component = 0; component < variable.components(); ++component)
            asked.numbers.push_back(variable.number(element, component));
    return asked;
}

/// GLSL that writes four of the numbers, or ones, chosen by a uniform.
std::string choiceOf(std::span<const Asked> all) {
    std::string text =
        fmt::format("    if (glibra_debugChoice == {}) glibra_debugNumber = vec4(1.);\n", kOnes);
    int pass = 0;
    for (const Asked& each : all)
        for (int i = 0; i < each.passes(); ++i, ++pass) {
            std::string numbers;
            for (int k = kNumbersAtOnce * i; k < kNumbersAtOnce * (i + 1); ++k)
                numbers += (numbers.empty() ? "" : ", ") + (static_cast<std::size_t>(k) < each.numbers.size()
                                                                ? each.numbers[static_cast<std::size_t>(k)]
                                                                : std::string("0."));
            text += fmt::format("    if (glibra_debugChoice == {}) glibra_debugNumber = vec4({});\n", pass,
                                numbers);
        }
    return text;
}

/// The values in the program in use of the uniforms that `built` reads.
std::vector<ProbedValue> uniformsOf(const render::BuiltProgram& built, const render::BuiltProgram& used) {
    std::vector<ProbedValue> values;
    for (const base::ActiveUniform& own : built.interface.uniforms) {
        if (own.block >= 0 || own.location < 0 || own.type.isOpaque()) continue;
        for (const base::ActiveUniform& each : used.interface.uniforms) {
            if (each.emittedName != own.emittedName) continue;
            ProbedValue value;
            value.name = own.name;
            value.type = own.type.word + (own.isArray ? fmt::format("[{}]", own.arraySize) : "");
            for (int i = 0; i < std::min(std::max(1, each.arraySize), kMostElements); ++i) {
                const std::vector<double> element = gpu::getUniform(*used.program, each, i);
                value.numbers.insert(value.numbers.end(), element.begin(), element.end());
            }
            values.push_back(std::move(value));
        }
    }
    return values;
}

/// Draws one pixel of a frame again and again.
class Probe {
  public:
    Probe(gpu::Context& context, render::LiveScene& scene, const gpu::Target& target, double time, int x,
          int row)
        : context_(context), scene_(scene), target_(target), time_(time), x_(x), row_(row) {}

    /// Probes that draw, whose targets have that size, in place of the visible one.
    void run(ProbedPixel& result, scene::StepIndex step, const gpu::TextureSize& size, int layer) {
        size_ = size;
        layer_ = layerOf(scene_, scene_.scene().frame.passes.at(step.pass), layer);
        isGiven_ = true;
        for (const plan::PlannedPass& pass : scene_.plan().passes)
            for (const auto& each : pass.steps)
                if (const auto* draw = std::get_if<plan::PlannedDraw>(&each); draw && draw->step == step)
                    if (!begin(*draw, result)) return;
        if (built_ == nullptr) return;
        ask(result);
        drawFrame(true);
        result.isDrawn = isThere_;
        result.isHidden = isHidden_;
    }

    void run(ProbedPixel& result) {
        const plan::PlannedDraw* found = visibleDraw(scene_, target_, time_, x_, row_);
        target_.readable().bindForReading();
        if (found == nullptr || !begin(*found, result)) return;
        float depth = 1;
        glReadPixels(x_, row_, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
        result.depth = static_cast<double>(depth);
        ask(result);
    }

  private:
    bool begin(const plan::PlannedDraw& found, ProbedPixel& result) {
        step_ = found.step;
        const scene::Draw& draw = scene_.plan().drawOf(found);
        built_ = scene_.drawer().programOf(found);
        if (!built_) return false;
        result.isDrawn = true;
        result.draw = draw.id;
        result.word = draw.word;
        if (!built_->interface.isBuiltin) result.program = built_->interface.facts.name;
        return true;
    }

    void drawFrame(bool withTextures) {
        const int width = target_.width(), height = target_.height();
        render::FrameDrawer& drawer = scene_.drawer();
        if (!withTextures) drawer.limitTo(gpu::PixelRectangle{x_, row_, 1, 1});
        render::Frame frame{scene_.view(), width, height, {0, 0, width, height}, time_};
        frame.texturePasses = withTextures;
        drawer.draw(target_, frame);
        drawer.setDrawHook({});
        drawer.limitTo({});
        target_.readable().bindForReading();
    }

    /// The four numbers of a pass, from a frame in which the found draw also writes them.
    Four numbersOf(int pass, std::vector<ProbedValue>* uniforms) {
        scene_.drawer().setDrawHook([&](const plan::PlannedDraw& draw, bool isWindow, bool begins) {
            if (!isWindow || draw.step != step_) return;
            writeOnly(begins ? kDebugOutput : 0);
            if (!begins) return;
            const render::BuiltProgram& used = *scene_.drawer().programOf(draw);
            if (uniforms) *uniforms = uniformsOf(*built_, used);
            choose(used, pass);
            glDisable(GL_BLEND);
            glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        });
        drawFrame(false);
        Four numbers{};
        glReadPixels(x_, row_, 1, 1, GL_RGBA, GL_FLOAT, numbers.data());
        return numbers;
    }

    static void choose(const render::BuiltProgram& used, int pass) {
        const double choice = pass;
        for (const base::ActiveUniform& each : used.interface.uniforms)
            if (each.emittedName == kChoice) gpu::setUniform(*used.program, each, {&choice, 1});
    }

    /// Draws the given draw again and again at its place in the frame, with the depth that is there then.
    void drawGiven(const plan::PlannedDraw& draw, int passes, std::vector<ProbedValue>* uniforms,
                   std::vector<Four>& all) {
        const scene::Pass& pass = scene_.scene().frame.passes.at(draw.step.pass);
        const gpu::Capabilities& capabilities = context_.capabilities();
        const render::BuiltProgram& used = *scene_.drawer().programOf(draw);
        const gpu::PixelRectangle pixel{x_, row_, 1, 1};
        const KeptState kept;
        const auto beside = BesideTarget::make(capabilities, scene_, pass, size_, layer_ ? layer_->layer : 0);
        if (!beside) return;
        if (uniforms) *uniforms = uniformsOf(*built_, used);
        // The draw may change the depth of the pixel in every layer.
        std::vector<std::pair<std::optional<LayerOfPass>, float>> before;
        for (int i = 0; i < layersOf(scene_, pass); ++i) {
            const auto layer = layerOf(scene_, pass, i);
            const BoundPart depthPart{FrameTarget::Kind::depth, 0, {}, size_.width, size_.height, layer};
            if (const auto depth = readBound(capabilities, depthPart, 0, pixel);
                depth && !depth->values.empty())
                before.emplace_back(layer, static_cast<float>(depth->values.front()));
        }
        beside->bind(kDebugOutput);
        glEnable(GL_SCISSOR_TEST);
        glScissor(x_, row_, 1, 1);
        glDisable(GL_BLEND);
        glStencilMask(0);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        const auto submit = [&](int number) {
            choose(used, number);
            scene_.drawer().submit(draw, true);
        };
        const auto restoreDepth = [&] {
            GLboolean writes = GL_TRUE;
            glGetBooleanv(GL_DEPTH_WRITEMASK, &writes);
            glDepthMask(GL_TRUE);
            for (const auto& [layer, depth] : before) {
                const BoundLayer bound(layer);
                glClearBufferfv(GL_DEPTH, 0, &depth);
            }
            glDepthMask(writes);
        };
        const auto hasFragment = [&] {  // A query would count in all layers.
            beside->clear();
            beside->bind(kDebugOutput);
            submit(kOnes);
            restoreDepth();
            const render::Content ones = beside->read(capabilities, pixel);
            beside->bind(kDebugOutput);
            return !ones.values.empty() && ones.values.front() > 0;
        };
        isThere_ = hasFragment();
        if (!isThere_) {
            glDisable(GL_DEPTH_TEST);
            glDisable(GL_STENCIL_TEST);
            isThere_ = isHidden_ = hasFragment();
        }
        for (int number = 0; number < passes && isThere_; ++number) {
            submit(number);
            restoreDepth();
            const render::Content four = beside->read(capabilities, pixel);
            beside->bind(kDebugOutput);
            if (four.values.size() < kNumbersAtOnce) continue;
            for (std::size_t i = 0; i < kNumbersAtOnce; ++i)
                all[static_cast<std::size_t>(number)][i] = static_cast<float>(four.values[i]);
        }
    }

    std::vector<Four> numbersOfGiven(int passes, std::vector<ProbedValue>* uniforms) {
        std::vector<Four> all(static_cast<std::size_t>(passes));
        scene_.drawer().setDrawHook([&](const plan::PlannedDraw& draw, bool, bool begins) {
            if (begins && draw.step == step_) drawGiven(draw, passes, uniforms, all);
        });
        drawFrame(true);
        return all;
    }

    /// Reads the values with one program if it links, else with several.
    void read(std::span<Asked> all, std::vector<ProbedValue>& uniforms) {
        if (all.empty()) return;
        const std::string choice = choiceOf(all);
        // The stage may write the depth under a condition, so it gets its value first.
        const glsl::TranslatedStage* fragment = stageOf(*built_, glsl::Stage::fragment);
        const char* before = fragment != nullptr && fragment->facts.mayWriteDepth
                                 ? "    gl_FragDepth = gl_FragCoord.z;\n"
                                 : "";
        if (!scene_.observe(*built_, {kDeclarations, before, choice})) {
            if (all.size() == 1) {
                all.front().value.why = all.front().whyNot;
                return;
            }
            read(all.first(all.size() / 2), uniforms);
            return read(all.subspan(all.size() / 2), uniforms);
        }
        int passes = 0;
        for (const Asked& each : all) passes += each.passes();
        std::vector<Four> given;
        if (isGiven_)
            given = numbersOfGiven(passes, uniforms.empty() ? &uniforms : nullptr);
        else
            drawTexturesIfNew();
        int pass = 0;
        for (Asked& each : all)
            for (int i = 0; i < each.passes(); ++i, ++pass) {
                const auto four = isGiven_ ? given[static_cast<std::size_t>(pass)]
                                           : numbersOf(pass, uniforms.empty() ? &uniforms : nullptr);
                const std::size_t left = each.numbers.size() - each.value.numbers.size();
                each.value.numbers.insert(
                    each.value.numbers.end(), four.begin(),
                    four.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(kNumbersAtOnce, left)));
            }
    }

    /// The plan may need passes that the picture does not, or use the memory of textures otherwise.
    void drawTexturesIfNew() {
        const Textures now = texturesOf(scene_.plan());
        if (std::exchange(textures_, now) != now) drawFrame(true);
    }

    void ask(ProbedPixel& result) {
        // gl_FragCoord and gl_FrontFacing need no stage before.
        constexpr const char* kNotRead = "the driver cannot link a program that reads it";
        std::vector<Asked> all{
            {{"gl_FragCoord", "vec4", {}, {}}, {}, kNotRead},
            {{"gl_FrontFacing", "bool", {}, {}}, {"(gl_FrontFacing ? 1. : 0.)"}, kNotRead}};
        for (const char* each : {"x", "y", "z", "w"})
            all[0].numbers.push_back(std::string("gl_FragCoord.") + each);
        const std::size_t builtins = all.size();
        if (const glsl::TranslatedStage* fragment = stageOf(*built_, glsl::Stage::fragment)) {
            for (const glsl::StageVariable& variable :
                 glsl::stageVariables(*fragment, built_->interface.facts.userNames)) {
                all.push_back(askedOf(variable));
                all.back().isOutput = variable.isOutput;
                all.back().whyNot = variable.isOutput ? kNotRead : "the stage before does not write it";
            }
            if (fragment->facts.mayWriteDepth)
                all.push_back({{"gl_FragDepth", "float", {}, {}}, {"gl_FragDepth"}, kNotRead, true});
        }
        textures_ = texturesOf(scene_.plan());
        const Textures before = textures_;
        read(all, result.uniforms);
        scene_.stopObserving();
        if (textures_ != before) drawFrame(true);
        // Of a given draw, the depth buffer may have another's.
        const ProbedValue &place = all.front().value, &written = all.back().value;
        if (isGiven_ && place.numbers.size() > 2) result.depth = place.numbers[2];
        if (isGiven_ && written.name == "gl_FragDepth" && !written.numbers.empty())
            result.depth = written.numbers.front();
        if (!all[1].value.numbers.empty()) result.isFront = all[1].value.numbers.front() > .5;
        std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(builtins), all.end());
        for (Asked& each : all)
            (each.isOutput ? result.outputs : result.inputs).push_back(std::move(each.value));
    }

    /// What of a plan decides the content of textures.
    using Textures = std::tuple<std::size_t, std::size_t, std::map<scene::TextureIndex, scene::TextureIndex>>;
    static Textures texturesOf(const plan::FramePlan& plan) {
        return {plan.passes.size(), plan.dispatches.size(), plan.sharing};
    }

    gpu::Context& context_;
    render::LiveScene& scene_;
    const gpu::Target& target_;
    double time_;
    int x_, row_;
    scene::StepIndex step_;  ///< of the found draw
    const render::BuiltProgram* built_ = nullptr;
    Textures textures_;                        ///< as they were drawn last
    bool isGiven_ = false;                     ///< the draw
    bool isThere_ = false, isHidden_ = false;  ///< its fragment
    gpu::TextureSize size_;                    ///< of the targets of a given draw
    std::optional<LayerOfPass> layer_;         ///< of them
};

// Probed values as text.

/// "mat4", "mat3x2" (3 columns, 2 rows), and arrays of them; 0: it is no matrix.
std::size_t rowsOfMatrix(std::string_view type) {
    if (type.starts_with('d')) type.remove_prefix(1);
    if (!type.starts_with("mat") || type.size() < 4) return 0;
    const char rows = type.size() > 5 && type[4] == 'x' ? type[5] : type[3];
    return rows >= '2' && rows <= '4' ? static_cast<std::size_t>(rows - '0') : 0;
}

/// The rows as lines, with the numbers of a column below each other; an empty line between matrices.
std::string matrixText(const ProbedValue& value, std::size_t rows) {
    const auto columns = static_cast<std::size_t>(value.type[value.type.front() == 'd' ? 4 : 3] - '0');
    std::vector<std::string> texts;
    std::size_t widest = 0;
    for (const double each : value.numbers) {
        texts.push_back(fmt::format("{:.6g}", each == 0 ? 0 : each));  // no "-0"
        widest = std::max(widest, texts.back().size());
    }
    std::string text;
    for (std::size_t first = 0; first + rows * columns <= texts.size(); first += rows * columns) {
        if (first > 0) text += "\n";
        for (std::size_t row = 0; row < rows; ++row) {
            if (!text.empty()) text += "\n";
            for (std::size_t column = 0; column < columns; ++column)
                text += fmt::format("{}{:>{}}", column > 0 ? "  " : "", texts[first + column * rows + row],
                                    widest);
        }
    }
    return text;
}

}  // namespace

ProbedPixel probePixel(gpu::Context& context, render::LiveScene& scene, int width, int height, double time,
                       int x, int y) {
    ProbedPixel result;
    result.x = x;
    result.y = y;
    result.height = height;
    if (x < 0 || y < 0 || x >= width || y >= height) return result;
    const Result<gpu::Target> target =
        windowTarget(context.capabilities(), scene.scene(), width, height, gpu::TexelFormat::rgba32f);
    if (target) Probe(context, scene, *target, time, x, height - 1 - y).run(result);
    return result;
}

ProbedPixel probeDraw(gpu::Context& context, render::LiveScene& scene, scene::StepIndex step, int width,
                      int height, double time, const TargetPixel& pixel) {
    ProbedPixel result;
    const gpu::TextureSize size = sizeOf(scene, scene.scene().frame.passes.at(step.pass), width, height);
    result.x = pixel.x;
    result.y = size.height - 1 - pixel.y;
    result.height = size.height;
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.width || pixel.y >= size.height) return result;
    const Result<gpu::Target> target =
        windowTarget(context.capabilities(), scene.scene(), width, height, gpu::TexelFormat::rgba32f);
    if (target) Probe(context, scene, *target, time, pixel.x, pixel.y).run(result, step, size, pixel.layer);
    return result;
}

const ProbedValue* ProbedPixel::find(std::string_view name) const {
    for (const std::vector<ProbedValue>* list : {&outputs, &inputs, &uniforms})
        for (const ProbedValue& each : *list)
            if (each.name == name) return &each;
    return nullptr;
}

std::string numbersText(const ProbedValue& value) {
    if (value.numbers.empty()) return value.why;
    std::string text;
    if (value.type == "bool") return value.numbers.front() != 0 ? "true" : "false";
    if (const std::size_t rows = rowsOfMatrix(value.type); rows > 0) return matrixText(value, rows);
    for (const double each : value.numbers) text += fmt::format("{}{:.6g}", text.empty() ? "" : " ", each);
    return text;
}

}  // namespace glibra::view
