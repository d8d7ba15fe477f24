#include "glsl/es/parts.h"

#include <fmt/format.h>

#include <algorithm>

#include "glsl/parse/types.h"

namespace glibra::glsl {
namespace {

bool isUniformOf(const Unit& unit, std::string_view name) {
    const Variable* const variable = unit.firstVariable(name);
    return variable != nullptr && variable->storage == Storage::uniform;
}

/// True if the stage has the same uniform block or structure.
bool hasTwin(const Unit& unit, const Declaration& wanted, std::string_view name) {
    return std::ranges::any_of(unit.syntax.declarations, [&](const Declaration& each) {
        return each.kind == wanted.kind && each.name != kNone && unit.text(each.name) == name;
    });
}

/// As many components as a type has.
std::string_view swizzleOf(std::string_view type) {
    constexpr std::string_view kAll = ".xyzw";
    const char last = type.empty() ? '4' : type.back();
    return kAll.substr(0, last >= '2' && last <= '4' ? static_cast<std::size_t>(last - '0') + 1 : 2);
}

}  // namespace

std::string bracketed(const std::vector<std::string>& sizes) {
    std::string text;
    for (const std::string& each : sizes) text += "[" + each + "]";
    return text;
}

std::string emittedName(const Unit& unit, const std::string& name) {
    const auto renamed = unit.renames.find(name);
    return renamed == unit.renames.end() ? name : renamed->second;
}

void makePlain(Variable& variable) {
    variable.storage = Storage::none;
    variable.interpolation.clear();
    variable.patch = variable.centroid = variable.sample = variable.invariant = false;
    variable.layout.clear();
    variable.changed = true;
}

void makeArray(Variable& variable, int size) {
    makePlain(variable);
    variable.typeSizes.clear();
    variable.nameSizes = {std::to_string(size)};
    variable.sizesChanged = true;
}

Variable* outputFor(Unit& from, const Variable& input) {
    const std::string* const location = input.layoutValue("location");
    const auto output = std::ranges::find_if(from.variables, [&](const Variable& other) {
        const std::string* const own = other.layoutValue("location");
        return other.storage == Storage::output && !other.removed &&
               (location && own ? *location == *own : other.name == input.name);
    });
    return output == from.variables.end() ? nullptr : &*output;
}

void removeTwins(Unit& unit, const Unit& earlier) {
    for (const Declaration& each : unit.syntax.declarations) {
        const bool isStruct = each.type.isStruct && each.declarators.empty() && each.name != kNone;
        const bool isBlock =
            each.kind == DeclarationKind::block && each.qualifiers.storage == Storage::uniform;
        if ((isStruct || isBlock) && hasTwin(earlier, each, unit.text(each.name))) unit.remove(each.tokens);
    }
    for (Variable& each : unit.variables)
        if (each.storage == Storage::uniform && isUniformOf(earlier, each.name)) each.removed = true;
}

void prefixNames(Unit& unit, std::string_view prefix) {
    for (const auto& [name, at] : unit.declared) {
        const bool isOwn = unit.function(name) != nullptr || unit.firstVariable(name) != nullptr;
        if (isOwn && !isUniformOf(unit, name)) unit.renames[name] = fmt::format("{}_{}", prefix, name);
    }
    unit.renames["main"] = fmt::format("{}_main", prefix);
}

void renameCornerMembers(Unit& unit) {
    for (std::uint32_t i = 1; i < unit.view.size(); ++i)
        if (unit.text(i - 1) == "." && (unit.text(i) == "gl_Position" || unit.text(i) == "gl_PointSize"))
            unit.edits.replace(unit.view[i].raw,
                               unit.text(i) == "gl_Position" ? "glibra_position" : "glibra_pointSize");
}

void CornerStage::prepare(std::string_view instance) {
    prefixNames(*unit_, prefix_);
    unit_->renames["gl_Position"] = prefix_ + "Position";
    unit_->renames["gl_PointSize"] = prefix_ + "PointSize";
    unit_->declare(fmt::format("vec4 {}Position;", prefix_));
    unit_->declare(fmt::format("float {}PointSize;", prefix_));
    unit_->declare("struct glibra_Corner { vec4 glibra_position; float glibra_pointSize; };");
    unit_->declare(fmt::format("glibra_Corner {}[{}];", array_, corners_));
    if (unit_->stage != Stage::vertex) return;
    unit_->renames["gl_InstanceID"] = instance;
    unit_->renames["gl_VertexID"] = "glibra_vertex";
    unit_->declare("int glibra_vertex;");
}

void CornerStage::spreadInputs() {
    constexpr int kMostInputs = 16;  // of a vertex stage in GLSL ES 3.00 (gl_MaxVertexAttribs)
    std::vector<Variable*> inputs;
    for (Variable& each : unit_->variables)
        if (each.storage == Storage::input && !each.removed && !each.name.starts_with("gl_"))
            inputs.push_back(&each);
    const bool fits = static_cast<int>(inputs.size()) * corners_ <= kMostInputs;
    int location = 0;
    for (Variable* each : inputs) {
        for (int corner = 0; fits && corner < corners_; ++corner)
            unit_->declare(fmt::format("layout(location = {}) in {} {}{}_{};", location++, each->type,
                                       kCornerInput, corner, each->name));
        if (!fits) fetched_.push_back({each->name, each->type});
        attributes_.push_back(each->name);
        makePlain(*each);
    }
    if (fits) return;
    unit_->declare(fmt::format("uniform highp sampler2D {};", kFetchedInputs));
    unit_->declare(
        fmt::format("vec4 glibra_input(int at) {{ int width = textureSize({0}, 0).x; at += glibra_vertex * "
                    "{1}; return texelFetch({0}, ivec2(at % width, at / width), 0); }}",
                    kFetchedInputs, inputs.size()));
}

bool CornerStage::deliverTo(Unit& next) {
    bool hasAll = true;
    for (Variable& each : next.variables) {
        if (each.storage != Storage::input || each.patch || each.removed || each.name.starts_with("gl_"))
            continue;
        if (const Variable* output = outputFor(*unit_, each))
            passed_.push_back({emittedName(*unit_, output->name), emittedName(next, each.name)});
        else
            hasAll = false;
        makeArray(each, corners_);
    }
    for (Variable& each : unit_->variables)
        if (each.storage == Storage::output && !each.name.starts_with("gl_")) makePlain(each);
    return hasAll;
}

BlockPlace CornerStage::inputOfNext(const std::string& prefix) {
    return {prefix, fmt::format("[{}]", corners_), true, [this, prefix](const std::string& member) {
                passed_.push_back({prefix_ + "_" + member, prefix + member});
            }};
}

std::string CornerStage::run(int corner, const std::string& before) const {
    std::string text = before;
    for (std::size_t i = 0; i < fetched_.size(); ++i)
        text += fmt::format(" {} = {}(glibra_input({}){});", emittedName(*unit_, fetched_[i].name),
                            fetched_[i].type, i, swizzleOf(fetched_[i].type));
    if (fetched_.empty())
        for (const std::string& each : attributes_)
            text += fmt::format(" {} = {}{}_{};", emittedName(*unit_, each), kCornerInput, corner, each);
    text += fmt::format(
        " {0}_main(); {1}[{2}].glibra_position = {0}Position; {1}[{2}].glibra_pointSize = {0}PointSize;",
        prefix_, array_, corner);
    for (const auto& [from, to] : passed_) text += fmt::format(" {}[{}] = {};", to, corner, from);
    return text + "\n";
}

}  // namespace glibra::glsl
