#include "glsl/es/stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "glsl/emit/emit.h"
#include "glsl/emit/log_line.h"
#include "glsl/es/additions.h"
#include "glsl/es/expressions.h"
#include "glsl/parse/variables.h"
#include "glsl/read/words.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

/// Functions and variables of the core profile that GLSL ES 3.00 lacks.
constexpr std::string_view kMissingNames =
    " textureGather textureGatherOffset textureGatherOffsets textureQueryLevels textureQueryLod "
    "textureSamples bitfieldExtract bitfieldInsert bitfieldReverse frexp ldexp "
    "uaddCarry usubBorrow umulExtended imulExtended packUnorm4x8 packSnorm4x8 unpackUnorm4x8 unpackSnorm4x8 "
    "packDouble2x32 unpackDouble2x32 interpolateAtCentroid interpolateAtSample interpolateAtOffset imageLoad "
    "imageStore imageSize atomicCounter atomicCounterIncrement atomicCounterDecrement memoryBarrier "
    "gl_PrimitiveID gl_SampleID gl_SamplePosition gl_SampleMask gl_SampleMaskIn gl_NumSamples gl_Layer "
    "gl_ViewportIndex gl_ClipDistance gl_CullDistance gl_HelperInvocation gl_BaseVertex gl_BaseInstance "
    "gl_DrawID gl_BaseVertexARB gl_BaseInstanceARB gl_DrawIDARB ";

/// The limits that it has.
constexpr std::string_view kLimits =
    " gl_MaxVertexAttribs gl_MaxVertexUniformVectors gl_MaxVertexOutputVectors gl_MaxFragmentInputVectors "
    "gl_MaxVertexTextureImageUnits gl_MaxCombinedTextureImageUnits gl_MaxTextureImageUnits "
    "gl_MaxFragmentUniformVectors gl_MaxDrawBuffers gl_MaxProgramTexelOffset ";

/// The samplers that GLSL ES 3.00 has, without the i and u of those of integers.
constexpr std::string_view kSamplers =
    " sampler2D sampler3D samplerCube sampler2DArray sampler2DShadow samplerCubeShadow sampler2DArrayShadow ";

/// What a name of the core profile is written as.
struct Renamed {
    std::string_view name, written;
};
constexpr std::array kRenamed = std::to_array<Renamed>({
    {"dFdxFine", "dFdx"},
    {"dFdyFine", "dFdy"},
    {"fwidthFine", "fwidth"},
    {"dFdxCoarse", "dFdx"},
    {"dFdyCoarse", "dFdy"},
    {"fwidthCoarse", "fwidth"},
});

/// The number of the loop that was ended first, in a fragment stage and in one before it.
constexpr const char *kCut = "glibra_cut", *kVertexCut = "glibra_vertexCut";

/// A function of the core profile in GLSL ES: `T` stands for each of the types.
struct Written {
    std::string_view name;
    std::string_view types;
    std::string_view text;
};
constexpr std::array kWritten = std::to_array<Written>({
    {"fma", "float vec2 vec3 vec4", "T glibra_fma(T a, T b, T c) { return a * b + c; }"},
    {"bitCount", "int uint",
     "int glibra_bitCount(T x) { int n = 0; for (int i = 0; i < 32; ++i) n += int(uint(x) >> i & 1u); return "
     "n; }"},
    {"findLSB", "int uint",
     "int glibra_findLSB(T x) { for (int i = 0; i < 32; ++i) if ((uint(x) >> i & 1u) != 0u) return i; return "
     "-1; }"},
    {"findMSB", "int uint",
     "int glibra_findMSB(T x) { uint b = x < T(0) ? ~uint(x) : uint(x); for (int i = 31; i >= 0; --i) if ((b "
     ">> i & "
     "1u) != 0u) return i; return -1; }"},
});

/// The shifts of both translations after each other: from columns by `second` to those of the text that
/// `first` begins with. `line`: where the line comes from; none for lines of the translation.
std::vector<ColumnShift> joinedShifts(std::vector<ColumnShift> second, const std::vector<ColumnShift>& first,
                                      const LineOrigin& line) {
    if (line.file < 0 || (second.empty() && first.empty())) return {};
    if (second.empty() || second.front().emitted > 1) second.insert(second.begin(), ColumnShift());
    std::vector<ColumnShift> joined;
    for (std::size_t i = 0; i < second.size(); ++i) {
        const int begin = second[i].emitted, middle = second[i].user;
        const bool isLast = i + 1 == second.size();
        ColumnShift shift{begin, middle, line};
        for (const ColumnShift& each : first)
            if (each.emitted <= middle)
                shift = {begin, each.user + middle - each.emitted, each.line, each.macro};
        joined.push_back(shift);
        for (const ColumnShift& each : first) {
            const int at = begin + each.emitted - middle;
            if (each.emitted > middle && (isLast || at < second[i + 1].emitted))
                joined.push_back({at, each.user, each.line, each.macro});
        }
    }
    return joined;
}

}  // namespace

