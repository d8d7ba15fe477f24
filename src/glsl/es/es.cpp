#include "glsl/es/es.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "glsl/emit/emit.h"
#include "glsl/emit/log_line.h"
#include "glsl/es/borders.h"
#include "glsl/es/constants.h"
#include "glsl/es/conversions.h"
#include "glsl/es/geometry.h"
#include "glsl/es/parts.h"
#include "glsl/es/tessellation.h"
#include "glsl/parse/bodies.h"
#include "glsl/parse/usage.h"
#include "glsl/parse/variables.h"
#include "glsl/read/source.h"
#include "glsl/read/words.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

constexpr int kEsVersion = 300;

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

bool isLineNumber(std::string_view line) {
    return line.starts_with("#line ");
}

std::vector<std::string_view> textLines(std::string_view text) {
    std::vector<std::string_view> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

/// The text with empty lines in place of #extension and #line, so that its lines keep their numbers.
std::string withoutDirectives(std::string_view source) {
    std::string text;
    for (const std::string_view line : textLines(source)) {
        if (!isLineNumber(line) && !line.starts_with("#extension ")) text += line;
        text += '\n';
    }
    return text;
}

/// One stage, from the core text to that of GLSL ES.
class EsStage {
  public:
    EsStage(const TranslatedStage& core, Unit& unit, Report& report, const EsOptions& options)
        : core_(core), unit_(unit), report_(report), options_(options) {
        for (const char* each : {"precision highp float;", "precision highp int;",
                                 "precision highp sampler2D;", "precision highp samplerCube;"})
            unit.declare(each);
    }

    /// It becomes a part of the vertex stage, and so do the stages with which it shares variables.
    struct Part {
        std::optional<BlockPlace> input{};
        std::function<BlockPlace(bool isOfPatch)> output{};
        /// Gets the variables in place of the members of blocks that the fragment stage reads.
        std::function<void(std::string type, std::string name)> keep{};
    };
    void becomePart(Part part) {
        part_ = std::move(part);
        isPart_ = true;
    }

    void adapt(std::vector<InitialValue>& initialValues) {
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

    [[nodiscard]] TranslatedStage take() {
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
            std::ranges::copy_if(isNumber ? coreLines[at] : line, std::back_inserter(stage.source),
                                 [&](char c) { return !isNumber || c != '"'; });
            stage.source += '\n';
            origin = isOfCore ? core_.lineMap.lines[at] : LineOrigin();
            stage.lineMap.columns[i] = isOfCore ? core_.lineMap.columns[at] : std::vector<ColumnShift>();
            ++i;
        }
        stage.path = core_.path;
        stage.firstLine = core_.firstLine;
        stage.facts = core_.facts;
        return stage;
    }

    /// Statements that main does first.
    void beginWith(std::string statements) { beginnings_.push_back(std::move(statements)); }
    /// Of the stage as a whole.
    void lacks(const char* id, const std::string& text) const {
        report_.reportOnce(core_.path + text, id, text, {core_.path, core_.firstLine, 1});
    }
    void lacks(const char* id, const std::string& text, std::uint32_t at) {
        report_.reportOnce(core_.path + text, id, text, userPlaceOf(at));
    }

    /// The place of the user's text that the core text has there; the file's first line for what the
    /// translation added.
    [[nodiscard]] Place userPlaceOf(std::uint32_t at) const {
        const Token& token = unit_.tokens[unit_.view[at].raw];
        const auto line = static_cast<std::size_t>(token.line) - 1;
        if (line >= core_.lineMap.lines.size() || core_.lineMap.lines[line].file < 0)
            return {core_.path, core_.firstLine, 1};
        const UserPlace user = userPlace(core_, {line, token.column});
        return {core_.lineMap.files[static_cast<std::size_t>(user.line.file)], user.line.line, user.column};
    }

  private:
    void declaration(const Declaration& each) {
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

    /// Blocks between stages become variables, one for each member.
    void block(const Declaration& each) {
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

    /// The qualifiers of a variable in place of a member of a block.
    void declareMember(const Declaration& block, const Declaration& member, bool isVarying,
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

    void noPerspective(std::uint32_t at) {
        lacks("web-E04", "'noperspective' is not in GLSL ES 3.00, which browsers compile for WebGL 2", at);
    }

    void variable(Variable& each, std::vector<InitialValue>& initialValues) {
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
        const Declarator& declarator =
            unit_.syntax.declarations[each.declaration].declarators[each.declarator];
        if (declarator.initializer.empty() || each.dropInitializer) return;
        if (each.storage == Storage::uniform) return uniformValue(each, declarator, initialValues);
        // A part runs several times.
        const bool keepsValue =
            isConstant(declarator.initializer) && !(isPart_ && unit_.isWritten(each.name));
        if (each.storage != Storage::none || keepsValue) return;
        const std::string function = "glibra_begin_" + each.name;
        unit_.declare("void " + function + "();");
        each.initializer = "; void " + function + "() { " + spelled(unit_, each.name);
        each.after = " }";
        beginnings_.push_back(function + "();");
    }

    void uniformValue(Variable& each, const Declarator& declarator,
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

    [[nodiscard]] bool isConstant(Range range) const {
        for (std::uint32_t i = range.first; i < range.end; ++i) {
            if (unit_.bodies.roles[i] != WordRole::global) continue;
            const std::string_view text = unit_.text(i);
            const Variable* variable = unit_.firstVariable(text);
            if (variable ? variable->storage != Storage::constant : unit_.function(text) != nullptr)
                return false;
            if (text.starts_with("gl_") && !text.starts_with("gl_Max")) return false;
            if (text.starts_with("texture") || text.starts_with("texel") || text.starts_with("dFd"))
                return false;
            // A member of a block
            if (!variable && unit_.isDeclared(text) && !unit_.function(text)) return false;
        }
        return true;
    }

    void word(std::uint32_t at) {
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

    void type(std::uint32_t at, std::string_view text) {
        std::string plain(text);
        if (plain.starts_with("isampler") || plain.starts_with("usampler")) plain.erase(0, 1);
        if (plain == "sampler1D")
            return unit_.edits.replace(unit_.view[at].raw,
                                       std::string(text.substr(0, text.size() - 2)) + "2D");
        const bool isSampler = plain.starts_with("sampler");
        if (isSampler && listed(kSamplers, plain)) {
            if (plain != text || (plain != "sampler2D" && plain != "samplerCube"))
                unit_.declare("precision highp " + std::string(text) + ";");
            return;
        }
        if (isSampler || isImageTypeWord(text) || text == "atomic_uint" || text == "double" ||
            text.starts_with("dvec") || text.starts_with("dmat"))
            lacks("web-E03",
                  "the type '" + std::string(text) +
                      "' is not in GLSL ES 3.00, which browsers compile for WebGL 2",
                  at);
    }

    /// instance.member of a block between stages
    void member(std::uint32_t at, std::string_view instance) {
        const auto size = static_cast<std::uint32_t>(unit_.view.size());
        const std::uint32_t dot = unit_.text(at + 1) == "[" ? closing(unit_.view, at + 1, size) + 1 : at + 1;
        if (dot + 1 >= size || unit_.text(dot) != ".") return;
        const auto known = members_.find({std::string(instance), std::string(unit_.text(dot + 1))});
        if (known == members_.end()) return;
        unit_.edits.replace(unit_.view[at].raw, known->second);
        unit_.remove({dot, dot + 2});
    }

    /// Textures of one dimension are those of two with one row.
    void call(const Call& each) {
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

    void missing(std::string_view name, std::uint32_t at) {
        lacks("web-E02",
              "'" + std::string(name) + "' is not in GLSL ES 3.00, which browsers compile for WebGL 2", at);
    }

    /// What main does first.
    void begin() {
        std::string text;
        for (const std::string& each : beginnings_) text += " " + each;
        if (unit_.stage == Stage::vertex && !isPart_ && !unit_.isWritten("gl_PointSize")) {
            if (!unit_.isDeclared("glibra_PointSize")) unit_.declare("uniform float glibra_PointSize;");
            text += " gl_PointSize = glibra_PointSize;";
        }
        const Declaration* main = unit_.function("main");
        if (main && !text.empty()) unit_.edits.after(unit_.view[main->body.first].raw, text);
    }

    const TranslatedStage& core_;
    Unit& unit_;
    Report& report_;
    const EsOptions& options_;
    Part part_;
    bool isPart_ = false;
    std::vector<std::string> beginnings_;  ///< statements that give variables their first values
    /// The variables in place of the members of blocks, by instance and member.
    std::map<std::pair<std::string, std::string>, std::string> members_;
};

/// Outputs of the vertex stage and inputs of the fragment stage: matched by name, interpolated alike.
void connect(Unit& vertex, Unit& fragment) {
    for (Variable& input : fragment.variables) {
        if (input.storage != Storage::input || input.removed) continue;
        const std::string* const location = input.layoutValue("location");
        for (Variable& output : vertex.variables) {
            if (output.storage != Storage::output || output.removed) continue;
            const std::string* const own = output.layoutValue("location");
            const bool isMatch = location && own ? *location == *own : input.name == output.name;
            if (!isMatch) continue;
            if (input.name != output.name)
                fragment.renames[input.name] = vertex.renames[output.name] = "glibra_Location_" + *location;
            output.interpolation = input.interpolation;
            output.centroid = input.centroid;
            output.changed = true;
        }
        input.removeLayout("location");
    }
    for (Variable& output : vertex.variables) {
        if (output.storage != Storage::output) continue;
        output.removeLayout("location");
        if (!typeOfWord(output.type).integral() || !output.interpolation.empty()) continue;
        output.interpolation = "flat";
        output.changed = true;
    }
}

/// Stages as one text: what they declare alike before the user's text stands once.
TranslatedStage joined(TranslatedStage first, const TranslatedStage& second, const std::string& ending) {
    const auto files = static_cast<int>(first.lineMap.files.size());
    const auto macros = static_cast<int>(first.lineMap.macros.size());
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(first.lineMap.files, second.lineMap.files);
    append(first.lineMap.macros, second.lineMap.macros);
    const std::string firstText = first.source;
    std::set<std::string_view> known;  // written by the translation
    for (std::size_t i = 0; const std::string_view line : textLines(firstText))
        if (first.lineMap.lines[i++].file < 0 && (line.ends_with(';') || line.starts_with('#')) &&
            !isLineNumber(line))
            known.insert(line);
    std::size_t i = 0;
    for (const std::string_view line : textLines(second.source)) {
        LineOrigin origin = second.lineMap.lines[i];
        std::vector<ColumnShift> columns = second.lineMap.columns[i++];
        if (origin.file < 0 && known.contains(line)) continue;
        const std::size_t number = line.rfind(' ');
        if (isLineNumber(line) && files > 0 && number != std::string_view::npos)
            first.source += std::string(line.substr(0, number + 1)) +
                            std::to_string(std::atoi(std::string(line.substr(number)).c_str()) + files);
        else
            first.source += line;
        first.source += '\n';
        if (origin.file >= 0) origin.file += files;
        for (ColumnShift& each : columns) {
            if (each.line.file >= 0) each.line.file += files;
            if (each.macro >= 0) each.macro += macros;
        }
        first.lineMap.lines.push_back(origin);
        first.lineMap.columns.push_back(std::move(columns));
    }
    first.source += ending;
    const auto count = static_cast<std::size_t>(std::ranges::count(first.source, '\n'));
    first.lineMap.lines.resize(count);
    first.lineMap.columns.resize(count);
    return first;
}

Unit* stageIn(std::vector<Unit>& units, Stage stage) {
    const auto found = std::ranges::find(units, stage, &Unit::stage);
    return found == units.end() ? nullptr : &*found;
}

/// The stages before the fragment stage as one vertex stage, where there are more than that.
class MergedStages {
  public:
    MergedStages(std::vector<Unit>& units, std::vector<EsStage>& stages, const TranslatedProgram& program,
                 const DrawForms& draws)
        : stages_(stages),
          draws_(draws),
          vertex_(stageIn(units, Stage::vertex)),
          control_(stageIn(units, Stage::tessControl)),
          evaluation_(stageIn(units, Stage::tessEvaluation)),
          geometry_(stageIn(units, Stage::geometry)),
          first_(units.data()) {
        Unit* const fragment = stageIn(units, Stage::fragment);
        if (Unit* const last = geometry_ ? geometry_ : evaluation_ ? evaluation_ : vertex_; last && fragment)
            connect(*last, *fragment);
        if (vertex_ && fragment && !geometry_ && fragment->isUsed("gl_PrimitiveID"))
            numberPrimitives(*fragment);
        if (vertex_ && program.clipDistances > 0) clip(fragment, program.clipDistances);
        if (!vertex_ || (!evaluation_ && !geometry_)) return;
        corners_ = evaluation_ ? draws.patchVertices : cornersOfInput(program.geometryInput);
        if (evaluation_) tessellate(program);
        if (geometry_) build(fragment, program);
        if (built_ && program.clipDistances > 0)
            built_->keep("float", kDistances, "[" + std::to_string(program.clipDistances) + "]");
    }

    /// Of what the stages become.
    [[nodiscard]] ExpandedGeometry expansion() const {
        ExpandedGeometry all;
        all.numbersPrimitives = numbersPrimitives_ && !tessellation_;
        if (!tessellation_ && !built_) return all;
        if (built_) all = built_->expansion();
        all.corners = corners_;
        all.fetched = (own_ ? *own_ : tessellation_->corners()).fetched();
        if (!tessellation_) return all;
        all.tessellation = tessellation_->layout();
        all.measuresLevels = control_ != nullptr;
        all.areInSequence = tessellation_->areInSequence();
        if (!built_) all.vertices = all.ofPrimitive = cornersOf(tessellation_->layout());
        return all;
    }

    /// In place of the stages of `program`.
    void join(std::vector<TranslatedStage>& stages) const {
        if (!tessellation_ && !built_) return;
        const auto at = [&](Stage stage) {
            return std::ranges::find(stages, stage, &TranslatedStage::stage);
        };
        const Stage last = built_ ? Stage::geometry : Stage::tessEvaluation;
        for (const Stage each : {Stage::tessControl, Stage::tessEvaluation, Stage::geometry}) {
            if (at(each) == stages.end()) continue;
            *at(Stage::vertex) = joined(*at(Stage::vertex), *at(each), each == last ? ending() : "");
            stages.erase(at(each));
        }
    }

  private:
    EsStage& of(const Unit& unit) { return stages_[static_cast<std::size_t>(&unit - first_)]; }

    /// The fragment stage discards what lies behind a plane: pixels whose centres are cut away have a
    /// negative distance (OpenGL 4.6 Core, 13.7.1).
    void clip(Unit* fragment, int count) {
        const std::string size = "[" + std::to_string(count) + "];";
        Unit& last = geometry_ ? *geometry_ : evaluation_ ? *evaluation_ : *vertex_;
        last.renames["gl_ClipDistance"] = kDistances;
        last.declare(std::string("out float ") + kDistances + size);
        if (!fragment) return;
        fragment->renames["gl_ClipDistance"] = kDistances;
        fragment->declare(std::string("in float ") + kDistances + size);
        std::string isBehind;
        for (int i = 0; i < count; ++i)
            isBehind += std::string(i > 0 ? " || " : "") + kDistances + "[" + std::to_string(i) + "] < 0.";
        of(*fragment).beginWith("if (" + isBehind + ") discard;");
    }

    /// The fragment stage gets the number of its primitive from the vertices.
    void numberPrimitives(Unit& fragment) {
        const bool hasInputs = std::ranges::any_of(vertex_->variables, [](const Variable& each) {
            return each.storage == Storage::input && !each.name.starts_with("gl_");
        });
        if (draws_.haveIndexBuffers || draws_.areStrips) return;
        if (!evaluation_ && hasInputs && vertex_->isUsed("gl_VertexID")) return;  // numbers of the mesh
        numbersPrimitives_ = true;
        fragment.renames["gl_PrimitiveID"] = kPrimitive;
        fragment.declare(std::string("flat in int ") + kPrimitive + ";");
        if (evaluation_) return;
        vertex_->declare(std::string("flat out int ") + kPrimitive + ";");
        vertex_->declare("uniform int glibra_PerPrimitive;");
        of(*vertex_).beginWith(std::string(kPrimitive) + " = gl_VertexID / glibra_PerPrimitive;");
    }

    [[nodiscard]] bool isFetched() const {
        return (own_ && !own_->fetched().empty()) ||
               (tessellation_ && !tessellation_->corners().fetched().empty());
    }

    void lacks(const Unit& unit, const char* what, std::string problem) {
        if (problem.empty() && draws_.areStrips) problem = "strips, fans and loops";
        if (problem.empty() && draws_.haveIndexBuffers) problem = "indices of a buffer";
        if (problem.empty() && draws_.haveInstanceData) problem = "attributes of instances";
        if (problem.empty() && draws_.haveBufferData && isFetched())
            problem = "more than 16 inputs, some of them from buffers";
        if (problem.empty() && corners_ == 0) problem = "patches of several sizes";
        if (problem.empty()) return;
        of(unit).lacks("web-E01",
                       std::string("WebGL 2 has no ") + what + " stage, and cannot do without: " + problem);
    }

    void tessellate(const TranslatedProgram& program) {
        TessellationInVertex& tessellation =
            tessellation_.emplace(*vertex_, control_, *evaluation_, corners_, program);
        lacks(*evaluation_, "tessellation",
              tessellation.prepare(geometry_ ? cornersOfInput(program.geometryInput) : 0));
        of(*vertex_).becomePart(
            {.output = [&](bool) { return tessellation.outputOf(Stage::vertex, false); }});
        if (control_)
            of(*control_).becomePart({tessellation.inputOf(Stage::tessControl), [&](bool isOfPatch) {
                                          return tessellation.outputOf(Stage::tessControl, isOfPatch);
                                      }});
        EsStage::Part part{tessellation.inputOf(Stage::tessEvaluation)};
        if (geometry_) part.output = [&](bool) { return tessellation.primitives().output(); };
        of(*evaluation_).becomePart(std::move(part));
    }

    void build(Unit* fragment, const TranslatedProgram& program) {
        if (!tessellation_) {
            own_.emplace(*vertex_, "glibra_v", "glibra_corners", corners_);
            own_->prepare("glibra_Instance");
            vertex_->declare("uniform int glibra_Instance;");
            own_->spreadInputs();
            of(*vertex_).becomePart({.output = [&](bool) { return own_->output(); }});
        }
        CornerStage& corners = tessellation_ ? tessellation_->primitives() : *own_;
        GeometryInVertex& built = built_.emplace(corners, *geometry_, fragment, program);
        std::string problem = built.prepare(tessellation_ ? "glibra_patch" : "gl_InstanceID", !tessellation_);
        for (const Unit* each : {vertex_, control_, evaluation_})
            if (each) removeTwins(*geometry_, *each);
        // Vertices without data are numbered; those of a mesh have lost their numbers.
        if (own_ && vertex_->isUsed("gl_VertexID") && own_->hasInputs())
            problem = "gl_VertexID and vertex data before it";
        lacks(*geometry_, "geometry", problem);
        of(*geometry_)
            .becomePart({corners.inputOfNext("glibra_c_"), {}, [&](std::string type, std::string name) {
                             built.keep(std::move(type), std::move(name));
                         }});
    }

    [[nodiscard]] std::string ending() const {
        std::string functions, text;
        if (tessellation_) functions += tessellation_->functions();
        if (built_) functions += built_->functions();
        const Unit& last = geometry_ ? *geometry_ : *evaluation_;
        if (!last.isWritten("gl_PointSize")) {
            if (std::ranges::none_of(
                    std::array<const Unit*, 4>{vertex_, control_, evaluation_, geometry_},
                    [](const Unit* each) { return each && each->isDeclared("glibra_PointSize"); }))
                functions += "uniform float glibra_PointSize;\n";
            text += " gl_PointSize = glibra_PointSize;\n";
        }
        if (numbersPrimitives_) functions += std::string("flat out int ") + kPrimitive + ";\n";
        if (tessellation_) text += tessellation_->statements();
        if (numbersPrimitives_) text += std::string(" ") + kPrimitive + " = glibra_patch;\n";
        if (tessellation_ && built_) {
            const ExpandedGeometry each = built_->expansion();
            text += " int primitive = glibra_at / " + std::to_string(each.vertices) + ";\n";
            for (int corner = 0; corner < each.corners; ++corner)
                text += tessellation_->primitives().run(
                    corner, tessellation_->coordinate("primitive * " + std::to_string(each.corners) + " + " +
                                                      std::to_string(corner)));
            text += built_->statements("(glibra_at - primitive * " + std::to_string(each.vertices) + ")");
        } else if (tessellation_) {
            text += tessellation_->coordinate("glibra_at") + " glibra_e_main();\n";
        } else {
            for (int corner = 0; corner < corners_; ++corner)
                text += own_->run(corner, " glibra_vertex = " + std::to_string(corners_) +
                                              " * gl_InstanceID + " + std::to_string(corner) + ";");
            text += built_->statements("gl_VertexID");
        }
        return functions + "void main() {\n" + text + "}\n";
    }

    std::vector<EsStage>& stages_;
    const DrawForms& draws_;
    Unit *vertex_, *control_, *evaluation_, *geometry_;
    const Unit* first_;
    static constexpr const char* kPrimitive = "glibra_PrimitiveID";
    static constexpr const char* kDistances = "glibra_ClipDistance";
    int corners_ = 0;  ///< of a primitive of the mesh
    bool numbersPrimitives_ = false;
    std::optional<TessellationInVertex> tessellation_;
    std::optional<CornerStage> own_;  ///< the vertex stage before a geometry stage
    std::optional<GeometryInVertex> built_;
};

}  // namespace

EsProgram toEs(const TranslatedProgram& program, const EsOptions& options) {
    EsProgram result;
    Report report, ignored;  // the core text has been reported already
    ProgramRequest core, es;
    core.target.version = 450;
    es.target.version = kEsVersion;
    es.target.isEs = true;
    std::vector<Unit> units;
    units.reserve(program.stages.size() + 1);
    std::vector<EsStage> stages;
    for (const TranslatedStage& each : program.stages) {
        if (each.stage == Stage::compute) {
            report.reportOnce("compute", "web-E01", "WebGL 2 has no compute stage",
                              {each.path, each.firstLine, 1});
            continue;
        }
        Unit& unit = units.emplace_back();
        unit.request = &core;
        readSource({each.stage, each.path, withoutDirectives(each.source)}, unit, ignored);
        unit.syntax = parseSyntax(unit.view);
        unit.bodies = parseBodies(unit.view, unit.syntax);
        unit.variables = collectVariables(unit);
        findUsage(unit);
        unit.request = &es;
        stages.emplace_back(each, unit, report, options);
    }
    const MergedStages merged(units, stages, program, options.draws);
    for (EsStage& each : stages) each.adapt(result.initialValues);
    for (EsStage& each : stages) result.stages.push_back(each.take());
    merged.join(result.stages);
    result.expanded = merged.expansion();
    // Only the core profile links a vertex stage alone.
    if (!result.stages.empty() && result.stages.back().stage == Stage::vertex) {
        TranslatedStage& empty = result.stages.emplace_back();
        empty.stage = Stage::fragment;
        empty.source = "#version 300 es\nvoid main() {}\n";
        empty.lineMap.lines.resize(2);
        empty.lineMap.columns.resize(2);
    }
    result.diagnostics = report.take();
    return result;
}

}  // namespace glibra::glsl
