// Light and Material: the light sources and materials of GLSL 1.10 to 1.40 (language, 12.1; OpenGL 2.1
// specification, 2.14).

#include "scene/modern/lights.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "base/suggest.h"
#include "glib/number.h"
#include "scene/modern/evaluate.h"
#include "scene/modern/materials.h"
#include "scene/state.h"

namespace glibra::scene {
namespace {

using glib::Command;
using glib::CommandId;
using glib::KeyedValues;
using glib::Value;

constexpr int kMostLights = 8;
constexpr double kMostShininess = 1e6;
constexpr double kNoSpot = 180;  ///< a cut-off that makes a light shine in all directions

/// Sets a uniform variable of the following draws of the scope.
void setNumbers(Interpreter& in, const KeyedValues& from, std::string key, std::vector<double> numbers,
                EyeSpace space = EyeSpace::asGiven) {
    std::erase_if(in.state.set, [&](const ScopedTag& other) { return other.key == key; });
    ScopedTag scoped{&from, std::move(key), in.script, in.shared->environment.here()};
    in.scene.setsLights = true;
    scoped.numbers = std::move(numbers);
    scoped.space = space;
    in.state.set.push_back(std::move(scoped));
}

/// Three or four components; a missing alpha is 1.
std::optional<std::vector<double>> colorOf(Interpreter& in, const Command& command, const KeyedValues& key) {
    auto numbers = numbersOf(in, key.values);
    if (!numbers) return std::nullopt;
    if (numbers->size() == 1) numbers->resize(3, numbers->front());
    if (numbers->size() == 3) numbers->push_back(1);
    if (numbers->size() == 4) return numbers;
    return refuse(in, "glib-E26", command, key.position,
                  fmt::format("'{}' is a colour of 3 or 4 components, not {}", key.key, numbers->size()));
}

// ---- Material.

/// Sets a member of `material`, as shaders of today call it, and of both materials of older GLSL.
void setMember(Interpreter& in, const KeyedValues& from, const std::string& member,
               const std::vector<double>& numbers) {
    for (const char* material : {"material.", "gl_FrontMaterial.", "gl_BackMaterial."})
        setNumbers(in, from, material + member, numbers);
}

/// The row of the preset that the statement names. Null with the reason reported.
const MaterialRow* presetOf(Interpreter& in, const Value& preset) {
    std::string name = wordBehind(in, preset.text);
    if (preset.kind == Value::Kind::expression) {
        const auto chosen = wordOf(in, preset, materialNames());
        if (!chosen) return nullptr;
        name = materialNames()[*chosen];
    }
    const MaterialRow* row = findMaterial(name);
    if (row == nullptr)
        in.report(diagnose("glib-E27",
                           fmt::format("no material '{}'{}", name, base::suggestion(name, materialNames())),
                           in.place(preset)));
    return row;
}

void doMaterial(Interpreter& in, const Command& command) {
    if (command.keys.empty()) {
        const MaterialRow* row = presetOf(in, command.values.front());
        if (row == nullptr) return;
        for (const MaterialMember& each : row->members) setMember(in, each.tag, each.name, each.numbers);
        return;
    }
    std::vector<std::pair<const KeyedValues*, std::vector<double>>> members;
    for (const KeyedValues& key : command.keys) {
        std::optional<std::vector<double>> numbers;
        if (key.key == "shininess") {
            const auto value = numberIn(in, key.values.front(), "Material: shininess", 0, kMostShininess);
            if (value) numbers = std::vector{*value};
        } else {
            numbers = colorOf(in, command, key);
        }
        if (!numbers) return;
        members.emplace_back(&key, std::move(*numbers));
    }
    for (const auto& [key, numbers] : members) setMember(in, *key, key->key, numbers);
}

// ---- Light.

glm::dvec4 vectorOf(const std::vector<double>& numbers) {
    return {numbers.at(0), numbers.at(1), numbers.at(2), numbers.size() > 3 ? numbers[3] : 1};
}

std::vector<double> numbersOfVector(const glm::dvec4& vector) {
    return {vector.x, vector.y, vector.z, vector.w};
}

class LightReader {
  public:
    LightReader(Interpreter& in, const Command& command, int number)
        : in_(in), command_(command), name_(fmt::format("gl_LightSource[{}].", number)) {}

    void read() {
        for (const KeyedValues& key : command_.keys)
            if (!readKey(key)) return;
        for (Member& each : members_)
            setNumbers(in_, *each.from, name_ + each.name, std::move(each.numbers), each.space);
    }

  private:
    struct Member {
        const KeyedValues* from = nullptr;
        std::string name;
        std::vector<double> numbers;
        EyeSpace space = EyeSpace::asGiven;
    };