EsStage::EsStage(const TranslatedStage& core, Unit& unit, Report& report, const EsOptions& options)
    : core_(core), unit_(unit), report_(report), options_(options) {
    for (const char* each : {"precision highp float;", "precision highp int;", "precision highp sampler2D;",
                             "precision highp samplerCube;"})
        unit.declare(each);
}

void EsStage::becomePart(Part part) {
    part_ = std::move(part);
    isPart_ = true;
}

bool EsStage::guardLoops(std::vector<Place>& sites) {
    const bool isFragment = unit_.stage == Stage::fragment;
    const std::vector<std::uint32_t> loops =
        glsl::guardLoops(unit_, isFragment ? kCut : kVertexCut, sites.size());
    for (const std::uint32_t each : loops) sites.push_back(userPlaceOf(each));
    if (loops.empty()) return false;
    unit_.declare(isFragment ? fmt::format("int {} = 0;", kCut)
                             : fmt::format("flat out int {};", kVertexCut));
    return true;
}

void EsStage::beginUncut() {
    unit_.declare(fmt::format("flat out int {};", kVertexCut));
    beginWith(fmt::format("{} = 0;", kVertexCut));
}

void EsStage::showCutLoop(bool hasVertexLoops) {
    const auto shows = [](const Variable& each) {
        const std::string* const location = each.layoutValue("location");
        return each.storage == Storage::output && !each.removed && (!location || *location == "0") &&
               each.typeSizes.empty() && each.nameSizes.empty() &&
               (each.type == "float" || each.type == "vec2" || each.type == "vec3" || each.type == "vec4");
    };
    const auto color = std::ranges::find_if(unit_.variables, shows);
    if (color == unit_.variables.end() || !unit_.function("main")) return;
    if (unit_.isDeclared("glibra_main")) unit_.renames["glibra_main"] = "glibra_coreMain";
    unit_.renames["main"] = "glibra_main";
    unit_.declare(fmt::format("uniform int {};", kShowsCut));
    if (hasVertexLoops) unit_.declare(fmt::format("flat in int {};", kVertexCut));
    unit_.declare(fmt::format("int {} = 0;", kCut));
    unit_.declare("int glibra_rounds = 0;");
    beginWith(
        fmt::format("if ({} == 1 && ((int(gl_FragCoord.x) & 15) != 7 || (int(gl_FragCoord.y) & 15) != 7)) "
                    "{{ {} = -1; glibra_rounds = 1000000000; }}",
                    kShowsCut, kCut));
    unit_.mainEnd.push_back(fmt::format("if ({} == 1) {} = {}(float(max({}, {})) / 255.);", kShowsCut,
                                        emittedName(unit_, color->name), color->type, kCut,
                                        hasVertexLoops ? kVertexCut : "0"));
}

void EsStage::adapt(std::vector<InitialValue>& initialValues) {
    for (const Declaration& each : unit_.syntax.declarations) declaration(each);
    for (Variable& each : unit_.variables) variable(each, initialValues);
    for (std::uint32_t i = 0; i < unit_.view.size(); ++i)
        if (unit_.view[i].kind == TokenKind::word) word(i);
    const std::vector<std::string_view> core = coreFunctions();
    for (const auto& [name, at] : unit_.declared)
        if (unit_.function(name) && std::ranges::find(core, name) != core.end())
            unit_.renames[name] = std::string(kOwnOverload) + name;
    for (const Call& each : unit_.bodies.calls) call(each);
    if (options_.hasBorders) passBorders(unit_);
    writeConversions(unit_);
    begin();
}

