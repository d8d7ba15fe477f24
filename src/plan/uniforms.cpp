#include "plan/uniforms.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include "plan/texture_binding.h"

namespace glibra::plan {
namespace {

const glsl::DeclaredUniform* factOf(const ProgramInterface& interface, std::string_view name) {
    const auto declared = interface.facts.uniforms.find(std::string(name));
    return declared == interface.facts.uniforms.end() ? nullptr : &declared->second;
}

}  // namespace

int declaredElements(const ProgramInterface& interface, const ActiveUniform& uniform) {
    if (const auto* declared = factOf(interface, uniform.name)) return declared->arraySize;
    const auto member = searchMember(interface.facts.memory, uniform.name);
    return member ? member->elements : 0;
}

bool hasInitializer(const ProgramInterface& interface, const ActiveUniform& uniform) {
    const auto* declared = factOf(interface, rootName(uniform.name));
    return declared != nullptr && declared->hasInitializer;
}

const std::vector<std::string>* functionsOf(const ProgramInterface& interface, const ActiveUniform& uniform) {
    const auto* declared = factOf(interface, rootName(uniform.name));
    return declared == nullptr || declared->subroutines.empty() ? nullptr : &declared->subroutines;
}

std::optional<std::array<double, 9>> upperLeft(const GivenValue& given, const ActiveUniform& target,
                                               bool oneElement) {
    constexpr std::size_t kSide = 4;
    const bool isMat3 = target.type.columns == 3 && target.type.rows == 3 && (!target.isArray || oneElement);
    if (!isMat3 || given.form != glib::UniformForm::list || given.values.size() != kSide * kSide)
        return std::nullopt;
    std::array<double, 9> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = given.values[i / 3 * kSide + i % 3];
    return values;
}

bool isMatrixInstead(const GivenValue& given, const ActiveUniform& target, const NamedUniform& named) {
    return given.form == glib::UniformForm::list && (given.values.size() == 9 || given.values.size() == 16) &&
           !target.type.isOpaque() && target.type.columns == 1 && (!target.isArray || named.oneElement);
}

std::string_view describeValue(glsl::Builtin value) {
    using enum glsl::Builtin;
    constexpr std::pair<glsl::Builtin, std::string_view> kNames[] = {
        {modelView, "model-view matrix"},
        {projection, "projection matrix"},
        {modelViewProjection, "model-view-projection matrix"},
        {normalMatrix, "normal matrix"},
        {modelViewInverseTranspose, "inverse transpose of the model-view matrix"},
        {modelViewProjectionInverse, "inverse of the model-view-projection matrix"},
        {projectionInverse, "inverse of the projection matrix"},
        {model, "model matrix"},
        {modelInverse, "inverse of the model matrix"},
        {modelInverseTranspose, "inverse transpose of the model matrix"},
        {modelNormalMatrix, "normal matrix in world space"},
        {view, "view matrix"},
        {viewInverse, "inverse of the view matrix"},
        {viewProjection, "projection matrix times the view matrix"},
        {eyePosition, "position of the camera"},
    };
    for (const auto& [known, name] : kNames)
        if (known == value) return name;
    return "value that glibra supplies";
}

namespace {

bool isNoiseUniform(const glsl::BuiltinUniform& row) {
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
          lost_(interface.uniforms.size()),
          touched_(interface.uniforms.size()) {
        for (const ActiveUniform& uniform : interface.uniforms) {
            rows_.push_back(suppliedBy(uniform));
            units_.push_back(uniform.type.isOpaque() ? defaultUnits(uniform, rows_.back())
                                                     : std::vector<int>());
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
    /// The place of a tag: the Program statement's own ones stand in its file, and those of a draw in the
    /// draw's.
    Place place(glib::Position position, bool isOwn = false) const {
        const std::string& own = program_.place.file;
        const bool isOfProgram = !own.empty() && (isOwn || position.line == program_.place.line);
        return {isOfProgram ? own : scenePath_, position.line, position.column};
    }
    void warn(const char* id, std::string text, const Place& place) {
        result_.diagnostics.push_back(diagnose(id, std::move(text), place));
    }

    /// The units of a sampler without a tag: the noise texture's, layout(binding), or 0.
    std::vector<int> defaultUnits(const ActiveUniform& sampler, const glsl::BuiltinUniform* row) const {
        int first = 0;
        bool counts = false;
        if (row != nullptr && isNoiseUniform(*row)) {
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
            if (rows_[i] != nullptr && !isNoiseUniform(*rows_[i])) {
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
                if (!each.word.empty()) {
                    if (functionsOf(interface_, uniform(named.uniform)) != nullptr)
                        overridden_.insert({named.uniform, named.element});
                } else if (!readValue({each.name, each.form, each.values, {}, {}, each.written},
                                      uniform(named.uniform), named.oneElement)
                                .ignored)
                    overridden_.insert({named.uniform, named.element});
        }
    }

    void applyPairs() {
        // What a draw gives follows what the Program statement gives.
        const std::size_t ownCount =
            program_.uniforms.size() - (drawn_.set != nullptr ? drawn_.set->values.size() : 0);
        std::map<std::string_view, const glib::UniformSpec*> counting;  // the last of equal tags
        for (const glib::UniformSpec& spec : program_.uniforms) counting[spec.tag] = &spec;
        for (const glib::UniformSpec& spec : program_.uniforms) {
            if (counting.at(spec.tag) != &spec) continue;
            const bool isOwn = static_cast<std::size_t>(&spec - program_.uniforms.data()) < ownCount;
            const GivenValue given{spec.tag, spec.form, spec.values, place(spec.tagPosition, isOwn),
                                   place(spec.valuePosition, isOwn)};
            const std::vector<NamedUniform> named = names_.find(spec.tag);
            const bool isChosen = choosesObject(spec.tag);
            // A word for a block is reported with the block's buffer.
            const bool isOfBlock =
                (isChosen || !spec.word.empty()) && namesMemory(interface_.facts.memory, spec.tag);
            if (named.empty() && !spec.mayBeUnknown && !isOfBlock) messages_.unknown(given, spec.resembles);
            for (const NamedUniform& each : named)
                if (!isChosen || !uniform(each.uniform).type.isOpaque())
                    apply(given, each, overridden_.contains({each.uniform, each.element}), spec.word);
        }
    }

    void applyOverrides(std::vector<bool>& used) {
        if (used.size() < overrides_.size()) used.resize(overrides_.size());
        for (std::size_t i = 0; i < overrides_.size(); ++i) {
            const Override& each = overrides_[i];
            if (!isFor(each, program_)) continue;
            const GivenValue given{each.name, each.form, each.values, {}, {}, each.written};
            std::vector<NamedUniform> named = names_.find(each.name);
            if (!each.word.empty())
                std::erase_if(named, [&](const NamedUniform& one) {
                    return !functionsOf(interface_, uniform(one.uniform));
                });
            if (!named.empty() || messages_.isUnreadPart(each.name)) used[i] = true;
            if (named.empty() && isSuppliedName(each.name)) {
                used[i] = true;
                messages_.supplied(given);
            }
            for (const NamedUniform& one : named) apply(given, one, false, each.word);
        }
    }

    /// Binds the textures and buffers that the draw names to samplers and images. (Blocks have their own
    /// buffers.)
    void bindObjects() {
        if (drawn_.set == nullptr || drawn_.scene == nullptr) return;
        for (const std::string& each : drawn_.set->lost)
            for (const NamedUniform& one : names_.find(each))
                touched_[one.uniform] = lost_[one.uniform] = true;
        for (const scene::ObjectBinding& each : drawn_.set->objects) {
            BoundTexture bound{{}, place(each.tagPosition)};
            const auto* view = std::get_if<scene::TextureView>(&each.object);
            if (view != nullptr)
                bound.view = *view;
            else
                bound.buffer = std::get<scene::BufferView>(each.object);
            std::vector<NamedUniform> named = names_.find(each.tag);
            if (each.isChosen ||
                (view == nullptr && namesMemory(interface_.facts.memory, rootName(each.tag))))
                std::erase_if(named,
                              [&](const NamedUniform& one) { return !uniform(one.uniform).type.isOpaque(); });
            else if (named.empty() && !each.mayBeUnknown)
                messages_.unknown({each.tag, glib::UniformForm::number, {}, bound.place, bound.place},
                                  each.resembles);
            for (const NamedUniform& one : named) bind(one, bound);
        }
    }

    /// True for a tag whose word names a texture or buffer.
    bool choosesObject(std::string_view tag) const {
        return drawn_.set != nullptr &&
               std::ranges::any_of(drawn_.set->objects, [&](const scene::ObjectBinding& each) {
                   return each.isChosen && each.tag == tag;
               });
    }

    void bind(const NamedUniform& named, const BoundTexture& bound) {
        touched_[named.uniform] = true;
        if (auto problem = bindingProblem(*drawn_.scene, interface_, uniform(named.uniform), bound)) {
            if (uniform(named.uniform).type.base == BaseType::image)
                result_.refusedImages.push_back(bound.buffer.buffer ? scene::ObjectView(bound.buffer)
                                                                    : scene::ObjectView(bound.view));
            return result_.badBindings.push_back(*std::move(problem));
        }
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
            if (each.type.isOpaque()) {
                if (samplerTypeOf(each.type.word).isBuffer) {
                    for (const scene::BufferIndex buffer : drawn_.scene->buffers.indices())
                        if (drawn_.scene->buffers[buffer].name == each.name)
                            bind({i, 0, false}, {{}, program_.place, {buffer}});
                    continue;
                }
                for (const scene::TextureIndex texture : drawn_.scene->textures.indices())
                    if (drawn_.scene->textures[texture].name == each.name)
                        bind({i, 0, false}, {{.texture = texture}, program_.place});
                continue;
            }
            if (readVariable(i) || hasInitializer(interface_, each)) continue;
            if (each.block >= 0 || each.isArray) continue;
            const auto value = glsl::wellKnownUniform(each.name, each.type.word, isUniform);
            if (!value) continue;
            touched_[i] = true;
            UniformBinding& binding = result_.values.emplace_back();
            binding.uniform = i;
            binding.value.emplace<Supplied>(*value);
            result_.foundByName.push_back(
                fmt::format("uniform '{}' is the {}", each.name, describeValue(*value)));
        }
    }

    bool readVariable(UniformIndex index) {
        const ActiveUniform& target = uniform(index);
        for (const auto& values : {drawn_.ownValues, std::span(drawn_.scene->namedValues)})
            for (const glib::UniformSpec& spec : values)
                if (spec.tag == target.name) return readVariable(index, spec);
        return false;
    }

    bool readVariable(UniformIndex index, const glib::UniformSpec& spec) {
        const ActiveUniform& target = uniform(index);
        const Place at = place(spec.tagPosition);
        GivenValue given{spec.tag, spec.form, spec.values, at, at};
        std::optional<double> number;
        if (!spec.word.empty() && functionsOf(interface_, uniform(index)) != nullptr) {
            number = numberOf(spec.word, given, index);
            if (number) given.values = {&*number, 1};
        }
        const auto part = upperLeft(given, target, false);
        if (part) given.values = *part;
        Reading reading = readValue(given, target, false, declaredElements(interface_, target));
        append(result_.diagnostics, std::move(reading.diagnostics));
        if (reading.ignored) return false;
        touched_[index] = true;
        result_.values.push_back({index, 0, Literal{std::move(reading.values)}});
        result_.foundByName.push_back(fmt::format("uniform '{0}' is the variable '{0}'", target.name));
        if (spec.changesWithTime) result_.timed.push_back(spec.tag);
        return true;
    }

    /// The number of the function that a word names. Nothing with glib-E16 or E27 reported.
    std::optional<double> numberOf(std::string_view word, const GivenValue& given, UniformIndex index) {
        const std::vector<std::string>* functions = functionsOf(interface_, uniform(index));
        if (functions == nullptr) {
            result_.diagnostics.push_back(unknownWord(*drawn_.scene, word, given.valuePlace));
            return std::nullopt;
        }
        const auto found = std::ranges::find(*functions, word);
        if (found != functions->end()) return static_cast<double>(found - functions->begin());
        warn("glib-E16",
             fmt::format("subroutine uniform '{}' has no function '{}'{}", given.tag, word,
                         suggestionFor(word, *functions)),
             given.valuePlace);
        return std::nullopt;
    }

    /// `word`: UniformSpec::word.
    void apply(GivenValue given, const NamedUniform& named, bool isOverridden, std::string_view word = {}) {
        std::optional<double> number;
        if (!word.empty() &&
            (given.values.empty() || functionsOf(interface_, uniform(named.uniform)) != nullptr ||
             uniform(named.uniform).type.isOpaque())) {
            number = numberOf(word, given, named.uniform);
            if (!number) {
                touched_[named.uniform] = true;
                return;
            }
            given.form = glib::UniformForm::number;
            given.values = {&*number, 1};
        }
        const ActiveUniform& target = uniform(named.uniform);
        const glsl::BuiltinUniform* row = rows_[named.uniform];
        if (row != nullptr && !isNoiseUniform(*row)) return messages_.supplied(given);
        const auto part = drawn_.scene != nullptr ? upperLeft(given, target, named.oneElement) : std::nullopt;
        if (part) given.values = *part;
        if (drawn_.scene != nullptr && isMatrixInstead(given, target, named)) {
            touched_[named.uniform] = true;
            result_.badBindings.push_back(
                diagnose("glib-E30",
                         fmt::format("'{}' is a {}, but its value has {} numbers, as a mat{}", given.tag,
                                     target.type.word, given.values.size(), given.values.size() == 9 ? 3 : 4),
                         given.valuePlace));
            return;
        }
        Reading reading = readValue(given, target, named.oneElement, declaredElements(interface_, target));
        if (isOverridden) {  // the scene's value is not used, but its slider stays
            if (reading.control) addControl(named.uniform, *reading.control);
            return;
        }
        append(result_.diagnostics, std::move(reading.diagnostics));
        if (reading.ignored) return;
        touched_[named.uniform] = true;
        if (target.type.isOpaque()) {
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

    /// Reports glib-W37 for active uniforms without a value, and for all members of a structure of which one
    /// is active.
    void reportUnset() {
        if (interface_.isBuiltin) return;
        std::vector<ActiveUniform> unset;
        std::set<std::string_view> structures;
        for (const UniformIndex i : rows_.indices()) {
            const ActiveUniform& each = uniform(i);
            const bool isMember = interface_.facts.memory.records.contains(rootName(each.name));
            if ((touched_[i] && !isMember) || rows_[i] != nullptr || isInternalName(each.name)) continue;
            if (drawn_.isInBuffer && drawn_.isInBuffer(each)) continue;
            if (each.type.isOpaque()) {
                if (!touched_[i] && !interface_.facts.textureBindings.contains(each.name))
                    result_.diagnostics.push_back(
                        about(diagnose("glib-W37",
                                       fmt::format("uniform '{}' of '{}' is not set; it reads unit 0",
                                                   each.name, program_.name),
                                       program_.place),
                              each.name));
                continue;
            }
            if (hasInitializer(interface_, each)) continue;
            if (const std::vector<std::string>* functions = functionsOf(interface_, uniform(i))) {
                const auto& declared = interface_.facts.uniforms.at(std::string(rootName(each.name)));
                warn("glsl-W19",
                     fmt::format("subroutine uniform '{}' uses its first function '{}'", rootName(each.name),
                                 functions->front()),
                     declared.place);
                continue;
            }
            if (each.block < 0 && isMember) {
                const std::string_view root = rootName(each.name);
                if (structures.contains(root)) continue;
                if (addUnsetMembers(root, unset)) {
                    structures.insert(root);
                    continue;
                }
            }
            if (!touched_[i]) unset.push_back(each);
        }
        messages_.unset(unset);
    }

    /// Adds the members that have no value. False if the text does not show which there are.
    bool addUnsetMembers(std::string_view root, std::vector<ActiveUniform>& unset) const {
        return visitMembers(interface_.facts.memory, root, [&](const MemberValue& member) {
            ActiveUniform value{.name = member.name, .type = {.word = std::string(member.type)}};
            value.isArray = member.isArray;
            const bool isUnit = member.type.find("sampler") != std::string_view::npos ||
                                member.type.find("image") != std::string_view::npos;
            if (!isUnit && !hasValue(value)) unset.push_back(std::move(value));
            return true;
        });
    }

    /// The same for a member that the driver may not call active.
    bool hasValue(const ActiveUniform& member) const {
        const std::vector<NamedUniform> active = names_.find(member.name);
        if (!active.empty()) return touched_[active.front().uniform];
        const auto isOf = [&](std::string_view tag) {
            return tag.starts_with(member.name) &&
                   (tag.size() == member.name.size() || (member.isArray && tag[member.name.size()] == '['));
        };
        const auto isGiven = [&](const glib::UniformSpec& each) { return isOf(each.tag); };
        if (std::ranges::any_of(program_.uniforms, isGiven)) return true;
        if (std::ranges::any_of(
                overrides_, [&](const Override& each) { return isFor(each, program_) && isOf(each.name); }))
            return true;
        if (drawn_.scene == nullptr) return false;
        const auto isUniform = [this](std::string_view name) { return names_.hasUniform(name); };
        return std::ranges::any_of(drawn_.ownValues, isGiven) ||
               std::ranges::any_of(drawn_.scene->namedValues, isGiven) ||
               (!member.isArray && glsl::wellKnownUniform(member.name, member.type.word, isUniform));
    }

    void listSamplers() {
        for (const UniformIndex i : units_.indices())
            for (std::size_t element = 0; element < units_[i].size(); ++element)
                result_.samplers.push_back(
                    {i, static_cast<int>(element), units_[i][element], bound_[i][element], lost_[i]});
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
    scene::List<bool, ActiveUniform> lost_;     ///< SamplerBinding::isLost
    scene::List<bool, ActiveUniform> touched_;  ///< a pair or an override gave it a value
    std::set<std::pair<UniformIndex, int>> overridden_;
    UniformResolution result_;
    UniformMessages messages_{program_, interface_, names_, drawn_.scene, result_.diagnostics};
};

}  // namespace

UniformResolution resolveUniforms(const scene::Program& program, const std::string& scenePath,
                                  const ProgramInterface& interface, std::span<const Override> overrides,
                                  std::vector<bool>& usedOverrides, const DrawValues& drawn) {
    return Resolver(program, scenePath, interface, overrides, drawn).resolve(usedOverrides);
}

}  // namespace glibra::plan
