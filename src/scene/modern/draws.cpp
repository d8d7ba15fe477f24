// Instances, Vertices, Attribute and TessLevels (language, 12.6).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/suggest.h"
#include "geometry/list_mesh.h"
#include "glib/statement_table.h"
#include "glib/text.h"
#include "scene/classic/classic.h"
#include "scene/modern/modern.h"
#include "scene/nodes.h"
#include "scene/primitives.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/run/scope.h"
#include "scene/statement_words.h"

namespace glibra::scene {
namespace {

void doInstances(Interpreter& in, const Command& command) {
    LocalState& local = in.state.local;
    if (command.key("from") != nullptr) {
        if (const auto count = countFrom(in, command)) local.instancesFrom = *count;
        return;
    }
    const auto count = integerIn(in, command.values.front(), "Instances:", 0, kMostInstances);
    if (!count) return;
    local.instances = *count;
    local.instancesFrom = {};
}

/// How many elements the buffer has, as far as its declaration says it. Only `int` and `uint` count.
std::optional<std::uint64_t> declaredIndices(const Buffer& buffer) {
    if (buffer.count) return buffer.count;
    return buffer.file || buffer.type.empty() ? std::nullopt
                                              : std::optional<std::uint64_t>(buffer.values.size());
}

/// The buffer after the key `indices`. `wanted`: how many of its elements are drawn, if the statement says
/// it.
std::optional<BufferView> indexBuffer(Interpreter& in, const Command& command, const KeyedValues& key,
                                      std::optional<int> wanted) {
    const Value& name = key.values.front();
    const auto view = bufferNamed(in, name);
    if (!view) return std::nullopt;
    const Buffer& buffer = in.scene.buffers[view->buffer];
    if (!buffer.type.empty() && buffer.type != "uint" && buffer.type != "int")
        return refuse(in, "glib-E33", command, name.position,
                      fmt::format("'{}' holds {}, but indices are uint or int", name.text, buffer.type));
    const auto count = declaredIndices(buffer);
    if (count && wanted && static_cast<std::uint64_t>(*wanted) > *count)
        return refuse(in, "glib-E05", command, command.values.at(1).position,
                      fmt::format("{} indices are more than the {} of '{}'", *wanted, *count, name.text));
    return view;
}

void doVertices(Interpreter& in, const Command& command) {
    const auto words = geometry::kListTopologyWords;
    const auto index = wordOf(in, command.values.front(), words);
    if (!index) return;
    const std::string_view word = words[*index];
    const auto topology = geometry::listTopology(word);
    if (!topology) return;
    Shape shape;
    shape.command = CommandId::vertices;
    shape.bare = geometry::meshTopology(*topology);
    switch (*topology) {
        case geometry::ListTopology::points:
        case geometry::ListTopology::lines:
        case geometry::ListTopology::triangles:
        case geometry::ListTopology::linesAdjacency:
        case geometry::ListTopology::trianglesAdjacency:
        case geometry::ListTopology::patches:
            break;
        case geometry::ListTopology::quads:
            in.reportAt(command.values.front(), "glib-E32",
                        fmt::format("Vertices: there are no {0} without data; write triangles, or "
                                    "'Instances n' and triangle_strip 4",
                                    word));
            return;
        default:
            shape.strip = *topology;
    }
    const KeyedValues* from = command.key("from");
    const KeyedValues* indices = command.key("indices");
    Drawing drawing;
    std::optional<int> count;
    if (from != nullptr) {
        const auto counted = countFrom(in, command);
        if (!counted) return;
        drawing.verticesFrom = *counted;
    } else if (command.values.size() > 1) {
        count = integerIn(in, command.values[1], "Vertices:", 0, kMostVertices);
        if (!count) return;
    }
    if (indices != nullptr) {
        const auto buffer = indexBuffer(in, command, *indices, count);
        if (!buffer) return;
        drawing.indices = *buffer;
        drawing.drawsAllIndices = from == nullptr && !count;
    }
    shape.numbers = {static_cast<double>(count.value_or(0))};
    drawing.word = command.word;
    drawing.size = count ? fmt::format("{} {}", *count, word) : "as many vertices as the buffer says";
    drawing.shape = shareShape(in, std::move(shape));
    draw(in, command, drawing);
}

/// The mesh attribute of a role, in any case.
std::optional<std::string> roleNamed(Interpreter& in, const Value& value) {
    for (const std::string_view each : kAttributeRoles)
        if (glib::sameWord(each, value.text)) return std::string(each);
    const std::string hint = base::suggestion(value.text, kAttributeRoles);
    return in.reportAt(
        value, "glib-E16",
        fmt::format(
            "Attribute: there is no role '{}'{}", value.text,
            hint.empty() ? fmt::format("; the roles are {}", fmt::join(kAttributeRoles, ", ")) : hint));
}

void bind(Interpreter& in, AttributeBinding binding) {
    AttributeSet set;
    if (in.state.local.attributes) set = in.scene.attributeSets[in.state.local.attributes];
    std::erase_if(set.bindings, [&](const AttributeBinding& each) { return each.name == binding.name; });
    set.bindings.push_back(std::move(binding));
    in.state.local.attributes = shareAttributes(in, std::move(set));
}

/// The binding that holds before the list that is open; null if there is none.
const AttributeBinding* outerBinding(const Interpreter& in, const std::string& name) {
    if (!in.state.local.attributes) return nullptr;
    const auto& bindings = in.scene.attributeSets[in.state.local.attributes].bindings;
    const auto found = std::ranges::find(bindings, name, &AttributeBinding::name);
    return found == bindings.end() ? nullptr : &*found;
}

/// Attribute with numbers between glBegin and glEnd.
void setInList(Interpreter& in, const Command& command, const std::string& name,
               const std::vector<double>& numbers) {
    auto [extra, isNew] = in.list->extras.try_emplace(name);
    OpenList::Extra& values = extra->second;
    if (const AttributeBinding* outer = isNew ? outerBinding(in, name) : nullptr) {
        const auto* same = std::get_if<std::vector<double>>(&outer->source);
        if (same == nullptr && !in.list->vertices.empty()) {
            in.reportAt(
                command, "glib-E32",
                fmt::format("Attribute {}: the vertices before have it from line {}; state it before the "
                            "first glVertex, too",
                            name, outer->place.line));
            return;
        }
        if (same != nullptr) {
            std::copy(same->begin(), same->end(), values.before.begin());
            values.components = static_cast<int>(same->size());
        }
    }
    values.components = std::max(values.components, static_cast<int>(numbers.size()));
    values.current = {0, 0, 0, 1};
    std::ranges::copy(numbers, values.current.begin());
}

/// `offset` and `stride`. Nothing with the reason reported.
bool readBytes(Interpreter& in, const Command& command, ElementPart& part) {
    constexpr double kMostBytes = 1 << 30;
    for (const char* word : {"offset", "stride"}) {
        const KeyedValues* key = command.key(word);
        if (key == nullptr) continue;
        const bool isOffset = *word == 'o';
        const auto bytes = wholeIn(in, key->values.front(), fmt::format("Attribute: {}", word),
                                   isOffset ? 0 : 4, kMostBytes);
        if (!bytes) return false;
        const auto whole = static_cast<std::uint64_t>(*bytes);
        if (whole % 4 != 0) {
            refuse(in, "glib-E05", command, key->position,
                   fmt::format("{} counts bytes and is a multiple of 4, because numbers have 4 bytes", word));
            return false;
        }
        (isOffset ? part.offset : part.stride) = whole;
    }
    return true;
}

void doAttribute(Interpreter& in, const Command& command) {
    AttributeBinding binding;
    binding.name = command.values.front().text;
    binding.place = in.place(command);
    const std::span<const Value> values = std::span(command.values).subspan(1);
    if (const KeyedValues* as = command.key("as")) {
        auto role = roleNamed(in, as->values.front());
        if (!role) return;
        binding.source = std::move(*role);
        return bind(in, std::move(binding));
    }
    if (!values.empty() && values.front().kind == Value::Kind::word) {
        Value name = values.front();
        const auto member = takeMember(in, name, "Attribute");
        const auto buffer = member ? bufferNamed(in, name) : std::nullopt;
        if (!buffer || !readBytes(in, command, binding.part)) return;
        binding.source = *buffer;
        binding.part.member = *member;
        binding.isPerInstance = command.key("per") != nullptr || command.key("instance") != nullptr;
        if (in.list) {
            in.reportAt(command, "glib-E07", "Attribute: a vertex of a list takes numbers, not a buffer");
            return;
        }
        return bind(in, std::move(binding));
    }
    const auto numbers = floatsOf(in, values);
    if (!numbers) return;
    if (numbers->empty() || numbers->size() > 4) {
        in.reportAt(command, "glib-E26",
                    fmt::format("Attribute {}: an attribute has 1 to 4 numbers, not {}", binding.name,
                                numbers->size()));
        return;
    }
    if (in.list) return setInList(in, command, binding.name, *numbers);
    binding.source = *numbers;
    bind(in, std::move(binding));
}

void doTessLevels(Interpreter& in, const Command& command) {
    const auto levels = floatsOf(in, command.values, 6, "TessLevels");
    if (!levels) return;
    std::array<double, 6> made{};
    std::copy(levels->begin(), levels->end(), made.begin());
    in.state.local.tessellationLevels = made;
}

}  // namespace

std::span<const CommandAction> vertexActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::instances, doInstances},
        {CommandId::vertices, doVertices, InList::isWrong, true},
        {CommandId::attribute, doAttribute, InList::isPart},
        {CommandId::tessLevels, doTessLevels},
    };
    return kActions;
}

