#include "scene/run/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/suggest.h"
#include "expression/functions.h"
#include "expression/known_names.h"
#include "scene/nodes.h"
#include "scene/run/evaluate.h"
#include "scene/textures.h"

namespace glibra::scene {
namespace {

using glib::NamePart;
using NameKind = DeclaredName::Kind;

const char* wordOfKind(NameKind kind) {
    switch (kind) {
        case NameKind::camera:
            return "a camera";
        case NameKind::texture:
            return "a texture";
        case NameKind::sampler:
            return "a sampler";
        case NameKind::buffer:
            return "a buffer";
        case NameKind::mesh:
            return "a mesh";
        case NameKind::function:
            return "a function";
        case NameKind::variable:
        case NameKind::computed:
            break;
    }
    return "a variable";
}

bool isReserved(std::string_view name, NameKind kind) {
    constexpr std::array<std::string_view, 4> kWords{"camera", "pi", "true", "false"};
    if (name == "eye") return kind != NameKind::camera;
    if (kind == NameKind::function && !expression::functionsNamed(name).empty()) return true;
    const auto isName = [&](const expression::NameRow& row) { return row.path == name; };
    const auto rows = expression::sceneNames();
    return std::ranges::find(kWords, name) != kWords.end() || std::ranges::any_of(rows, isName);
}

std::string lineOf(const Interpreter& in, const Place& place) {
    return place.file == in.script->path ? fmt::format("line {}", place.line)
                                         : fmt::format("line {} of {}", place.line, place.file);
}

/// The texture or buffer that a parameter of this name stands for; null if it is none.
const ObjectView* objectOfScope(const Interpreter& in, std::string_view name) {
    const Environment& names = in.names();
    const auto slot = names.findLocal(name);
    return slot && names.objectOf(*slot) ? &*names.objectOf(*slot) : nullptr;
}

/// The name that the value begins with; of a mesh and a buffer of it, `teapot.position`.
std::string headOf(const Interpreter& in, const Value& value) {
    if (value.path.empty()) return value.text;
    const std::string& first = value.path.front().name;
    if (value.path.size() < 2) return first;
    const DeclaredName* const declared = declaredName(in, first);
    return declared != nullptr && declared->kind == NameKind::mesh ? first + "." + value.path[1].name : first;
}

/// Reads the parts after the name of an object: `.level(2)`, `.prev`, `.crisp`.
class PartReader {
  public:
    PartReader(Interpreter& in, const Value& value) : in_(in), value_(value), name_(nameOf(value)) {}

    std::optional<ObjectView> read() {
        if (const ObjectView* object = objectOfScope(in_, name_.name)) return readOf(*object);
        const DeclaredName* declared = declaredName(in_, name_.name);
        if (declared == nullptr || declared->kind == NameKind::variable ||
            declared->kind == NameKind::computed) {
            name_.name = wordBehind(in_, name_.name);
            if (const ObjectView* object = objectOfScope(in_, name_.name)) return readOf(*object);
            declared = declaredName(in_, name_.name);
        }
        if (declared != nullptr && declared->kind == NameKind::mesh) {
            name_.name = headOf(in_, value_);
            const auto part = in_.modern.names.find(name_.name);
            if (value_.path.size() < 2 || part == in_.modern.names.end()) return noBuffer();
            declared = &part->second;
            firstPart_ = 2;
        }
        if (declared == nullptr) return unknown();
        if (declared->kind != NameKind::texture && declared->kind != NameKind::buffer)
            return refuse("glib-E34", fmt::format("'{}' is {}, not a texture or buffer", name_.name,
                                                  wordOfKind(declared->kind)));
        if (std::holds_alternative<std::monostate>(declared->object)) return std::nullopt;
        if (const auto* buffer = std::get_if<BufferIndex>(&declared->object))
            return readOf(BufferView{*buffer});
        return readOf(TextureView{.texture = std::get<TextureIndex>(declared->object)});
    }

  private:
    std::optional<ObjectView> readOf(const ObjectView& object) {
        if (name_.index.empty()) return readParts(object);
        const bool isBuffer = std::holds_alternative<BufferView>(object);
        return refuse("glib-E34", fmt::format("'{}' is {}, not an array", name_.name,
                                              wordOfKind(isBuffer ? NameKind::buffer : NameKind::texture)));
    }

    static NamePart nameOf(const Value& value) {
        return value.path.empty() ? NamePart{value.text, {}} : value.path.front();
    }

    std::nullopt_t refuse(const char* id, std::string text) {
        return in_.reportAt(value_, id, std::move(text));
    }

