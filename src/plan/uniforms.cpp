#include "plan/uniforms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "plan/texture_binding.h"
#include "plan/type_table.h"
#include "plan/uniform_names.h"

namespace glibra::plan {
namespace {

bool isOpaque(const ActiveUniform& uniform) {
    return uniform.type.base == BaseType::sampler || uniform.type.base == BaseType::image;
}
/// The value of a well-known name, for messages.
std::string_view describe(glsl::Builtin value) {
    using enum glsl::Builtin;
    switch (value) {
        case modelView:
            return "model-view matrix";
        case projection:
            return "projection matrix";
        case modelViewProjection:
            return "model-view-projection matrix";
        case normalMatrix:
            return "normal matrix";
        case modelViewInverseTranspose:
            return "inverse transpose of the model-view matrix";
        case modelViewProjectionInverse:
            return "inverse of the model-view-projection matrix";
        case projectionInverse:
            return "inverse of the projection matrix";
        case model:
            return "model matrix";
        case modelInverse:
            return "inverse of the model matrix";
        case modelInverseTranspose:
            return "inverse transpose of the model matrix";
        case modelNormalMatrix:
            return "normal matrix in world space";
        case view:
            return "view matrix";
        case viewInverse:
            return "inverse of the view matrix";
        case viewProjection:
            return "projection matrix times the view matrix";
        case eyePosition:
            return "position of the camera";
        default:
            return "value that glibra supplies";
    }
}

bool isNoise(const glsl::BuiltinUniform& row) {
    return row.value == glsl::Builtin::noise2 || row.value == glsl::Builtin::noise3;
}

/// Resolves the pairs of one program.
class Resolver {
  public:
    Resolver(const scene::Program& program, const std::string& scenePath, const ProgramInterface& interface,
             std::span<const Override> overrides, const DrawValues& drawn)
        : program_(program),
          scenePath_(scenePath),
          interface_(interface),
          overrides_(overrides),
          drawn_(drawn),
          names_(interface),
          touched_(interface.uniforms.size()) {
        for (const ActiveUniform& uniform : interface.uniforms) {
            rows_.push_back(suppliedBy(uniform));
            units_.push_back(isOpaque(uniform) ? defaultUnits(uniform, rows_.back()) : std::vector<int>());
            bound_.emplace_back(units_.back().size());
        }
    }

    UniformResolution resolve(std::vector<bool>& usedOverrides) && {
        supply();
        findOverridden();
        applyPairs();
        applyOverrides(usedOverrides);
        bindObjects();
        findByName();
        reportUnset();
        listSamplers();
        return std::move(result_);
    }

  private:
    const ActiveUniform& uniform(UniformIndex index) const { return at(interface_.uniforms, index); }
    Place place(glib::Position position) const { return {scenePath_, position.line, position.column}; }
    void warn(const char* id, std::string text, const Place& place) {
        result_.diagnostics.push_back(diagnose(id, std::move(text), place));
    }

    /// The units of a sampler without a tag: the noise texture's, layout(binding), or 0.
    std::vector<int> defaultUnits(const ActiveUniform& sampler, const glsl::BuiltinUniform* row) const {
        int first = 0;
        bool counts = false;
        if (row != nullptr && isNoise(*row)) {
            first = row->value == glsl::Builtin::noise2 ? scene::kNoise2Unit : scene::kNoise3Unit;
        } else if (const auto binding = interface_.facts.textureBindings.find(sampler.name);
                   binding != interface_.facts.textureBindings.end()) {
            first = binding->second;
            counts = true;
        }
        std::vector<int> units(static_cast<std::size_t>(std::max(sampler.arraySize, 1)), first);
        for (std::size_t i = 0; counts && i < units.size(); ++i) units[i] += static_cast<int>(i);
        return units;
    }

    void supply() {
        for (const UniformIndex i : rows_.indices())
            if (rows_[i] != nullptr && !isNoise(*rows_[i])) {
                UniformBinding& binding = result_.values.emplace_back();
                binding.uniform = i;
                binding.value.emplace<Supplied>(rows_[i]->value);
            }
    }