TranslatedStage EsStage::take() {
    adaptToTarget(unit_);
    renderVariables(unit_);
    applyRenames(unit_, TokenWalk(unit_));
    TranslatedStage stage = emit(unit_);
    // Its map leads to lines of the core text, whose map leads to the user's. The #line directives of
    // that text go where it had them, with plain numbers of sources.
    stage.lineMap.files = core_.lineMap.files;
    stage.lineMap.macros = core_.lineMap.macros;
    const std::vector<std::string_view> coreLines = textLines(core_.source);
    const std::string emitted = std::exchange(stage.source, {});
    std::size_t i = 0;
    for (const std::string_view line : textLines(emitted)) {
        LineOrigin& origin = stage.lineMap.lines[i];
        const auto at = static_cast<std::size_t>(origin.line) - 1;
        const bool isOfCore = origin.file >= 0 && at < coreLines.size();
        const bool isNumber = isOfCore && isLineNumber(coreLines[at]);
        stage.source += isNumber ? withSource(coreLines[at], 0) : std::string(line);
        stage.source += '\n';
        origin = isOfCore ? core_.lineMap.lines[at] : LineOrigin();
        stage.lineMap.columns[i] =
            isOfCore ? joinedShifts(stage.lineMap.columns[i], core_.lineMap.columns[at], origin)
                     : std::vector<ColumnShift>();
        ++i;
    }
    stage.path = core_.path;
    stage.firstLine = core_.firstLine;
    stage.facts = core_.facts;
    stage.loops = core_.loops;
    stage.uncounted = core_.uncounted;
    return stage;
}

void EsStage::lacks(const char* id, const std::string& text) const {
    report_.reportOnce(core_.path + text, id, text, {core_.path, core_.firstLine, 1});
}

void EsStage::lacks(const char* id, const std::string& text, std::uint32_t at) {
    report_.reportOnce(core_.path + text, id, text, userPlaceOf(at));
}

Place EsStage::userPlaceOf(std::uint32_t at) const {
    const Token& token = unit_.tokens[unit_.view[at].raw];
    const auto line = static_cast<std::size_t>(token.line) - 1;
    if (line >= core_.lineMap.lines.size() || core_.lineMap.lines[line].file < 0)
        return {core_.path, core_.firstLine, 1};
    const UserPlace user = userPlace(core_, {line, token.column});
    return {core_.lineMap.files[static_cast<std::size_t>(user.line.file)], user.line.line, user.column};
}

void EsStage::declaration(const Declaration& each) {
    if (each.kind == DeclarationKind::precision ||
        (each.kind == DeclarationKind::layoutOnly && unit_.stage == Stage::fragment))
        return unit_.remove(each.tokens);
    if (each.kind == DeclarationKind::block) block(each);
    for (const Declarator& name : each.declarators)
        if (each.type.dimensions.size() + name.dimensions.size() > 1)
            lacks("web-E04",
                  "'" + std::string(unit_.text(name.name)) +
                      "' is an array of arrays, which GLSL ES 3.00 (WebGL 2) has not",
                  name.name);
}

void EsStage::block(const Declaration& each) {
    const std::string name(unit_.text(each.name));
    if (each.qualifiers.storage == Storage::buffer)
        return lacks("web-E04", "the storage block '" + name + "' is not possible in WebGL 2", each.name);
    if (each.qualifiers.storage != Storage::input && each.qualifiers.storage != Storage::output) return;
    if (name == "gl_PerVertex") return unit_.remove(each.tokens);
    const bool isInput = each.qualifiers.storage == Storage::input;
    std::optional<BlockPlace> place;
    if (isInput) place = part_.input;
    if (!isInput && part_.output) place = part_.output(each.qualifiers.patch);
    if (!place && !each.declarators.empty() && !each.declarators.front().dimensions.empty())
        return lacks(
            "web-E04",
            "'" + name + "' is an array of blocks between stages, which GLSL ES 3.00 (WebGL 2) has not",
            each.name);
    const bool isDeclared = !place || place->isDeclared;
    const std::string word(place ? "" : isInput ? "in " : "out ");
    if (isDeclared) {
        unit_.remove({each.tokens.first, each.body.first + 1});
        unit_.remove({each.body.end - 1, each.tokens.end});
    } else {
        unit_.remove(each.tokens);
    }
    const std::string_view instance =
        each.declarators.empty() ? std::string_view() : unit_.text(each.declarators.front().name);
    for (const Declaration& member : each.members) {
        if (isDeclared) declareMember(each, member, !place, word);
        for (const Declarator& one : member.declarators) {
            const std::string own(unit_.text(one.name));
            const std::string whole = name + "_" + own;
            const std::string variable = (place ? place->prefix : "glibra_") + whole;
            if (isDeclared)
                unit_.edits.replace(unit_.view[one.name].raw, variable + (place ? place->sizes : ""));
            if (place && place->note) place->note(whole);
            if (!place && !isInput && part_.keep) part_.keep(std::string(member.type.name), variable);
            if (instance.empty())
                unit_.renames[own] = variable;
            else
                members_[{std::string(instance), own}] = variable;
        }
    }
}