// State: how fragments are tested, blended and written (language, 12.6).

namespace {

using base::Blend;
using base::BlendEquation;
using base::BlendFactor;
using base::BlendFunction;
using base::Comparison;
using base::StencilAction;

using glib::wordsOfFragment;

/// In the order of the words of the statement table; other enumerations have the order of their words.
constexpr std::array kStencilActions = {StencilAction::keep,          StencilAction::zero,
                                        StencilAction::replace,       StencilAction::increment,
                                        StencilAction::incrementWrap, StencilAction::decrement,
                                        StencilAction::decrementWrap, StencilAction::invert};

constexpr double kLargestStencil = 255;

class StateReader {
  public:
    StateReader(Interpreter& in, const Command& command) : in_(in), command_(command) {}

    /// Reads all keys into a copy of the state, which stays as it was if one is wrong.
    void read() {
        base::RasterState state = in_.state.raster;
        bool statesBlend = in_.state.local.isBlendStated;
        for (std::size_t i = 0; i < command_.keys.size(); ++i) {
            const KeyedValues& key = command_.keys[i];
            const bool hasAlpha = i + 1 < command_.keys.size() && command_.keys[i + 1].key == "alpha";
            if (key.key == "default") {
                const base::RasterState before = state;
                state = {};
                state.viewport = before.viewport;
                state.scissor = before.scissor;
                statesBlend = false;
                continue;
            }
            if (key.key == "alpha") continue;  // read with its blend
            if (key.key == "blend") {
                // Outside of Pass the target decides how draws are blended until a statement does.
                if (!in_.around.pass && !statesBlend && in_.state.target.textures.empty())
                    state.blendAll(base::kBlendOver);
                statesBlend = true;
            }
            if (!readKey(key, key.key == "blend" && hasAlpha ? &command_.keys[i + 1] : nullptr, state))
                return;
        }
        in_.state.raster = state;
        in_.state.local.isBlendStated = statesBlend;
    }