    /// Finds the uniforms whose values the command line replaces. A value that does not fit the type replaces
    /// nothing.
    void findOverridden() {
        for (const Override& each : overrides_) {
            if (!isFor(each, program_)) continue;
            for (const NamedUniform& named : names_.find(each.name))
                if (!readValue({each.name, each.form, each.values, {}, {}, each.written},
                               uniform(named.uniform), named.oneElement)
                         .ignored)
                    overridden_.insert({named.uniform, named.element});
        }
    }

    void applyPairs() {
        std::map<std::string_view, const glib::UniformSpec*> counting;  // the last of equal tags
        for (const glib::UniformSpec& spec : program_.uniforms) counting[spec.tag] = &spec;
        for (const glib::UniformSpec& spec : program_.uniforms) {
            if (counting.at(spec.tag) != &spec) continue;
            const GivenValue given{spec.tag, spec.form, spec.values, place(spec.tagPosition),
                                   place(spec.valuePosition)};
            const std::vector<NamedUniform> named = names_.find(spec.tag);
            if (named.empty() && !spec.mayBeUnknown) reportUnknown(given);
            for (const NamedUniform& each : named)
                apply(given, each, overridden_.contains({each.uniform, each.element}));
        }
    }

    void applyOverrides(std::vector<bool>& used) {
        if (used.size() < overrides_.size()) used.resize(overrides_.size());
        for (std::size_t i = 0; i < overrides_.size(); ++i) {
            const Override& each = overrides_[i];
            if (!isFor(each, program_)) continue;
            const GivenValue given{each.name, each.form, each.values, {}, {}, each.written};
            const std::vector<NamedUniform> named = names_.find(each.name);
            if (!named.empty()) used[i] = true;
            if (named.empty() && isSuppliedName(each.name)) {
                used[i] = true;
                reportSupplied(given);
            }
            for (const NamedUniform& one : named) apply(given, one, false);
        }
    }

    /// Binds the textures that the draw names to samplers and images. (Buffers belong to blocks.)
    void bindObjects() {
        if (drawn_.set == nullptr || drawn_.scene == nullptr) return;
        for (const scene::ObjectBinding& each : drawn_.set->objects) {
            const auto* view = std::get_if<scene::TextureView>(&each.object);
            if (view == nullptr) continue;
            const BoundTexture bound{*view, place(each.tagPosition)};
            const std::vector<NamedUniform> named = names_.find(each.tag);
            if (named.empty() && !each.mayBeUnknown)
                reportUnknown({each.tag, glib::UniformForm::number, {}, bound.place, bound.place});
            for (const NamedUniform& one : named) bind(one, bound);
        }
    }

    void bind(const NamedUniform& named, const BoundTexture& bound) {
        touched_[named.uniform] = true;
        if (auto problem = bindingProblem(*drawn_.scene, interface_, uniform(named.uniform), bound))
            return result_.badBindings.push_back(*std::move(problem));
        std::vector<std::optional<BoundTexture>>& elements = bound_[named.uniform];
        for (std::size_t i = 0; i < elements.size(); ++i)
            if (!named.oneElement || i == static_cast<std::size_t>(named.element)) elements[i] = bound;
    }

    /// What nothing has set reads the texture or the variable of its name, or a well-known value.
    void findByName() {
        if (drawn_.scene == nullptr || interface_.isBuiltin) return;
        const auto isUniform = [this](std::string_view name) { return names_.hasUniform(name); };
        for (const UniformIndex i : rows_.indices()) {
            const ActiveUniform& each = uniform(i);
            if (touched_[i] || rows_[i] != nullptr || isInternalName(each.name)) continue;
            if (isOpaque(each)) {
                for (const scene::TextureIndex texture : drawn_.scene->textures.indices())
                    if (drawn_.scene->textures[texture].name == each.name)
                        bind({i, 0, false}, {{.texture = texture}, program_.place});
                continue;
            }
            if (readVariable(i) || hasInitializer(each)) continue;
            if (each.block >= 0 || each.isArray) continue;
            const glsl::WellKnownUniform* row =
                glsl::findWellKnownUniform(each.name, each.type.word, isUniform);
            if (row == nullptr) continue;
            touched_[i] = true;
            UniformBinding& binding = result_.values.emplace_back();
            binding.uniform = i;
            binding.value.emplace<Supplied>(row->value);
            result_.foundByName.push_back(
                fmt::format("uniform '{}' is the {}", each.name, describe(row->value)));
        }
    }