    std::nullopt_t unknown() {
        if (in_.modern.lostNames.contains(name_.name)) return std::nullopt;
        if (in_.names().findLocal(name_.name))
            return refuse("glib-E34",
                          fmt::format("'{}' has a value here, and is no texture or buffer", name_.name));
        std::vector<std::string_view> names{"window"};
        for (const auto& [name, declared] : in_.modern.names)
            if (declared.kind == NameKind::texture || declared.kind == NameKind::buffer)
                names.push_back(name);
        return refuse("glib-E27", fmt::format("no texture or buffer '{}' is declared before this line{}",
                                              name_.name, base::suggestion(name_.name, names)));
    }

    /// A mesh without one of its buffers.
    std::nullopt_t noBuffer() {
        const std::string mesh = nameOf(value_).name + ".";
        std::vector<std::string_view> names;
        for (const auto& [name, declared] : in_.modern.names)
            if (name.starts_with(mesh)) names.push_back(name);
        if (names.empty()) return std::nullopt;  // the mesh has an error
        return refuse("glib-E34",
                      fmt::format("'{}' is no buffer; the mesh has {}", value_.text, fmt::join(names, ", ")));
    }

    std::optional<ObjectView> readParts(const ObjectView& of) {
        if (const auto* buffer = std::get_if<BufferView>(&of)) return readBuffer(*buffer);
        return readTexture(std::get<TextureView>(of));
    }

    std::optional<ObjectView> readBuffer(BufferView view) {
        const BufferIndex index = view.buffer;
        for (std::size_t i = firstPart_; i < value_.path.size(); ++i) {
            const NamePart& part = value_.path[i];
            if (part.name != "prev" || !in_.scene.buffers[index].hasHistory)
                return noPart(part, {"prev"}, in_.scene.buffers[index].hasHistory);
            if (!part.index.empty()) return surplusIndex(part);
            if (std::exchange(view.isPrevious, true)) return twice(part);
        }
        return view;
    }

    std::optional<ObjectView> readTexture(TextureView view) {
        const Texture& texture = in_.scene.textures[view.texture];
        for (std::size_t i = 1; i < value_.path.size(); ++i)
            if (!readPart(texture, value_.path[i], view)) return std::nullopt;
        if (cube_ || face_) {
            if (!cube_ || !face_)
                return refuse("glib-E35", fmt::format("{0}: a part of several cube maps has a layer and a "
                                                      "face: {0}.layer(0).face(0)",
                                                      name_.name));
            view.layer = 6 * *cube_ + *face_;
        }
        // The number of layers depends on the level, which may stand after the layer.
        if (view.layer && !isLayerInRange(texture, view)) return std::nullopt;
        return view;
    }

    bool readPart(const Texture& texture, const NamePart& part, TextureView& view) {
        if (part.name == "prev" && texture.hasHistory) {
            if (!part.index.empty()) return surplusIndex(part), false;
            return std::exchange(view.isPrevious, true) ? (twice(part), false) : true;
        }
        if (const auto sampler = samplerNamed(part.name)) {
            if (!part.index.empty()) return surplusIndex(part), false;
            if (view.sampler) return twice(part), false;
            view.sampler = *sampler;
            return true;
        }
        const std::vector<std::string_view> parts = partsOf(texture);
        if (std::ranges::find(parts, part.name) == parts.end() || part.name == "prev")
            return noPart(part, parts, texture.hasHistory), false;
        const bool isCubes = texture.target == TextureTarget::cubeArray;
        std::optional<int>& number = part.name == "level"             ? view.level
                                     : isCubes && part.name == "face" ? face_
                                     : isCubes                        ? cube_
                                                                      : view.layer;
        if (number || (isCubes && part.name != "level" && view.layer)) return twice(part), false;
        if (part.index.empty()) {
            refuse("glib-E35", fmt::format("{0}.{1} needs a number: {0}.{1}(0)", name_.name, part.name));
            return false;
        }
        constexpr int kMost = 16'384;
        const int most = part.name == "level"  ? levelsOf(texture).value_or(15) - 1
                         : part.name == "face" ? 5
                         : isCubes             ? layersOf(texture, 0).value_or(6) / 6 - 1
                                               : kMost;
        const Value& index = part.index.front();
        if (part.name == "face" && index.kind == Value::Kind::expression)
            number = faceNamed(index.text);  // `sky.face(-y)`
        if (!number) number = integerIn(in_, index, fmt::format("{}.{}:", name_.name, part.name), 0, most);
        return number.has_value();
    }

    bool isLayerInRange(const Texture& texture, const TextureView& view) {
        const auto layers = layersOf(texture, view.level.value_or(0));
        if (!layers || *view.layer < *layers) return true;
        refuse("glib-E05",
               fmt::format("{}.layer: {} is not between 0 and {}", name_.name, *view.layer, *layers - 1));
        return false;
    }