void EsStage::declareMember(const Declaration& block, const Declaration& member, bool isVarying,
                            const std::string& word) {
    unit_.remove(member.qualifiers.tokens);
    std::string before = member.qualifiers.interpolation.empty() ? block.qualifiers.interpolation
                                                                 : member.qualifiers.interpolation;
    if (typeOfWord(member.type.name).integral()) before = "flat";
    if (before == "noperspective") noPerspective(member.type.tokens.first);
    if (before == "noperspective" || before == "smooth") before.clear();
    if (!before.empty()) before += ' ';
    if (member.qualifiers.centroid || block.qualifiers.centroid) before += "centroid ";
    if (!isVarying) before.clear();
    unit_.edits.before(unit_.view[member.type.tokens.first].raw, before + word);
}

void EsStage::noPerspective(std::uint32_t at) {
    lacks("web-E04", "'noperspective' is not in GLSL ES 3.00, which browsers compile for WebGL 2", at);
}

void EsStage::variable(Variable& each, std::vector<InitialValue>& initialValues) {
    if (each.name.starts_with("gl_")) {
        if (!unit_.renames.contains(each.name) && listed(kMissingNames, each.name))
            missing(each.name, each.nameToken);
        each.removed = true;
        return;
    }
    if (!each.precision.empty() || each.precise || each.sample) each.changed = true;
    each.precision.clear();
    each.precise = each.sample = false;
    const bool isVarying = (each.storage == Storage::input && unit_.stage == Stage::fragment) ||
                           (each.storage == Storage::output && unit_.stage != Stage::fragment);
    if (isVarying) {
        if (each.interpolation == "noperspective") {
            noPerspective(each.nameToken);
            each.interpolation.clear();
            each.changed = true;
        }
        if (unit_.stage == Stage::fragment && each.invariant) {
            each.invariant = false;
            each.changed = true;
        }
    }
    const Declarator& declarator = unit_.syntax.declarations[each.declaration].declarators[each.declarator];
    if (declarator.initializer.empty() || each.dropInitializer) return;
    if (each.storage == Storage::uniform) return uniformValue(each, declarator, initialValues);
    // A part runs several times.
    const bool keepsValue = isConstant(declarator.initializer) && !(isPart_ && unit_.isWritten(each.name));
    if (each.storage != Storage::none || keepsValue) return;
    const std::string function = "glibra_begin_" + each.name;
    unit_.declare("void " + function + "();");
    each.initializer = "; void " + function + "() { " + spelled(unit_, each.name);
    each.after = " }";
    beginnings_.push_back(function + "();");
}

void EsStage::uniformValue(Variable& each, const Declarator& declarator,
                           std::vector<InitialValue>& initialValues) {
    each.dropInitializer = true;
    each.changed = true;
    const std::string prefix = each.name + ".", element = each.name + "[";
    const bool isKnown = std::ranges::any_of(initialValues, [&](const InitialValue& known) {
        return known.uniform == each.name || known.uniform.starts_with(prefix) ||
               known.uniform.starts_with(element);
    });
    if (isKnown) return;  // the other stage declares it, too
    const std::string_view type = unit_.syntax.declarations[each.declaration].type.name;
    if (declarator.value == kNone ||
        !addInitialValues(unit_, each.name, type, declarator.value, initialValues))
        lacks("web-E05",
              "the initialiser of '" + each.name +
                  "' cannot be computed; GLSL ES 3.00 (WebGL 2) has none, so write numbers",
              each.nameToken);
}

bool EsStage::isConstant(Range range) const {
    for (std::uint32_t i = range.first; i < range.end; ++i) {
        if (unit_.bodies.roles[i] != WordRole::global) continue;
        const std::string_view text = unit_.text(i);
        const Variable* variable = unit_.firstVariable(text);
        if (variable ? variable->storage != Storage::constant : unit_.function(text) != nullptr) return false;
        if (text.starts_with("gl_") && !text.starts_with("gl_Max")) return false;
        if (text.starts_with("texture") || text.starts_with("texel") || text.starts_with("dFd")) return false;
        // A member of a block
        if (!variable && unit_.isDeclared(text) && !unit_.function(text)) return false;
    }
    return true;
}