  private:
    /// The index of a word among those of a list of the table.
    std::optional<std::size_t> word(const Value& value, std::string_view fragment) {
        return wordOf(in_, value, wordsOfFragment(fragment));
    }
    /// Sets the target to what the index of the word among these stands for.
    template <class Target, std::size_t n>
    bool readWord(const Value& value, Target& target, const std::string_view (&words)[n]) {
        const auto index = wordOf(in_, value, words);
        if (index) target = static_cast<Target>(*index);
        return index.has_value();
    }
    bool readSwitch(const Value& value, bool& target) { return readWord(value, target, {"off", "on"}); }
    std::optional<int> stencilValue(const Value& value, std::string_view what) {
        const auto number = wholeIn(in_, value, what, 0, kLargestStencil);
        return number ? std::optional(static_cast<int>(*number)) : std::nullopt;
    }

    bool readKey(const KeyedValues& key, const KeyedValues* alpha, base::RasterState& state) {
        const std::string& name = key.key;
        const Value& first = key.values.front();
        if (name == "cull") return readWord(first, state.cull, {"off", "back", "front", "both"});
        if (name == "front") return readWord(first, state.front, {"ccw", "cw"});
        if (name == "polygon") return readWord(first, state.polygon, {"fill", "line", "point"});
        if (name == "provoking") return readWord(first, state.provoking, {"last", "first"});
        if (name == "depth") return readDepth(first, state);
        if (name == "depthwrite") return readSwitch(first, state.depthWrite);
        if (name == "depthclamp") return readSwitch(first, state.depthClamp);
        if (name == "samples") return readSwitch(first, state.multisample);
        if (name == "alphatocoverage") return readSwitch(first, state.alphaToCoverage);
        if (name == "discard") return readSwitch(first, state.discard);
        if (name == "offset" || name == "depthrange") return readPair(key, state);
        if (name == "blend") return readBlend(key, alpha, state);
        if (name == "blendcolor") {
            const auto color = floatsOf(in_, key.values, 4, "State: blendcolor");
            if (color) std::copy(color->begin(), color->end(), state.blendConstant.begin());
            return color.has_value();
        }
        if (name == "write") return readWrite(key, state);
        return readStencil(key, state);
    }