    std::optional<SamplerIndex> samplerNamed(std::string_view name) const {
        const auto known = in_.modern.names.find(name);
        if (known == in_.modern.names.end()) return std::nullopt;
        const auto* sampler = std::get_if<SamplerIndex>(&known->second.object);
        return sampler != nullptr ? std::optional(*sampler) : std::nullopt;
    }

    static std::vector<std::string_view> partsOf(const Texture& texture) {
        std::vector<std::string_view> parts{"level", "prev"};
        const bool isCubes = texture.target == TextureTarget::cubeArray;
        if (isCubes || texture.target == TextureTarget::cube) parts.emplace_back("face");
        if (isArray(texture.target) || texture.target == TextureTarget::texture3D)
            parts.emplace_back("layer");
        return parts;
    }

    std::nullopt_t noPart(const NamePart& part, std::vector<std::string_view> parts, bool hasHistory) {
        if (in_.modern.lostNames.contains(part.name) || in_.modern.lostNames.contains(name_.name))
            return std::nullopt;
        if (part.name == "prev")
            return refuse(
                "glib-E35",
                fmt::format("'{0}' has no part 'prev'; write 'history' where it is declared", name_.name));
        if (!hasHistory) std::erase(parts, "prev");
        for (const auto& [name, declared] : in_.modern.names)
            if (declared.kind == NameKind::sampler) parts.push_back(name);
        std::string help = base::suggestion(part.name, parts);
        if (help.empty() && !parts.empty()) help = fmt::format("; it has {}", fmt::join(parts, ", "));
        return refuse("glib-E35", fmt::format("'{}' has no part '{}'{}", name_.name, part.name, help));
    }

    std::nullopt_t surplusIndex(const NamePart& part) {
        return refuse("glib-E18", fmt::format("{}.{} has no elements", name_.name, part.name));
    }
    std::nullopt_t twice(const NamePart& part) {
        return refuse("glib-E18",
                      fmt::format("{}: '{}' given twice, or two samplers", value_.text, part.name));
    }