    bool readVariable(UniformIndex index) {
        const ActiveUniform& target = uniform(index);
        for (const glib::UniformSpec& spec : drawn_.scene->namedValues) {
            if (spec.tag != target.name) continue;
            const Place at = place(spec.tagPosition);
            Reading reading = readValue({spec.tag, spec.form, spec.values, at, at}, target);
            append(result_.diagnostics, std::move(reading.diagnostics));
            if (reading.ignored) return false;
            touched_[index] = true;
            result_.values.push_back({index, 0, Literal{std::move(reading.values)}});
            result_.foundByName.push_back(fmt::format("uniform '{0}' is the variable '{0}'", target.name));
            return true;
        }
        return false;
    }

    bool hasInitializer(const ActiveUniform& target) const {
        const auto declared = interface_.facts.uniforms.find(std::string(rootName(target.name)));
        return declared != interface_.facts.uniforms.end() && declared->second.hasInitializer;
    }

    void apply(const GivenValue& given, const NamedUniform& named, bool isOverridden) {
        const ActiveUniform& target = uniform(named.uniform);
        const glsl::BuiltinUniform* row = rows_[named.uniform];
        if (row != nullptr && !isNoise(*row)) return reportSupplied(given);
        Reading reading = readValue(given, target, named.oneElement);
        if (isOverridden) {  // the scene's value is not used, but its slider stays
            if (reading.control) addControl(named.uniform, *reading.control);
            return;
        }
        append(result_.diagnostics, std::move(reading.diagnostics));
        if (reading.ignored) return;
        touched_[named.uniform] = true;
        if (isOpaque(target)) {
            std::vector<int>& units = units_[named.uniform];
            const auto first = static_cast<std::size_t>(named.element);
            for (std::size_t i = 0; i < reading.values.size() && first + i < units.size(); ++i)
                units[first + i] = static_cast<int>(reading.values[i]);
            if (row != nullptr)
                warn("glib-W25",
                     fmt::format("glibra supplies '{}'; the tag selects unit {} for it", given.tag,
                                 units.front()),
                     given.tagPlace);
            return;
        }
        if (!reading.values.empty()) setCurrent(named.uniform, reading.values.front());
        if (reading.control) addControl(named.uniform, *reading.control);
        result_.values.push_back({named.uniform, named.element, Literal{std::move(reading.values)}});
    }

    void setCurrent(UniformIndex index, double value) {
        for (Control& each : result_.controls)
            if (each.uniform == index && each.form != glib::UniformForm::color) each.current = value;
    }
    void addControl(UniformIndex index, Control control) {
        control.uniform = index;
        for (Control& each : result_.controls)
            if (each.uniform == index) {
                each = control;
                return;
            }
        result_.controls.push_back(control);
    }

    bool isDeclared(std::string_view name) const {
        return interface_.facts.uniforms.contains(std::string(name)) ||
               interface_.facts.uniforms.contains(std::string(rootName(name)));
    }

    void reportSupplied(const GivenValue& given) {
        if (given.tag == "Timer") {
            constexpr double kDefaultPeriod = 10;
            const bool isPeriod =
                given.form == glib::UniformForm::number && !given.values.empty() && given.values.front() > 0;
            const double period = isPeriod ? given.values.front() : kDefaultPeriod;
            return warn("glib-W25",
                        fmt::format("glibra supplies 'Timer'; set its period with the command "
                                    "'Timer {}'",
                                    numberText(period)),
                        given.tagPlace);
        }
        warn("glib-W25", fmt::format("glibra supplies '{}', so the tag has no effect", given.tag),
             given.tagPlace);
    }