void EsStage::word(std::uint32_t at) {
    const std::string_view text = unit_.text(at);
    const WordRole role = unit_.bodies.roles[at];
    if (role == WordRole::local || role == WordRole::localDeclaration || role == WordRole::member) return;
    if (text == "lowp" || text == "mediump" || text == "highp" || text == "precise")
        return unit_.edits.remove(unit_.view[at].raw);
    if (isType(unit_.view[at])) return type(at, text);
    if (unit_.isDeclared(text)) {
        if (role == WordRole::global) member(at, text);
        return;
    }
    if (unit_.renames.contains(text)) return;
    if (listed(kMissingNames, text) || (text.starts_with("gl_Max") && !listed(kLimits, text)) ||
        text.starts_with("atomic") || text.starts_with("imageAtomic"))
        missing(text, at);
    for (const Renamed& each : kRenamed)
        if (each.name == text) unit_.edits.replace(unit_.view[at].raw, std::string(each.written));
    for (const Written& each : kWritten) {
        if (each.name != text) continue;
        for (const std::string_view type : splitWords(each.types)) {
            std::string line(each.text);
            for (std::size_t i = 0; (i = line.find('T', i)) != std::string::npos; i += type.size())
                if (!base::isOfName(line[i + 1]) && (i == 0 || !base::isOfName(line[i - 1])))
                    line.replace(i, 1, type);
            unit_.declare(line);
        }
        unit_.edits.replace(unit_.view[at].raw, "glibra_" + std::string(text));
    }
}

void EsStage::type(std::uint32_t at, std::string_view text) {
    std::string plain(text);
    if (plain.starts_with("isampler") || plain.starts_with("usampler")) plain.erase(0, 1);
    if (plain == "sampler1D")
        return unit_.edits.replace(unit_.view[at].raw, std::string(text.substr(0, text.size() - 2)) + "2D");
    const bool isSampler = plain.starts_with("sampler");
    if (isSampler && listed(kSamplers, plain)) {
        if (plain != text || (plain != "sampler2D" && plain != "samplerCube"))
            unit_.declare("precision highp " + std::string(text) + ";");
        return;
    }
    if (isSampler || isImageTypeWord(text) || text == "atomic_uint" || text == "double" ||
        text.starts_with("dvec") || text.starts_with("dmat"))
        lacks(
            "web-E03",
            "the type '" + std::string(text) + "' is not in GLSL ES 3.00, which browsers compile for WebGL 2",
            at);
}

void EsStage::member(std::uint32_t at, std::string_view instance) {
    const auto size = static_cast<std::uint32_t>(unit_.view.size());
    const std::uint32_t dot = unit_.text(at + 1) == "[" ? closing(unit_.view, at + 1, size) + 1 : at + 1;
    if (dot + 1 >= size || unit_.text(dot) != ".") return;
    const auto known = members_.find({std::string(instance), std::string(unit_.text(dot + 1))});
    if (known == members_.end()) return;
    unit_.edits.replace(unit_.view[at].raw, known->second);
    unit_.remove({dot, dot + 2});
}

void EsStage::call(const Call& each) {
    if (each.types.empty() || !each.types.front().word.ends_with("sampler1D") || each.arguments.empty())
        return;
    const std::string_view name = unit_.text(each.name);
    if (name == "textureSize") {
        unit_.edits.after(unit_.view[each.arguments.back().end].raw, ".x");
    } else if ((name == "texture" || name == "textureLod" || name == "texelFetch") &&
               each.arguments.size() > 1) {
        const Range place = each.arguments[1];
        const bool isFetch = name == "texelFetch";
        unit_.edits.before(unit_.view[place.first].raw, isFetch ? "ivec2(" : "vec2(");
        unit_.edits.after(unit_.view[place.end - 1].raw, isFetch ? ", 0)" : ", .5)");
    } else if (!unit_.isDeclared(name) && name.starts_with("tex")) {
        lacks("web-E02",
              "'" + std::string(name) + "' of a sampler1D has no counterpart in GLSL ES 3.00 (WebGL 2)",
              each.name);
    }
}

void EsStage::missing(std::string_view name, std::uint32_t at) {
    lacks("web-E02", "'" + std::string(name) + "' is not in GLSL ES 3.00, which browsers compile for WebGL 2",
          at);
}

void EsStage::begin() {
    std::string text;
    for (const std::string& each : beginnings_) text += " " + each;
    if (unit_.stage == Stage::vertex && !isPart_ && !unit_.isWritten("gl_PointSize")) {
        if (!unit_.isDeclared("glibra_PointSize")) unit_.declare("uniform float glibra_PointSize;");
        text += " gl_PointSize = glibra_PointSize;";
    }
    const Declaration* main = unit_.function("main");
    if (main && !text.empty()) unit_.edits.after(unit_.view[main->body.first].raw, text);
}

}  // namespace glibra::glsl
