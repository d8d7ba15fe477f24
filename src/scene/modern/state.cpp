// State: how fragments are tested, blended and written (language, 12.6).

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "glib/statement_table.h"
#include "scene/modern/modern.h"
#include "scene/run/evaluate.h"
#include "scene/run/scope.h"

namespace glibra::scene {
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