    bool readDepth(const Value& value, base::RasterState& state) {
        std::vector<std::string_view> words{"off"};
        for (const std::string_view each : wordsOfFragment("compare")) words.push_back(each);
        const auto index = wordOf(in_, value, words);
        if (!index) return false;
        state.depthTest = *index > 0;
        if (*index > 0) state.depthFunction = static_cast<Comparison>(*index - 1);
        return true;
    }

    bool readPair(const KeyedValues& key, base::RasterState& state) {
        const auto pair = floatsOf(in_, key.values, 2, "State: " + key.key);
        if (!pair) return false;
        if (key.key == "offset") {
            state.offsetFactor = (*pair)[0];
            state.offsetUnits = (*pair)[1];
            return true;
        }
        const auto isDepth = [](double value) { return value >= 0 && value <= 1; };
        if (!isDepth((*pair)[0]) || !isDepth((*pair)[1]))
            return in_.reportAt(key.values.front(), "glib-E05",
                                "State: depthrange needs two depths from 0 to 1"),
                   false;
        state.depthNear = (*pair)[0];
        state.depthFar = (*pair)[1];
        return true;
    }

    bool readFunction(std::span<const Value> values, BlendFunction& function) {
        const auto source = word(values[0], "factor");
        const auto destination = values.size() > 1 ? word(values[1], "factor") : std::nullopt;
        if (!source || !destination) return false;
        function = {static_cast<BlendFactor>(*source), static_cast<BlendFactor>(*destination),
                    BlendEquation::add};
        if (values.size() < 3) return true;
        const auto equation = word(values[2], "equation");
        if (equation) function.equation = static_cast<BlendEquation>(*equation);
        return equation.has_value();
    }

    bool readBlend(const KeyedValues& key, const KeyedValues* alpha, base::RasterState& state) {
        Blend blend{true, {}, {}};
        if (key.values.size() == 1) {
            constexpr std::array<std::string_view, 5> kModes{"off", "alpha", "add", "multiply",
                                                             "premultiplied"};
            const auto mode = wordOf(in_, key.values.front(), kModes);
            if (!mode) return false;
            const auto both = [&](BlendFactor source, BlendFactor destination) {
                blend.color = blend.alpha = {source, destination, BlendEquation::add};
            };
            switch (*mode) {
                case 0:
                    blend = {};
                    break;
                case 1:
                    blend = base::kBlendOver;
                    break;
                case 2:
                    both(BlendFactor::one, BlendFactor::one);
                    break;
                case 3:
                    both(BlendFactor::destinationColor, BlendFactor::zero);
                    break;
                default:
                    both(BlendFactor::one, BlendFactor::oneMinusSourceAlpha);
            }
        } else {
            if (!readFunction(key.values, blend.color)) return false;
            blend.alpha = blend.color;
            if (alpha != nullptr && !readFunction(alpha->values, blend.alpha)) return false;
        }
        return setTargets(key, state.blend, blend);
    }

