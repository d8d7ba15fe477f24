// Reports what is refused, and what to write instead (language, 7.2, 7.10 and 7.12).

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "glsl/read/extensions.h"
#include "glsl/read/words.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

struct Refusal {
    std::string_view word;
    std::string_view text;
};
constexpr std::array kRefusals = std::to_array<Refusal>({
    {"gl_LayerIn",
     "gl_LayerIn cannot be emulated: geometry shaders have no such input; pass the layer on in a varying of "
     "your own"},
    {"gl_ClipVertexIn",
     "gl_ClipVertexIn cannot be emulated: geometry shaders have no such input; use gl_in[i].gl_Position"},
    {"sampler3DRect", "sampler3DRect does not exist in any GLSL version; use sampler3D"},
});

constexpr std::array<std::string_view, 7> kComputeOnly = {
    "gl_GlobalInvocationID", "gl_LocalInvocationID",    "gl_WorkGroupID",      "gl_NumWorkGroups",
    "gl_WorkGroupSize",      "gl_LocalInvocationIndex", "gl_LocalGroupSizeARB"};

/// Names that are newer than 4.10, the lowest target.
struct Feature {
    std::string_view word;
    int version;
    std::string_view extension;
};
constexpr std::array kFeatures = std::to_array<Feature>({
    {"imageLoad", 420, "GL_ARB_shader_image_load_store"},
    {"imageStore", 420, "GL_ARB_shader_image_load_store"},
    {"memoryBarrier", 420, "GL_ARB_shader_image_load_store"},
    {"packSnorm2x16", 420, "GL_ARB_shading_language_packing"},
    {"unpackSnorm2x16", 420, "GL_ARB_shading_language_packing"},
    {"packHalf2x16", 420, "GL_ARB_shading_language_packing"},
    {"unpackHalf2x16", 420, "GL_ARB_shading_language_packing"},
    {"imageSize", 430, "GL_ARB_shader_image_size"},
    {"textureQueryLevels", 430, "GL_ARB_texture_query_levels"},
    {"textureSamples", 450, "GL_ARB_shader_texture_image_samples"},
    {"dFdxFine", 450, "GL_ARB_derivative_control"},
    {"dFdyFine", 450, "GL_ARB_derivative_control"},
    {"fwidthFine", 450, "GL_ARB_derivative_control"},
    {"dFdxCoarse", 450, "GL_ARB_derivative_control"},
    {"dFdyCoarse", 450, "GL_ARB_derivative_control"},
    {"fwidthCoarse", 450, "GL_ARB_derivative_control"},
    {"gl_CullDistance", 450, "GL_ARB_cull_distance"},
    {"gl_HelperInvocation", 450, ""},
    {"gl_BaseVertex", 460, "GL_ARB_shader_draw_parameters"},
    {"gl_BaseInstance", 460, "GL_ARB_shader_draw_parameters"},
    {"gl_DrawID", 460, "GL_ARB_shader_draw_parameters"},
    {"anyInvocation", 460, "GL_ARB_shader_group_vote"},
    {"allInvocations", 460, "GL_ARB_shader_group_vote"},
    {"allInvocationsEqual", 460, "GL_ARB_shader_group_vote"},
    {"atomicCounterAdd", 460, "GL_ARB_shader_atomic_counter_ops"},
    {"atomicCounterSubtract", 460, "GL_ARB_shader_atomic_counter_ops"},
    {"atomicCounterMin", 460, "GL_ARB_shader_atomic_counter_ops"},
    {"atomicCounterMax", 460, "GL_ARB_shader_atomic_counter_ops"},
    {"atomicCounterAnd", 460, "GL_ARB_shader_atomic_counter_ops"},
    {"atomicCounterOr", 460, "GL_ARB_shader_atomic_counter_ops"},
    {"atomicCounterXor", 460, "GL_ARB_shader_atomic_counter_ops"},
    {"atomicCounterExchange", 460, "GL_ARB_shader_atomic_counter_ops"},
    {"atomicCounterCompSwap", 460, "GL_ARB_shader_atomic_counter_ops"},
});

class Refuser {
  public:
    Refuser(Unit& unit, Report& report) : unit_(unit), report_(report) {}

    void run() {
        for (std::uint32_t i = 0; i < unit_.view.size(); ++i)
            if (unit_.view[i].kind == TokenKind::word) word(i);
        for (const Token& token : unit_.tokens)
            if (token.kind == TokenKind::word && token.text.starts_with("glibra_") &&
                !token.text.starts_with(kOwnOverload))
                report_.reportOnce(unit_.path + std::string(token.text), "glsl-E05",
                                   "names beginning with 'glibra_' are reserved",
                                   {unit_.files[token.file], token.line, token.column});
        for (const Declaration& each : unit_.syntax.declarations) declaration(each);
        longExpressions();
        for (const LocalVariable& each : unit_.bodies.locals)
            if (each.type.arrayDepth > 1)
                feature(each.name, "an array of arrays", 430, "GL_ARB_arrays_of_arrays");
    }

  private:
    [[nodiscard]] const Target& target() const { return unit_.request->target; }

    void error(std::uint32_t at, const std::string& text) {
        report_.reportOnce(unit_.path + text, "glsl-E03", text, unit_.place(at));
    }

    void computeOnly(std::uint32_t at, const std::string& what) {
        error(at, what + " only exists in a compute stage; name this file with 'Compute'");
    }

