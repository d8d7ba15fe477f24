// Set, Material and Light: the uniform variables of the following draws of a scope, and among them the light
// sources and materials of GLSL 1.10 to 1.40 (language, 12.1; OpenGL 2.1 specification, 2.14).

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "base/suggest.h"
#include "glib/script.h"
#include "glib/text.h"
#include "scene/modern/modern.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/run/uniforms.h"
#include "scene/statement_words.h"

namespace glibra::scene {
namespace {

// ---- The named materials (language, 12.1).

struct MaterialMember {
    std::string name;  ///< "ambient", "diffuse", "specular" (4 components), "shininess"
    std::vector<double> numbers;
    glib::KeyedValues tag;  ///< without a place, for ScopedTag
};
struct MaterialRow {
    std::string_view name;
    std::vector<MaterialMember> members;
};

struct MaterialNumbers {
    std::string_view name;
    std::array<double, 4> ambient, diffuse, specular;
    double shininess;
};

/// Source: V. S. Gordon and J. Clevenger, Computer Graphics Programming in OpenGL, section 7.3, whose numbers
/// are those of the OpenGL teapots example.
constexpr MaterialNumbers kMaterials[] = {
    {"gold", {.2473, .1995, .0745, 1}, {.7516, .6065, .2265, 1}, {.6283, .5558, .3661, 1}, 51.2},
    {"silver", {.1923, .1923, .1923, 1}, {.5075, .5075, .5075, 1}, {.5083, .5083, .5083, 1}, 51.2},
    {"bronze", {.2125, .1275, .054, 1}, {.714, .4284, .1814, 1}, {.3935, .2719, .1667, 1}, 25.6},
    {"pewter", {.11, .06, .11, 1}, {.43, .47, .54, 1}, {.33, .33, .52, 1}, 9.85},
    {"jade", {.135, .2225, .1575, .95}, {.54, .89, .63, .95}, {.3162, .3162, .3162, .95}, 12.8},
    {"pearl", {.25, .2073, .2073, .922}, {1, .829, .829, .922}, {.2966, .2966, .2966, .922}, 11.264},
};

MaterialMember member(const char* name, std::span<const double> numbers) {
    MaterialMember made{name, {numbers.begin(), numbers.end()}, {}};
    made.tag.key = name;
    return made;
}

const std::vector<MaterialRow>& rows() {
    static const std::vector<MaterialRow> kRows = [] {
        std::vector<MaterialRow> made;
        for (const MaterialNumbers& each : kMaterials)
            made.push_back({each.name,
                            {member("ambient", each.ambient), member("diffuse", each.diffuse),
                             member("specular", each.specular), member("shininess", {&each.shininess, 1})}});
        return made;
    }();
    return kRows;
}

/// The material of that name, in any case; null if there is none.
const MaterialRow* findMaterial(std::string_view name) {
    for (const MaterialRow& each : rows())
        if (glib::sameWord(each.name, name)) return &each;
    return nullptr;
}

}  // namespace

std::span<const std::string_view> materialNames() {
    static const auto kNames = [] {
        std::array<std::string_view, std::size(kMaterials)> names;
        for (std::size_t i = 0; i < names.size(); ++i) names[i] = kMaterials[i].name;
        return names;
    }();
    return kNames;
}

namespace {

constexpr int kMostLights = 8;
constexpr double kMostShininess = 1e6;
constexpr double kNoSpot = 180;  ///< a cut-off that makes a light shine in all directions

// ---- Set.

/// Puts tags into the list of the scope; the last one of a name counts.
void addTags(Interpreter& in, std::span<const KeyedValues> tags) {
    for (const KeyedValues& each : tags) {
        std::optional<std::string> key = keyOfTag(in, each);
        if (!key) continue;
        std::erase_if(in.state.set, [&](const ScopedTag& other) { return other.key == *key; });
        if (key->starts_with("gl_")) in.scene.setsLights = true;
        ScopedTag scoped{&each, *std::move(key), in.script, in.names().here()};
        if (namesObject(in, each.values.front())) {
            scoped.object = objectNamed(in, each.values.front());
            if (!scoped.object) continue;
        }
        in.state.set.push_back(std::move(scoped));
    }
}

void doSet(Interpreter& in, const Command& command) {
    addTags(in, command.tags);
    for (const ScopedTag& each : in.state.set)
        if (each.tag >= command.tags.data() && each.tag < command.tags.data() + command.tags.size())
            in.scene.setNames.try_emplace(each.key, in.script->place(each.tag->position));
}

// ---- Material and Light.

/// Sets a uniform variable of the following draws of the scope.
void setNumbers(Interpreter& in, const KeyedValues& from, std::string key, std::vector<double> numbers,
                EyeSpace space = EyeSpace::asGiven) {
    std::erase_if(in.state.set, [&](const ScopedTag& other) { return other.key == key; });
    ScopedTag scoped{&from, std::move(key), in.script, in.names().here()};
    in.scene.setsLights = true;
    scoped.numbers = std::move(numbers);
    scoped.space = space;
    in.state.set.push_back(std::move(scoped));
}

/// Three or four components; a missing alpha is 1.
std::optional<std::vector<double>> colorOfMember(Interpreter& in, const Command& command,
                                                 const KeyedValues& key) {
    auto numbers = floatsOf(in, key.values);
    if (!numbers) return std::nullopt;
    if (numbers->size() == 1) numbers->resize(3, numbers->front());
    if (numbers->size() == 3) numbers->push_back(1);
    if (numbers->size() == 4) return numbers;
    return refuse(in, "glib-E26", command, key.position,
                  fmt::format("'{}' is a colour of 3 or 4 components, not {}", key.key, numbers->size()));
}

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
        in.reportAt(preset, "glib-E16",
                    fmt::format("no material '{}'{}", name, base::suggestion(name, materialNames())));
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
            numbers = colorOfMember(in, command, key);
        }
        if (!numbers) return;
        members.emplace_back(&key, std::move(*numbers));
    }
    for (const auto& [key, numbers] : members) setMember(in, *key, key->key, numbers);
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
            const auto numbers = floatsOf(in_, key.values, 3, "Light: spot");
            if (!numbers) return false;
            std::vector<double> inWorld = transformed(in_.state.model, *numbers, 0);
            inWorld.resize(3);
            return add(key, "spotDirection", std::move(inWorld), EyeSpace::direction);
        }
        if (key.key == "cutoff") return readCutoff(key);
        if (key.key == "exponent") {
            const auto value = numberIn(in_, key.values.front(), "Light: exponent", 0, kMostShininess);
            return value && add(key, "spotExponent", {*value});
        }
        if (key.key == "attenuation") {
            const auto factors = floatsOf(in_, key.values, 3, "Light: attenuation");
            if (!factors) return false;
            add(key, "constantAttenuation", {factors->at(0)});
            add(key, "linearAttenuation", {factors->at(1)});
            return add(key, "quadraticAttenuation", {factors->at(2)});
        }
        auto color = colorOfMember(in_, command_, key);
        return color && add(key, key.key, std::move(*color));
    }

    bool readPosition(const KeyedValues& key) {
        const auto numbers = floatsOf(in_, key.values);
        if (!numbers) return false;
        if (numbers->size() < 3 || numbers->size() > 4) {
            refuse(in_, "glib-E26", command_, key.position,
                   fmt::format("a position has 3 numbers, or 4 with w, not {}", numbers->size()));
            return false;
        }
        const std::vector<double> inWorld = transformed(in_.state.model, *numbers, 1);
        add(key, "position", inWorld, EyeSpace::place);
        return add(key, "halfVector", inWorld, EyeSpace::halfVector);
    }

    bool readCutoff(const KeyedValues& key) {
        const auto angle = numberIn(in_, key.values.front(), "Light: cutoff", 0, kNoSpot);
        if (!angle) return false;
        if (*angle > 90 && *angle != kNoSpot) {
            refuse(in_, "glib-E05", command_, key.position,
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
        auto color = colorOfMember(in, command, ambient);
        if (color) setNumbers(in, ambient, "gl_LightModel.ambient", std::move(*color));
        return;
    }
    const auto number = integerIn(in, command.values.front(), "Light:", 0, kMostLights - 1);
    if (number) LightReader(in, command, *number).read();
}

}  // namespace

std::span<const CommandAction> tagActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::set, doSet},
        {CommandId::material, doMaterial},
        {CommandId::light, doLight},
    };
    return kActions;
}

}  // namespace glibra::scene