    bool add(const KeyedValues& key, std::string name, std::vector<double> numbers,
             EyeSpace space = EyeSpace::asGiven) {
        members_.push_back({&key, std::move(name), std::move(numbers), space});
        return true;
    }

    bool readKey(const KeyedValues& key) {
        if (key.key == "position") return readPosition(key);
        if (key.key == "spot") {
            const auto numbers = numbersOf(in_, key.values, 3, "Light: spot");
            if (!numbers) return false;
            const glm::dvec4 direction(numbers->at(0), numbers->at(1), numbers->at(2), 0);
            std::vector<double> inWorld = numbersOfVector(in_.state.model * direction);
            inWorld.resize(3);
            return add(key, "spotDirection", std::move(inWorld), EyeSpace::direction);
        }
        if (key.key == "cutoff") return readCutoff(key);
        if (key.key == "exponent") {
            const auto value = numberIn(in_, key.values.front(), "Light: exponent", 0, kMostShininess);
            return value && add(key, "spotExponent", {*value});
        }
        if (key.key == "attenuation") {
            const auto factors = numbersOf(in_, key.values, 3, "Light: attenuation");
            if (!factors) return false;
            add(key, "constantAttenuation", {factors->at(0)});
            add(key, "linearAttenuation", {factors->at(1)});
            return add(key, "quadraticAttenuation", {factors->at(2)});
        }
        auto color = colorOf(in_, command_, key);
        return color && add(key, key.key, std::move(*color));
    }

    bool readPosition(const KeyedValues& key) {
        const auto numbers = numbersOf(in_, key.values);
        if (!numbers) return false;
        if (numbers->size() < 3 || numbers->size() > 4) {
            refuse(in_, "glib-E26", command_, key.position,
                   fmt::format("a position has 3 numbers, or 4 with w, not {}", numbers->size()));
            return false;
        }
        const std::vector<double> inWorld = numbersOfVector(in_.state.model * vectorOf(*numbers));
        add(key, "position", inWorld, EyeSpace::place);
        return add(key, "halfVector", inWorld, EyeSpace::halfVector);
    }

    bool readCutoff(const KeyedValues& key) {
        const auto angle = numberIn(in_, key.values.front(), "Light: cutoff", 0, kNoSpot);
        if (!angle) return false;
        if (*angle > 90 && *angle != kNoSpot) {
            refuse(in_, "glib-E26", command_, key.position,
                   "a cutoff is an angle from 0 to 90 degrees, or 180 for light in all directions");
            return false;
        }
        add(key, "spotCutoff", {*angle});
        const double cosine = *angle == kNoSpot ? -1 : std::cos(*angle * std::numbers::pi / 180);
        return add(key, "spotCosCutoff", {cosine});
    }

    Interpreter& in_;
    const Command& command_;
    std::string name_;
    std::vector<Member> members_;
};

void doLight(Interpreter& in, const Command& command) {
    if (command.values.empty()) {
        const KeyedValues& ambient = command.keys.front();
        auto color = colorOf(in, command, ambient);
        if (color) setNumbers(in, ambient, "gl_LightModel.ambient", std::move(*color));
        return;
    }
    const auto number = integerIn(in, command.values.front(), "Light:", 0, kMostLights - 1);
    if (number) LightReader(in, command, *number).read();
}

constexpr CommandAction kLightActions[] = {
    {CommandId::material, doMaterial},
    {CommandId::light, doLight},
};

}  // namespace

std::vector<double> numbersInEye(Interpreter& in, const ScopedTag& tag) {
    if (tag.space == EyeSpace::asGiven) return tag.numbers;
    addDepends(in, expression::Depends::camera);
    const glm::dmat4 view = currentCamera(in).view;
    if (tag.space == EyeSpace::direction) {
        std::vector<double> turned =
            numbersOfVector(view * glm::dvec4(tag.numbers.at(0), tag.numbers.at(1), tag.numbers.at(2), 0));
        turned.resize(3);
        return turned;
    }
    const glm::dvec4 place = view * vectorOf(tag.numbers);
    if (tag.space == EyeSpace::place) return numbersOfVector(place);
    const glm::dvec3 toLight(place);
    const double length = glm::length(toLight);
    const glm::dvec3 half = (length > 0 ? toLight / length : glm::dvec3(0.0)) + glm::dvec3(0, 0, 1);
    const double size = glm::length(half);
    return numbersOfVector(glm::dvec4(size > 0 ? half / size : half, 0));
}

std::span<const CommandAction> lightActions() {
    return kLightActions;
}

}  // namespace glibra::scene