    /// Reports glsl-E11 for an expression at which drivers, which read it recursively, run out of stack.
    void longExpressions() {
        constexpr std::size_t kMost = 5000;
        std::vector<std::size_t> operators{0};  // of the expression in each open bracket
        std::size_t all = 0;
        for (std::uint32_t i = 0; i < unit_.view.size(); ++i) {
            const std::string_view text = unit_.text(i);
            if (text == "(" || text == "[" || text == "{") {
                operators.push_back(0);
                ++all;
            } else if ((text == ")" || text == "]" || text == "}") && operators.size() > 1) {
                all -= operators.back() + 1;
                operators.pop_back();
            } else if (text == ";" || text == ",") {
                all -= std::exchange(operators.back(), 0);
            } else if (std::string_view("+-*/%&|^<>=!?~.").find(text.front()) != std::string_view::npos) {
                ++operators.back();
                ++all;
            }
            if (all > kMost)
                return report_.report("glsl-E11",
                                      "more than 5,000 operators and brackets inside each other; give parts "
                                      "of expressions names",
                                      unit_.place(i));
        }
    }

    void word(std::uint32_t at) {
        const std::string_view text = unit_.text(at);
        if (unit_.bodies.roles[at] == WordRole::local || unit_.bodies.roles[at] == WordRole::localDeclaration)
            return;
        for (const Refusal& each : kRefusals)
            if (each.word == text && !unit_.view[at].isName) error(at, std::string(each.text));
        if (unit_.isDeclared(text)) return;
        if (unit_.stage != Stage::compute && std::ranges::find(kComputeOnly, text) != kComputeOnly.end())
            computeOnly(at, std::string(text));
        for (const Feature& each : kFeatures)
            // The extensions of 4.60 spell them with ARB.
            if (each.word == text && feature(at, text, each.version, each.extension) && each.version == 460)
                unit_.renames[std::string(text)] = std::string(text) + "ARB";
        if (const Extension* const only = extensionThatAlone(text, unit_.enabled)) alone(at, *only);
        const bool layer = text == "gl_Layer" || text == "gl_ViewportIndex";
        if (layer && unit_.stage == Stage::fragment) feature(at, text, 430, "GL_ARB_fragment_layer_viewport");
        if (isImageTypeWord(text) && unit_.dialect.version >= 130)
            feature(at, text, 420, "GL_ARB_shader_image_load_store");
    }

    /// Enables the extension if the driver has it.
    bool enable(std::string_view extension) {
        if (extension.empty() || !target().hasExtension || !target().hasExtension(extension)) return false;
        unit_.passExtension(extension, "enable");
        return true;
    }

    /// A word that no core version has, but an extension that the source enables.
    void alone(std::uint32_t at, const Extension& extension) {
        const std::string text(unit_.text(at));
        if (enable(extension.name)) return;
        const bool is64 = text.find("64") != std::string::npos || text.find("2x32") != std::string::npos;
        if (is64 && enable("GL_ARB_gpu_shader_int64")) return;
        error(at, text + " of " + std::string(extension.name) +
                      " is in no version of GLSL, and this driver does not have that extension");
    }

    /// Reports a name that is newer than the target; true if an extension of the driver has it.
    bool feature(std::uint32_t at, std::string_view text, int version, std::string_view extension) {
        if (target().version >= version) return false;
        if (enable(extension)) return true;
        error(at, std::string(text) + " needs GLSL " + dotted(version) + ", this driver has " +
                      dotted(target().version));
        return false;
    }

    void layoutItem(const LayoutItem& item) {
        const std::uint32_t at = item.tokens.first;
        if (item.name == "early_fragment_tests")
            feature(at, item.name, 420, "GL_ARB_shader_image_load_store");
        if (item.name == "component" || item.name == "align" || item.name.starts_with("xfb_"))
            feature(at, "layout(" + item.name + ")", 440, "GL_ARB_enhanced_layouts");
    }

    void declaration(const Declaration& each) {
        if (each.kind == DeclarationKind::block && each.qualifiers.storage == Storage::buffer)
            storage(each.name, "buffer block", "storage buffers", 430, "GL_ARB_shader_storage_buffer_object");
        if (each.kind == DeclarationKind::variable && each.type.name == "atomic_uint" &&
            !each.declarators.empty())
            storage(each.declarators[0].name, "atomic counter", "counters", 420,
                    "GL_ARB_shader_atomic_counters");
        for (const LayoutItem& item : each.qualifiers.layout) layoutItem(item);
        for (const Declarator& name : each.declarators)
            if (each.type.dimensions.size() + name.dimensions.size() > 1)
                feature(name.name, "an array of arrays", 430, "GL_ARB_arrays_of_arrays");
        if (each.kind == DeclarationKind::layoutOnly && unit_.stage != Stage::compute)
            for (const LayoutItem& item : each.qualifiers.layout)
                if (item.name.starts_with("local_size_"))
                    computeOnly(item.tokens.first, "layout(local_size)");
    }

    void storage(std::uint32_t name, std::string_view what, std::string_view kind, int version,
                 std::string_view extension) {
        const std::string text = std::string(what) + " '" + std::string(unit_.text(name)) + "'";
        if (unit_.request->acceptsStorage || unit_.stage == Stage::compute) {
            feature(name, text, version, extension);
            return;
        }
        report_.report("glsl-E09", text + ": scenes have no " + std::string(kind), unit_.place(name));
    }

    Unit& unit_;
    Report& report_;
};

}  // namespace

void refuse(ProgramUnits& program) {
    for (Unit& unit : program.units) Refuser(unit, program.report).run();
}

}  // namespace glibra::glsl
