#include "plan/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

#include "base/text.h"
#include "glib/number.h"
#include "glib/text.h"
#include "plan/accesses.h"
#include "plan/uniform_names.h"

namespace glibra::plan {
namespace {

constexpr std::size_t kMostValues = 4096;  // as in a bracket of the language

/// Adds the numbers, which blanks or single commas separate. Returns what is wrong; nothing if all is right.
std::string readNumbers(std::string_view text, std::vector<double>& values) {
    while (!text.empty()) {
        const std::string_view token = text.substr(0, text.find_first_of(" \t,"));
        const auto number = glib::numberPrefix(token);
        if (token.empty()) return "a number is missing beside ','";
        if (!number || number->length < token.size()) return fmt::format("'{}' is not a number", token);
        if (!number->finite) return fmt::format("'{}' is too large for a 32-bit float", token);
        if (values.size() == kMostValues) return fmt::format("more than {} values", kMostValues);
        values.push_back(number->value);
        text = base::trimmed(text.substr(token.size()));
        if (!text.starts_with(',')) continue;
        text = base::trimmed(text.substr(1));
        if (text.empty()) return "a number is missing after the last ','";
    }
    return values.empty() ? "the value is missing" : "";
}

/// True for a word that may be one of a choice. Spellings of what is not finite are none.
bool isChoiceWord(std::string_view text) {
    if (text.empty() || !glib::beginsName(text[0])) return false;
    const bool isWord = std::ranges::all_of(text, glib::isOfName);
    return isWord && !glib::sameWord(text, "nan") && !glib::sameWord(text, "inf") &&
           !glib::sameWord(text, "infinity");
}

/// Removes the brackets. Returns nothing if the closing one is missing.
std::optional<glib::UniformForm> takeBrackets(std::string_view& value) {
    struct Bracket {
        char open, close;
        glib::UniformForm form;
    };
    constexpr Bracket kBrackets[] = {{'[', ']', glib::UniformForm::list},
                                     {'(', ')', glib::UniformForm::list},
                                     {'<', '>', glib::UniformForm::range},
                                     {'{', '}', glib::UniformForm::color}};
    for (const Bracket& each : kBrackets) {
        if (!value.starts_with(each.open)) continue;
        if (value.size() < 2 || !value.ends_with(each.close)) return {};
        value = base::trimmed(value.substr(1, value.size() - 2));
        return each.form;
    }
    return glib::UniformForm::number;
}

Diagnostic notAFunction(std::string_view program, std::string_view name, std::string_view word) {
    return withoutId(
        Severity::error,
        fmt::format("--set {0}:{1}={2}: '{2}' is not a number, and program {3} has no subroutine "
                    "uniform '{1}'",
                    program, name, word, glib::inQuotes(program)));
}

}  // namespace

Result<Override> parseOverride(std::string_view text) {
    const auto bad = [&](std::string_view why) {
        return withoutId(Severity::error, fmt::format("--set {}: {}", text, why));
    };
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return bad("expected NAME=VALUE");
    Override result;
    result.name = base::trimmed(text.substr(0, equals));
    if (const std::size_t colon = result.name.rfind(':'); colon != std::string::npos) {
        result.program = base::trimmed(std::string_view(result.name).substr(0, colon));
        result.name = base::trimmed(std::string(result.name.substr(colon + 1)));
    }
    if (result.name.empty()) return bad("the name is missing");

    std::string_view value = base::trimmed(text.substr(equals + 1));
    result.written = value;
    const std::optional<glib::UniformForm> form = takeBrackets(value);
    if (!form) return bad("a bracket is not closed");
    result.form = *form;
    if (value == "true" || value == "false") {
        result.form = glib::UniformForm::truth;
        result.values = {value == "true" ? 1.0 : 0.0};
        return result;
    }
    if (result.form == glib::UniformForm::number && isChoiceWord(value)) {
        result.word = value;
        return result;
    }
    if (const std::string problem = readNumbers(value, result.values); !problem.empty()) return bad(problem);
    if (result.form == glib::UniformForm::number && result.values.size() > 1)
        result.form = glib::UniformForm::list;
    return result;
}

Diagnostic notAChoice(std::string_view name, std::string_view word) {
    return withoutId(Severity::error,
                     fmt::format("--set {0}={1}: '{1}' is not a number, and the scene has no "
                                 "choice '{0}' with words",
                                 name, word));
}

bool isFor(const Override& override, const scene::Program& program) {
    return override.program.empty() || override.program == program.name ||
           override.program == std::to_string(program.place.line);
}

Diagnostics unusedOverrides(std::span<const Override> overrides, const std::vector<bool>& used,
                            std::span<const std::string> names) {
    Diagnostics diagnostics;
    for (std::size_t i = 0; i < overrides.size(); ++i) {
        if (i < used.size() && used[i]) continue;
        const auto& [name, form, values, program, written, word] = overrides[i];
        if (!word.empty()) {
            diagnostics.push_back(program.empty() ? notAChoice(name, word)
                                                  : notAFunction(program, name, word));
            continue;
        }
        const std::string where =
            program.empty() ? "program of the scene" : "program " + glib::inQuotes(program);
        const bool isElsewhere = std::ranges::find(names, name) != names.end();
        const std::string near = isElsewhere ? "" : nearestUniform(name, names);
        diagnostics.push_back(about(diagnose("glib-W23", fmt::format("no {} has a uniform {}{}", where,
                                                                     glib::inQuotes(name), hintOf(near))),
                                    name, near));
    }
    return diagnostics;
}

Diagnostic misfit(std::string_view name, std::span<const double> values, std::size_t components) {
    std::string text;
    for (const double each : values) text += (text.empty() ? "" : ",") + glib::numberText(each);
    return diagnose("glib-W15", fmt::format("--set {0}={1}: {2}; '{0}' takes {3}, so it keeps its own", name,
                                            text, base::counted(values.size(), "value"), components));
}

// ---- Names without effect

namespace {

// Finds textures that the frame reads before it writes them.

/// What a node of the frame does with textures, whether or not it is planned.
struct NodeTextures {
    struct Read {
        scene::TextureIndex texture;
        bool isPrevious = false;
        Place place;
    };
    std::vector<Read> reads;                ///< by samplers
    std::set<scene::TextureIndex> written;  ///< or parts of them
    std::set<Object> uses, changes;         ///< everything that shaders read and write
    Place place;
};

std::vector<NodeTextures> declaredNodes(const scene::NodeList& frame) {
    std::vector<NodeTextures> nodes;
    for (const scene::NodeIndex& each : frame.order) {
        NodeTextures node;
        node.place = frame.placeOf(each);
        if (each.kind == scene::NodeIndex::Kind::pass) {
            const scene::Pass& pass = frame.passes.at(each.index);
            node.written.insert(pass.targets.begin(), pass.targets.end());
            if (pass.depth) node.written.insert(pass.depth->texture);
        } else if (each.kind == scene::NodeIndex::Kind::clear) {
            if (const auto* texture = std::get_if<scene::TextureIndex>(&frame.clears.at(each.index).object))
                node.written.insert(*texture);
        }
        nodes.push_back(std::move(node));
    }
    return nodes;
}

void addReads(const std::vector<TextureUse>& uses, const Place& place, NodeTextures& node) {
    for (const TextureUse& each : uses)
        if (!each.isImage && each.view.texture)
            node.reads.push_back({each.view.texture, each.view.isPrevious, place});
}

std::vector<NodeTextures> nodesOf(const FramePlan& plan) {
    std::vector<NodeTextures> nodes = declaredNodes(*plan.nodes);
    std::map<scene::NodeIndex, std::size_t> positions;
    for (std::size_t i = 0; i < nodes.size(); ++i) positions.emplace(plan.nodes->order[i], i);
    for (std::size_t i = 0; i < plan.order.size(); ++i) {
        NodeTextures& node = nodes.at(positions.at(plan.declared(plan.order[i])));
        node.changes = plan.accesses[i].written;
        for (const Object& each : node.changes)
            if (const auto* texture = std::get_if<scene::TextureIndex>(&each)) node.written.insert(*texture);
        for (const ObjectUse& each : plan.accesses[i].uses)
            if (each.reads) node.uses.insert(objectOf(each.object));
        if (plan.order[i].kind == scene::NodeIndex::Kind::dispatch) {
            const PlannedDispatch& dispatch = plan.dispatches.at(plan.order[i].index);
            addReads(dispatch.textures, plan.dispatchOf(dispatch).place, node);
        } else if (plan.order[i].kind == scene::NodeIndex::Kind::pass) {
            for (const auto& step : plan.passes.at(plan.order[i].index).steps)
                if (const auto* draw = std::get_if<PlannedDraw>(&step))
                    addReads(draw->textures, plan.drawOf(*draw).place, node);
        }
    }
    return nodes;
}

/// The node after `reader` that writes the texture first. Nothing if there is none, or if it needs what the
/// reader writes, since then the two cannot change their places.
std::optional<std::size_t> writerAfter(const std::vector<NodeTextures>& nodes, std::size_t reader,
                                       scene::TextureIndex texture) {
    std::set<Object> results = nodes[reader].changes;
    for (std::size_t i = reader + 1; i < nodes.size(); ++i) {
        const bool needsResults = std::ranges::any_of(
            nodes[i].uses, [&](const Object& object) { return results.contains(object); });
        if (nodes[i].written.contains(texture))
            return needsResults ? std::nullopt : std::optional<std::size_t>(i);
        if (needsResults) results.insert(nodes[i].changes.begin(), nodes[i].changes.end());
    }
    return std::nullopt;
}

/// The reads of zeros by one statement; of previous copies by all statements.
struct ZeroReads {
    bool isAlways = true;
    std::size_t node = 0;  ///< the first one
    Place place;
};

/// draw-W11 for textures with a name that the frame samples before a pass, dispatch or Clear of the
/// frame writes them, and for the previous copies of textures with history that only the frame writes: a
/// frame begins with both as declared, which is zero. A statement that also runs after the write, as in a
/// Repeat, is not reported, nor is one whose result the write needs. `lasting`: what Once and Step write.
Diagnostics reportEarlyReads(const scene::Scene& scene, const FramePlan& frame,
                             const std::set<scene::TextureIndex>& lasting) {
    const std::vector<NodeTextures> nodes = nodesOf(frame);
    std::map<scene::TextureIndex, int> writers;  // so far
    std::map<std::tuple<scene::TextureIndex, bool, std::string, int, int>, ZeroReads> found;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        for (const NodeTextures::Read& each : nodes[i].reads) {
            const scene::Texture& texture = scene.textures[each.texture];
            if (texture.name.empty() || lasting.contains(each.texture) ||
                !std::holds_alternative<scene::EmptySource>(texture.source))
                continue;
            // The first writer exchanges the copies, after which both have been zero.
            const int zeros = each.isPrevious && !nodes[i].written.contains(each.texture) ? 1 : 0;
            const bool isZero = writers[each.texture] <= zeros &&
                                (each.isPrevious || !nodes[i].written.contains(each.texture));
            const auto key = each.isPrevious ? std::tuple(each.texture, true, std::string(), 0, 0)
                                             : std::tuple(each.texture, false, each.place.file,
                                                          each.place.line, each.place.column);
            const auto known = found.try_emplace(key, ZeroReads{true, i, each.place}).first;
            known->second.isAlways = known->second.isAlways && isZero;
        }
        for (const scene::TextureIndex each : nodes[i].written) ++writers[each];
    }
    Diagnostics diagnostics;
    std::set<scene::TextureIndex> reported;
    for (const auto& [key, reads] : found) {
        const auto& [texture, isPrevious, file, line, column] = key;
        if (!reads.isAlways || writers[texture] == 0 || reported.contains(texture)) continue;
        const std::string& name = scene.textures[texture].name;
        const auto writer = isPrevious ? std::nullopt : writerAfter(nodes, reads.node, texture);
        if (!isPrevious && !writer) continue;
        reported.insert(texture);
        diagnostics.push_back(diagnose(
            "draw-W11",
            isPrevious ? fmt::format("'{}.prev' is read here, but only the frame writes '{}', so it is zero; "
                                     "write '{}' in Step",
                                     name, name, name)
                       : fmt::format("texture '{}' is read here, but written only below (line {}), so it is "
                                     "zero; write it before this line",
                                     name, nodes[*writer].place.line),
            reads.place));
    }
    return diagnostics;
}

/// The first program that declares the uniform without using it; null if none does. Drivers differ in which
/// unused uniforms they keep.
const scene::Program* declaringUnused(const scene::Scene& scene, std::span<const FramePlan* const> plans,
                                      const Override& override) {
    for (const FramePlan* plan : plans)
        for (const PlannedProgram& program : plan->programs) {
            const scene::ProgramIndex own = program.variant.program;
            if (own && isFor(override, scene.programs[own]) &&
                program.interface->facts.uniforms.contains(std::string(rootName(override.name))))
                return &scene.programs[own];
        }
    return nullptr;
}

/// The programs of the scene that linked in one of the plans.
std::set<scene::ProgramIndex> knownPrograms(std::span<const FramePlan* const> plans) {
    std::set<scene::ProgramIndex> known;
    for (const FramePlan* plan : plans)
        for (const PlannedProgram& program : plan->programs)
            if (program.interface->usable) known.insert(program.variant.program);
    return known;
}

Diagnostics reportOverrides(const scene::Scene& scene, std::span<const FramePlan* const> plans,
                            std::span<const Override> overrides) {
    std::vector<bool> used(overrides.size());
    std::vector<std::string> names;
    for (const scene::Variable& each : scene.variables) names.push_back(each.name);
    for (const FramePlan* plan : plans) {
        for (std::size_t i = 0; i < used.size(); ++i)
            if (plan->usedOverrides.at(i)) used[i] = true;
        for (const PlannedProgram& program : plan->programs)
            for (const ActiveUniform& uniform : program.interface->uniforms)
                if (!isInternalName(uniform.name) && suppliedBy(uniform) == nullptr)
                    names.push_back(uniform.name);
    }
    const std::set<scene::ProgramIndex> known = knownPrograms(plans);
    for (const scene::ProgramIndex i : scene.programs.indices()) {
        if (known.contains(i)) continue;
        for (const glib::UniformSpec& spec : scene.programs[i].uniforms)
            for (std::size_t each = 0; each < overrides.size(); ++each)
                if (overrides[each].name == spec.tag) used[each] = true;
    }
    Diagnostics diagnostics;
    for (std::size_t i = 0; i < overrides.size(); ++i) {
        if (used[i] || !overrides[i].word.empty()) continue;
        const scene::Program* const program = declaringUnused(scene, plans, overrides[i]);
        if (program == nullptr) continue;
        used[i] = true;
        diagnostics.push_back(
            about(diagnose("glib-W24",
                           fmt::format("uniform '{}' is declared but unused, so setting it has no effect",
                                       overrides[i].name)),
                  program->name));
    }
    append(diagnostics, unusedOverrides(overrides, used, names));
    return diagnostics;
}

/// True if the tag names a uniform, a member of a uniform block or memory of the program.
bool has(const ProgramInterface& interface, std::string_view tag) {
    const std::string root(rootName(tag));
    if (tag.find('.') == std::string_view::npos && namesMemory(interface.facts.memory, root)) return true;
    if (const auto search = searchMember(interface.facts.memory, tag)) return search->isDeclared;
    const std::string member = "." + root;
    return interface.facts.uniforms.contains(root) || namesMemory(interface.facts.memory, root) ||
           std::ranges::any_of(interface.uniforms, [&](const ActiveUniform& each) {
               return rootName(each.name) == root || each.name.ends_with(member);
           });
}

bool isKnown(std::string_view tag, std::span<const FramePlan* const> plans) {
    return isSuppliedName(rootName(tag)) || std::ranges::any_of(plans, [&](const FramePlan* plan) {
               return std::ranges::any_of(
                   plan->programs, [&](const PlannedProgram& each) { return has(*each.interface, tag); });
           });
}

std::vector<std::string> declaredUniforms(std::span<const FramePlan* const> plans) {
    std::vector<std::string> names;
    for (const FramePlan* plan : plans)
        for (const PlannedProgram& program : plan->programs) {
            for (const auto& [name, declared] : program.interface->facts.uniforms)
                if (!isInternalName(name) && !isSuppliedName(name)) names.push_back(name);
            addMemory(program.interface->facts.memory, names);
        }
    return names;
}

/// The name that was meant, if a name looks misspelt. Names of a row (uLight1, uLight2) do not: a Set is for
/// all programs, and not all of them need the whole row.
std::string misspelling(std::string_view whole, std::span<const std::string> names) {
    const std::string_view tag = rootName(whole);
    const auto withoutDigits = [](std::string_view name) {
        std::string text(name);
        std::erase_if(text, [](char c) { return c >= '0' && c <= '9'; });
        return text;
    };
    const std::string base = withoutDigits(tag);
    if (std::ranges::any_of(names, [&](const std::string& each) { return withoutDigits(each) == base; }))
        return {};
    const std::string nearest = nearestUniform(tag, names);
    return nearest.empty() ? nearest : fmt::format("{}{}", nearest, whole.substr(tag.size()));
}

/// The hint for a tag that no program has: what is wrong with its members, or its misspelt root. Empty if the
/// tag does not look like a mistake.
MemberSearch hintFor(std::string_view tag, std::span<const FramePlan* const> plans) {
    for (const FramePlan* plan : plans)
        for (const PlannedProgram& program : plan->programs)
            if (const auto search = searchMember(program.interface->facts.memory, tag)) return *search;
    const std::string meant = misspelling(tag, declaredUniforms(plans));
    return {false, hintOf(meant), meant};
}

Diagnostics reportSets(const scene::Scene& scene, std::span<const FramePlan* const> plans) {
    Diagnostics diagnostics;
    for (const auto& [tag, place] : scene.setNames) {
        if (isKnown(tag, plans)) continue;
        const std::set<scene::ProgramIndex> known = knownPrograms(plans);
        for (const scene::ProgramIndex i : scene.programs.indices())
            if (!known.contains(i)) return {};  // it may have any name
        if (const MemberSearch found = hintFor(tag, plans); !found.hint.empty())
            diagnostics.push_back(about(
                diagnose("glib-W23",
                         fmt::format("no program of the scene has a uniform '{}'{}", tag, found.hint), place),
                tag, found.suggestion));
    }
    return diagnostics;
}

/// The textures that passes and Clear of the list write.
void addWritten(const scene::NodeList& nodes, std::set<scene::TextureIndex>& written) {
    for (const scene::Pass& pass : nodes.passes) {
        written.insert(pass.targets.begin(), pass.targets.end());
        if (pass.depth) written.insert(pass.depth->texture);
    }
    for (const scene::ClearObject& each : nodes.clears)
        if (const auto* texture = std::get_if<scene::TextureIndex>(&each.object)) written.insert(*texture);
}

/// Those that the shaders of the plan write as images.
void addWritten(const FramePlan& plan, std::set<scene::TextureIndex>& written) {
    plan.visitStatements([&](const auto& planned, const auto&) {
        for (const TextureUse& each : planned.textures)
            if (each.isImage) written.insert(each.view.texture);
    });
}

/// The textures that Once and Step write.
std::set<scene::TextureIndex> lastingTextures(const scene::Scene& scene,
                                              std::span<const FramePlan* const> plans) {
    std::set<scene::TextureIndex> written;
    for (const scene::OnceBlock& each : scene.once) addWritten(each.nodes, written);
    for (const scene::StepBlock& each : scene.steps) addWritten(each.nodes, written);
    for (const FramePlan* plan : plans)
        if (plan->nodes != &scene.frame) addWritten(*plan, written);
    return written;
}

/// The textures that a pass, Clear or a shader of the scene writes.
std::set<scene::TextureIndex> writtenTextures(const scene::Scene& scene,
                                              std::span<const FramePlan* const> plans) {
    std::set<scene::TextureIndex> written = lastingTextures(scene, plans);
    addWritten(scene.frame, written);
    for (const FramePlan* plan : plans) addWritten(*plan, written);
    return written;
}

/// draw-W11 for textures with a name that shaders sample and nothing writes.
Diagnostics reportUnwritten(const scene::Scene& scene, std::span<const FramePlan* const> plans) {
    Diagnostics diagnostics;
    std::set<scene::TextureIndex> written = writtenTextures(scene, plans);
    written.insert(scene.mayBeWritten.begin(), scene.mayBeWritten.end());
    const auto check = [&](const auto& planned, const auto& statement) {
        for (const TextureUse& each : planned.textures) {
            if (each.isImage || !each.view.texture) continue;
            const scene::Texture& texture = scene.textures[each.view.texture];
            if (texture.name.empty() || !std::holds_alternative<scene::EmptySource>(texture.source) ||
                !written.insert(each.view.texture).second)
                continue;
            diagnostics.push_back(
                about(diagnose("draw-W11",
                               fmt::format("texture '{}' (line {}) is read here, but nothing draws or writes "
                                           "into it, so it is zero",
                                           texture.name, texture.place.line),
                               statement.place),
                      texture.name));
        }
    };
    for (const FramePlan* plan : plans) plan->visitStatements(check);
    return diagnostics;
}

/// Removes the textures that have levels above 0 which the list or plan writes.
void eraseLevelled(const scene::NodeList& nodes, std::set<scene::TextureIndex>& flat) {
    for (const scene::Pass& pass : nodes.passes) {
        for (std::size_t i = 0; i < pass.parts.size() && i < pass.targets.size(); ++i)
            if (pass.parts[i].level.value_or(0) > 0) flat.erase(pass.targets[i]);
        if (pass.depth && pass.depth->level.value_or(0) > 0) flat.erase(pass.depth->texture);
    }
    for (const scene::ClearObject& each : nodes.clears)
        if (const auto* texture = std::get_if<scene::TextureIndex>(&each.object)) flat.erase(*texture);
}

/// draw-W13 for textures with a name that are read with mipmaps which nothing writes.
Diagnostics reportEmptyLevels(const scene::Scene& scene, std::span<const FramePlan* const> plans) {
    std::set<scene::TextureIndex> flat;
    for (const scene::TextureIndex each : writtenTextures(scene, plans)) {
        if (!each) continue;
        const scene::Texture& texture = scene.textures[each];
        if (!texture.name.empty() && std::holds_alternative<scene::EmptySource>(texture.source) &&
            texture.levels != 1 && texture.samples == 1 && !texture.hasMipmaps)
            flat.insert(each);
    }
    for (const scene::TextureIndex each : scene.mayBeWritten) flat.erase(each);
    eraseLevelled(scene.frame, flat);
    for (const scene::OnceBlock& each : scene.once) eraseLevelled(each.nodes, flat);
    for (const scene::StepBlock& each : scene.steps) eraseLevelled(each.nodes, flat);
    for (const FramePlan* plan : plans)
        plan->visitStatements([&](const auto& planned, const auto&) {
            for (const TextureUse& each : planned.textures)
                if (each.isImage && each.view.level.value_or(0) > 0) flat.erase(each.view.texture);
        });
    Diagnostics diagnostics;
    const auto check = [&](const auto& planned, const auto& statement) {
        for (const TextureUse& each : planned.textures) {
            if (each.isImage || each.view.level || !each.sampler.readsMipmaps() ||
                flat.erase(each.view.texture) == 0)
                continue;
            const scene::Texture& texture = scene.textures[each.view.texture];
            diagnostics.push_back(diagnose(
                "draw-W13",
                fmt::format("only level 0 of '{}' (line {}) is written, but it is read with mipmaps; "
                            "write 'generate' or 'levels 1'",
                            texture.name, texture.place.line),
                statement.place));
        }
    };
    for (const FramePlan* plan : plans) plan->visitStatements(check);
    return diagnostics;
}

}  // namespace

Diagnostics reportNames(const scene::Scene& scene, std::span<const FramePlan* const> plans,
                        std::span<const Override> overrides) {
    Diagnostics diagnostics;
    if (!overrides.empty()) diagnostics = reportOverrides(scene, plans, overrides);
    if (!scene.setNames.empty()) append(diagnostics, reportSets(scene, plans));
    append(diagnostics, reportUnwritten(scene, plans));
    append(diagnostics, reportEmptyLevels(scene, plans));
    std::set<scene::TextureIndex> others = lastingTextures(scene, plans);
    others.insert(scene.mayBeWritten.begin(), scene.mayBeWritten.end());
    for (const FramePlan* plan : plans)
        if (plan->nodes == &scene.frame) append(diagnostics, reportEarlyReads(scene, *plan, others));
    return diagnostics;
}

}  // namespace glibra::plan
