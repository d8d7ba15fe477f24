#include "plan/inputs.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "geometry/shapes/primitive.h"
#include "glib/statement_table.h"
#include "plan/uniform_names.h"

namespace glibra::plan {
namespace {

constexpr std::array<std::string_view, 6> kAttributes{geometry::kPosition, geometry::kNormal,
                                                      geometry::kTexCoord, geometry::kTangent,
                                                      geometry::kColor,    geometry::kFaceIndex};

/// The binding of that name that counts: the last one.
const scene::AttributeBinding* bindingOf(const scene::Scene& scene, scene::AttributeSetIndex attributes,
                                         const std::string& name) {
    if (!attributes) return nullptr;
    const std::vector<scene::AttributeBinding>& bindings = scene.attributeSets[attributes].bindings;
    const auto found = std::find_if(bindings.rbegin(), bindings.rend(),
                                    [&](const scene::AttributeBinding& each) { return each.name == name; });
    return found == bindings.rend() ? nullptr : &*found;
}

InputSource given(const scene::AttributeBinding& binding) {
    InputSource source;
    source.isPerInstance = binding.isPerInstance;
    source.part = binding.part;
    if (const auto* role = std::get_if<std::string>(&binding.source)) {
        source.from = *role;
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&binding.source)) {
        std::array<double, 4> value{0, 0, 0, 1};
        std::copy_n(numbers->begin(), std::min(numbers->size(), value.size()), value.begin());
        source.from = value;
    } else {
        source.from = std::get<scene::BufferView>(binding.source);
    }
    return source;
}

bool isModel(glib::CommandId command) {
    using glib::CommandId;
    return command == CommandId::obj || command == CommandId::wireObj || command == CommandId::objAdj ||
           command == CommandId::objPatch;
}

}  // namespace

std::string userNameOf(const ProgramInterface& interface, const std::string& name) {
    const auto found = interface.facts.userNames.find(name);
    return found != interface.facts.userNames.end() ? found->second : name;
}

std::vector<InputSource> inputSources(const scene::Scene& scene, scene::AttributeSetIndex attributes,
                                      const ProgramInterface& interface) {
    std::vector<InputSource> sources;
    sources.reserve(interface.inputs.size());
    for (const ActiveInput& input : interface.inputs) {
        InputSource source;
        const std::string name = userNameOf(interface, input.name);
        if (const scene::AttributeBinding* binding = bindingOf(scene, attributes, name)) {
            source = given(*binding);
        } else if (const auto attribute = attributeOfInput(input, scene.suppliesNames)) {
            source.from = std::string(*attribute);
        } else {
            source.from = name;
            source.isKnown = false;
        }
        sources.push_back(std::move(source));
    }
    return sources;
}

std::vector<std::string> attributesOf(const scene::Shape& shape) {
    std::vector<std::string> names;
    if (shape.bare) return names;
    for (const std::string_view each : kAttributes) {
        bool isCarried = each != geometry::kColor || isModel(shape.command);
        if (each == geometry::kFaceIndex) {
            const geometry::PrimitiveSpec* spec = glib::primitiveOf(shape.command);
            isCarried = spec != nullptr && spec->hasFaceIndex;
        }
        if (shape.list != nullptr) isCarried = shape.list->attribute(each) != nullptr;
        if (isCarried) names.emplace_back(each);
    }
    if (shape.list != nullptr)
        for (const geometry::Attribute& each : shape.list->attributes)
            if (std::ranges::find(names, each.name) == names.end()) names.push_back(each.name);
    return names;
}

}  // namespace glibra::plan