    Interpreter& in_;
    const Value& value_;
    NamePart name_;                   ///< its subscript is never evaluated
    std::size_t firstPart_ = 1;       ///< after the name, in the path
    std::optional<int> cube_, face_;  ///< of several cube maps
};

/// A view of one of both kinds, or nothing with the reason reported.
template <class View>
std::optional<View> viewOf(Interpreter& in, const Value& value, std::string_view wanted) {
    const auto object = objectNamed(in, value);
    if (!object) return std::nullopt;
    if (const auto* view = std::get_if<View>(&*object)) return *view;
    return in.reportAt(value, "glib-E34", fmt::format("'{}' is not {}", value.text, wanted));
}

}  // namespace

bool declareName(Interpreter& in, const Command& command, const std::string& name, NameKind kind) {
    const auto refuse = [&](std::string text) {
        const Value& value = command.values.front();
        in.reportAt(value, "glib-E36", std::move(text));
        return false;
    };
    if (isReserved(name, kind))
        return refuse(fmt::format("'{}' has a meaning of its own; choose another name", name));
    const auto [known, isNew] =
        in.modern.names.try_emplace(name, DeclaredName{kind, in.place(command), &command, std::monostate{}});
    if (isNew || known->second.command == &command) return true;
    // Cameras and computed variables may be set again.
    const bool isSetAgain =
        kind == known->second.kind && (kind == NameKind::camera || kind == NameKind::computed);
    if (isSetAgain) return true;
    // Only what was computed from the first Let on can be computed anew.
    const auto isVariable = [](NameKind each) {
        return each == NameKind::variable || each == NameKind::computed;
    };
    return refuse(fmt::format(
        "'{}' is declared on {} already, as {}{}", name, lineOf(in, known->second.place),
        wordOfKind(known->second.kind),
        isVariable(kind) && isVariable(known->second.kind)
            ? fmt::format("; only if it begins with 'Let {} (expression)' may it be stated again", name)
            : std::string()));
}

void setObject(Interpreter& in, const std::string& name,
               const std::variant<std::monostate, TextureIndex, SamplerIndex, BufferIndex>& object) {
    in.modern.names[name].object = object;
}

const DeclaredName* declaredName(const Interpreter& in, std::string_view name) {
    if (in.names().findLocal(name)) return nullptr;
    const auto known = in.modern.names.find(name);
    return known != in.modern.names.end() ? &known->second : nullptr;
}

namespace {

/// True if the name means a texture or buffer here.
bool isObject(const Interpreter& in, std::string_view name) {
    if (objectOfScope(in, name) != nullptr) return true;
    const DeclaredName* declared = declaredName(in, name);
    return declared != nullptr && (declared->kind == NameKind::texture || declared->kind == NameKind::buffer);
}

}  // namespace

bool namesObject(const Interpreter& in, const Value& value) {
    return value.kind == Value::Kind::word && isObject(in, headOf(in, value));
}

bool choosesObject(Interpreter& in, const Value& value) {
    if (value.kind != Value::Kind::word || namesObject(in, value)) return false;
    const std::string& name = headOf(value);
    if (value.path.size() > 1 && in.names().lookUp(value.text) != nullptr) return false;
    if (!value.path.empty() && !value.path.front().index.empty()) return false;
    const std::string word = wordBehind(in, name);
    return word != name && isObject(in, word);
}

std::optional<ObjectView> objectNamed(Interpreter& in, const Value& value) {
    return PartReader(in, value).read();
}

std::optional<TextureView> textureNamed(Interpreter& in, const Value& value) {
    return viewOf<TextureView>(in, value, "a texture");
}

std::optional<BufferView> bufferNamed(Interpreter& in, const Value& value) {
    return viewOf<BufferView>(in, value, "a buffer");
}

std::optional<ProgramIndex> programNamed(Interpreter& in, const Value& name, bool isCompute) {
    const auto computes = [&](ProgramIndex program) {
        return in.scene.programs[program].hasStage(glsl::Stage::compute);
    };
    const auto refuse = [&](const char* id, std::string text) {
        return in.reportAt(name, id, std::move(text));
    };
    auto known = in.modern.programs.find(name.text);
    if (known == in.modern.programs.end()) known = in.modern.programs.find(wordBehind(in, name.text));
    if (known == in.modern.programs.end()) {
        if (in.modern.lostNames.contains(name.text)) return std::nullopt;
        std::vector<std::string_view> names;
        for (const auto& [each, program] : in.modern.programs)
            if (computes(program) == isCompute) names.push_back(each);
        return refuse("glib-E27", fmt::format("no program '{}' is declared before this line{}", name.text,
                                              base::suggestion(name.text, names)));
    }
    if (computes(known->second) == isCompute) return known->second;
    return refuse("glib-E34",
                  isCompute ? fmt::format("program '{}' has no compute stage; write Compute before its "
                                          "Program statement, because a stage is for one program alone",
                                          name.text)
                            : fmt::format("program '{}' has a compute stage; Dispatch runs it", name.text));
}

std::string wordBehind(Interpreter& in, const std::string& name) {
    const Environment& names = in.names();
    const expression::Symbol* const symbol = names.lookUp(name);
    if (symbol == nullptr || symbol->words.empty()) return name;
    const double* number = names.find(symbol->slot, 0);
    if (number == nullptr || !(*number >= 0 && *number < static_cast<double>(symbol->words.size())))
        return name;
    noteRead(in, name, symbol->slot, in.script->place({}));
    addDepends(in, names.dependsOf(symbol->slot));
    return symbol->words[static_cast<std::size_t>(*number)];
}

std::optional<std::string> takeMember(Interpreter& in, Value& name, std::string_view what) {
    if (name.path.empty()) return std::string();
    const DeclaredName* declared = declaredName(in, name.path.front().name);
    const bool isOfMesh = declared != nullptr && declared->kind == NameKind::mesh;  // "pot.position"
    std::size_t own = std::min<std::size_t>(isOfMesh ? 2 : 1, name.path.size());
    if (own < name.path.size() && name.path[own].name == "prev") ++own;
    std::string member;
    for (std::size_t i = own; i < name.path.size(); ++i) {
        member += (member.empty() ? "" : ".") + name.path[i].name;
        if (name.path[i].index.empty()) continue;
        const auto element = integerIn(in, name.path[i].index.front(), fmt::format("{}: the subscript", what),
                                       0, kMostVertices);
        if (!element) return std::nullopt;
        member += fmt::format("[{}]", *element);
    }
    if (member.empty()) return member;
    name.path.resize(own);
    name.text.clear();
    for (const auto& each : name.path) name.text += (name.text.empty() ? "" : ".") + each.name;
    return member;
}

bool endsInSampler(const Interpreter& in, const Value& value) {
    if (value.path.size() < 2 || !value.path.back().index.empty()) return false;
    const auto known = in.modern.names.find(value.path.back().name);
    return known != in.modern.names.end() && known->second.kind == NameKind::sampler;
}

bool isWindow(const Value& value) {
    return value.kind == Value::Kind::word && value.text == "window";
}

}  // namespace glibra::scene