    bool readWrite(const KeyedValues& key, base::RasterState& state) {
        const std::vector<std::string_view> words = wordsOfFragment("mask");
        const auto index = wordOf(in_, key.values.front(), words);
        if (!index) return false;
        const std::string_view mask = words[*index] == "none" ? "" : words[*index];
        const auto has = [&](char component) { return mask.find(component) != std::string_view::npos; };
        return setTargets(key, state.write, base::ColorMask{has('r'), has('g'), has('b'), has('a')});
    }

    /// Sets the value of the colour target that follows the key after a point; without one, that of all.
    template <class Targets>
    bool setTargets(const KeyedValues& key, Targets& targets, const typename Targets::value_type& value) {
        if (key.suffix.empty()) {
            targets.fill(value);
            return true;
        }
        const auto target = static_cast<std::size_t>(std::strtoul(key.suffix.c_str(), nullptr, 10));
        if (target >= targets.size()) {
            in_.reportAt(key, "glib-E05",
                         fmt::format("State: {}.{}: colour targets are 0 to {}", key.key, key.suffix,
                                     targets.size() - 1));
            return false;
        }
        targets[target] = value;
        return true;
    }

    /// Applies `change` to the faces that the key names.
    template <class Change>
    void forFaces(const KeyedValues& key, base::RasterState& state, const Change& change) {
        if (key.suffix != "back") change(state.stencilFront);
        if (key.suffix != "front") change(state.stencilBack);
    }

    bool readStencil(const KeyedValues& key, base::RasterState& state) {
        if (in_.around.pass && !in_.around.pass->hasStencil) {
            if (!std::exchange(in_.around.pass->isStencilReported, true))
                in_.reportAt(key, "glib-E38",
                             fmt::format("State {}: the depth texture of this pass has no stencil; "
                                         "depth24_stencil8 has one",
                                         key.key));
            return false;
        }
        const std::string what = "State: " + key.key;
        if (key.key == "mark" || key.key == "where") {
            const auto value = stencilValue(key.values.front(), what);
            if (!value) return false;
            const bool isMark = key.key == "mark";
            state.stencilTest = true;
            forFaces(key, state, [&](base::StencilFace& face) {
                face = {};
                face.function = isMark ? Comparison::always : Comparison::equal;
                face.reference = *value;
                if (isMark) face.pass = StencilAction::replace;
            });
            return true;
        }
        if (key.key == "stencilop") {
            std::array<StencilAction, 3> actions{};
            for (std::size_t i = 0; i < actions.size(); ++i) {
                const auto index = i < key.values.size() ? word(key.values[i], "operation") : std::nullopt;
                if (!index) return false;
                actions[i] = kStencilActions.at(*index);
            }
            state.stencilTest = true;
            forFaces(key, state, [&](base::StencilFace& face) {
                face.fail = actions[0];
                face.depthFail = actions[1];
                face.pass = actions[2];
            });
            return true;
        }
        if (key.key == "stencilwrite") {
            const auto mask = stencilValue(key.values.front(), what);
            if (mask)
                forFaces(key, state, [&](base::StencilFace& face) {
                    face.writeMask = static_cast<std::uint32_t>(*mask);
                });
            return mask.has_value();
        }
        const auto test = word(key.values[0], "compare");
        if (!test) return false;
        const auto reference = stencilValue(key.values.at(1), what);
        const auto mask = key.values.size() > 2 ? stencilValue(key.values[2], what) : std::optional(255);
        if (!reference || !mask) return false;
        state.stencilTest = true;
        forFaces(key, state, [&](base::StencilFace& face) {
            face.function = static_cast<Comparison>(*test);
            face.reference = *reference;
            face.mask = static_cast<std::uint32_t>(*mask);
        });
        return true;
    }

    Interpreter& in_;
    const Command& command_;
};

void doState(Interpreter& in, const Command& command) {
    noteRasterStatement(in, command, RasterPart::state);
    StateReader(in, command).read();
}

}  // namespace

std::span<const CommandAction> stateActions() {
    static constexpr CommandAction kActions[] = {{CommandId::state, doState}};
    return kActions;
}

}  // namespace glibra::scene
