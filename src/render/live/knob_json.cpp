#include "render/live/knob_json.h"

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace glibra::render {

nlohmann::ordered_json jsonOf(const Knob& knob) {
    constexpr std::array kWords{"slider", "checkBox", "color", "numbers"};  // of Widget
    nlohmann::ordered_json json{{"owner", knob.program ? knob.title : std::string()},
                                {"name", knob.tag},
                                {"widget", kWords.at(static_cast<std::size_t>(knob.widget))},
                                {"declaration", knob.declaration},
                                {"isInteger", knob.isInteger()},
                                {"isShared", knob.isShared},
                                {"minimum", knob.minimum},
                                {"maximum", knob.maximum},
                                {"components", knob.type.components()},
                                {"initial", knob.initial},
                                {"current", knob.current}};
    if (!knob.words.empty()) json["words"] = knob.words;
    return json;
}

}  // namespace glibra::render