    /// The tag names no active uniform: supplied but unused, declared but unused, or unknown.
    void reportUnknown(const GivenValue& given) {
        const std::string_view tag = given.tag;
        if (isSuppliedName(tag)) return reportSupplied(given);
        const std::string members = std::string(tag) + ".";
        const std::string elements = std::string(tag) + "[";
        std::string member;
        for (const ActiveUniform& each : interface_.uniforms)
            if (member.empty() && (each.name.starts_with(members) || each.name.starts_with(elements)))
                member = each.name;
        if (member.empty() && isDeclared(tag))
            return warn("glib-W24",
                        fmt::format("uniform '{}' is declared but unused, so the tag has no effect", tag),
                        given.tagPlace);
        const std::string hint =
            member.empty() ? suggestionFor(tag, knownNames()) : "; did you mean '" + member + "'?";
        warn("glib-W23", fmt::format("no shader of '{}' has a uniform '{}'{}", program_.name, tag, hint),
             given.tagPlace);
    }

    const std::vector<std::string>& knownNames() {
        if (knownNames_.empty()) {
            for (const ActiveUniform& each : interface_.uniforms)
                if (!isInternalName(each.name) && suppliedBy(each) == nullptr)
                    knownNames_.push_back(each.name);
            for (const auto& [name, declared] : interface_.facts.uniforms)
                if (!isInternalName(name)) knownNames_.push_back(name);
        }
        return knownNames_;
    }

    /// Reports glib-W37 for active uniforms without a value.
    void reportUnset() {
        if (interface_.isBuiltin) return;
        for (const UniformIndex i : rows_.indices()) {
            const ActiveUniform& each = uniform(i);
            if (touched_[i] || rows_[i] != nullptr || isInternalName(each.name)) continue;
            if (drawn_.isInBuffer && drawn_.isInBuffer(each)) continue;
            if (isOpaque(each)) {
                if (!interface_.facts.textureBindings.contains(each.name))
                    warn("glib-W37",
                         fmt::format("uniform '{}' of '{}' is not set; it reads unit 0", each.name,
                                     program_.name),
                         program_.place);
                continue;
            }
            if (hasInitializer(each)) continue;
            warn("glib-W37",
                 fmt::format("uniform '{}' of '{}' is not set; it is 0{}", each.name, program_.name,
                             modernHint(each)),
                 program_.place);
        }
    }

    /// What a classic scene has to do to get a matrix with a well-known name; empty if it is none.
    std::string modernHint(const ActiveUniform& target) const {
        const auto isUniform = [this](std::string_view name) { return names_.hasUniform(name); };
        if (drawn_.scene != nullptr || target.isArray || target.block >= 0 ||
            glsl::findWellKnownUniform(target.name, target.type.word, isUniform) == nullptr)
            return {};
        return "; scenes with a Camera or another modern statement supply it";
    }

    void listSamplers() {
        for (const UniformIndex i : units_.indices())
            for (std::size_t element = 0; element < units_[i].size(); ++element)
                result_.samplers.push_back(
                    {i, static_cast<int>(element), units_[i][element], bound_[i][element]});
    }

    const scene::Program& program_;
    const std::string& scenePath_;
    const ProgramInterface& interface_;
    std::span<const Override> overrides_;
    const DrawValues& drawn_;
    UniformNames names_;
    scene::List<const glsl::BuiltinUniform*, ActiveUniform> rows_;  ///< what supplies each uniform, or null
    scene::List<std::vector<int>, ActiveUniform> units_;  ///< of samplers and images, one per element
    /// Likewise; in place of the unit.
    scene::List<std::vector<std::optional<BoundTexture>>, ActiveUniform> bound_;
    scene::List<bool, ActiveUniform> touched_;  ///< a pair or an override gave it a value
    std::set<std::pair<UniformIndex, int>> overridden_;
    std::vector<std::string> knownNames_;
    UniformResolution result_;
};

}  // namespace

UniformResolution resolveUniforms(const scene::Program& program, const std::string& scenePath,
                                  const ProgramInterface& interface, std::span<const Override> overrides,
                                  std::vector<bool>& usedOverrides, const DrawValues& drawn) {
    return Resolver(program, scenePath, interface, overrides, drawn).resolve(usedOverrides);
}

}  // namespace glibra::plan
