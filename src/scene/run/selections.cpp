#include "scene/run/selections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "expression/measures.h"
#include "glib/number.h"
#include "scene/run/evaluate.h"
#include "scene/run/names.h"
#include "scene/run/scope.h"
#include "scene/textures.h"

namespace glibra::scene {
namespace {

using expression::Type;

constexpr std::array<std::string_view, 3> kLetters{"rgba", "xyzw", "stpq"};

/// True for one to four letters of components: `a`, `rgb`, `xy`.
bool isSwizzle(std::string_view text) {
    return text.size() <= 4 && std::ranges::any_of(kLetters, [&](std::string_view letters) {
               return text.find_first_not_of(letters) == std::string_view::npos;
           });
}

/// The letter that something with so many components has not; nothing if it has all.
std::optional<char> missingComponent(std::string_view swizzle, std::size_t components) {
    for (const std::string_view letters : kLetters)
        if (swizzle.find_first_not_of(letters) == std::string_view::npos)
            for (const char each : swizzle)
                if (letters.find(each) >= components) return each;
    return std::nullopt;
}

/// The components of a texel; a picture from a file has four.
std::size_t componentsOf(const Texture& texture) {
    const auto* empty = std::get_if<EmptySource>(&texture.source);
    if (empty == nullptr) return 4;
    return base::hasDepth(empty->format) ? 1 : base::rowOf(empty->format).components;
}

/// The type of an element; nothing for the structure of a shader.
std::optional<Type> elementOf(const Interpreter& in, const BufferView& view) {
    const expression::Symbol* const symbol = in.names().lookUpInScene(in.scene.buffers[view.buffer].name);
    if (symbol == nullptr || !Environment::isBuffer(*symbol)) return std::nullopt;
    return symbol->type;
}

/// The name of the object of a selection, for messages.
std::string nameOf(const Interpreter& in, const Selection& selection) {
    if (!selection.object) return "window";
    if (const auto* buffer = std::get_if<BufferView>(&*selection.object))
        return in.scene.buffers[buffer->buffer].name;
    return in.scene.textures[std::get<TextureView>(*selection.object).texture].name;
}

bool refuse(Interpreter& in, const Value& value, const char* id, std::string text) {
    in.reportAt(value, id, std::move(text));
    return false;
}

/// False with glib-E35 reported if the part is none of what is selected.
bool checkPart(Interpreter& in, const Value& value, const Selection& selection) {
    if (selection.part.empty()) return true;
    const std::string name = nameOf(in, selection);
    std::size_t components = 4;
    if (const auto* buffer = selection.object ? std::get_if<BufferView>(&*selection.object) : nullptr) {
        const auto type = elementOf(in, *buffer);
        if (!type) return true;
        if (type->isMatrix() || !isSwizzle(selection.part))
            return refuse(in, value, "glib-E35",
                          fmt::format("'{}' has no part '{}'; its elements are of the type {}", name,
                                      selection.part, in.scene.buffers[buffer->buffer].type));
        components = type->size();
    } else if (selection.object) {
        components = componentsOf(in.scene.textures[std::get<TextureView>(*selection.object).texture]);
    }
    const auto missing = missingComponent(selection.part, components);
    return !missing || refuse(in, value, "glib-E35",
                              fmt::format("'{}' has {}, and no component '{}'", name,
                                          base::counted(components, "component"), *missing));
}

std::optional<Selection> windowPart(Interpreter& in, const Value& value) {
    Selection selection;
    if (value.path.size() < 2) return selection;
    const glib::NamePart& part = value.path[1];
    if (value.path.size() > 2 || !part.index.empty() || !isSwizzle(part.name))
        return in.reportAt(
            value, "glib-E35",
            fmt::format("'{}': only components may stand after the window, as in window.rgb", value.text));
    selection.part = part.name;
    return selection;
}

}  // namespace

std::optional<Selection> selectionNamed(Interpreter& in, const Value& value) {
    if (value.kind == Value::Kind::word && headOf(value) == "window") return windowPart(in, value);
    Selection selection;
    Value name = value;
    const auto shorten = [&] {
        name.path.pop_back();
        name.text.resize(std::min(name.text.size(), name.text.rfind('.')));
    };
    // Whether it is a buffer decides what may follow.
    Value head = value;
    if (head.path.size() > 1) {
        const DeclaredName* const declared = declaredName(in, head.path.front().name);
        const bool isMesh = declared != nullptr && declared->kind == DeclaredName::Kind::mesh;
        head.path.resize(isMesh ? 2 : 1);
        head.text = head.path.front().name + (isMesh ? "." + head.path.back().name : "");
    }
    const auto whole = objectNamed(in, head);
    if (!whole) return std::nullopt;
    if (std::holds_alternative<BufferView>(*whole)) {
        auto member = takeMember(in, name, "the name");
        if (!member) return std::nullopt;
        selection.part = std::move(*member);
    } else if (name.path.size() > 1 && name.path.back().index.empty() && isSwizzle(name.path.back().name) &&
               !endsInSampler(in, name)) {
        selection.part = name.path.back().name;
        shorten();
    }
    selection.object = objectNamed(in, name);
    if (!selection.object || !checkPart(in, value, selection)) return std::nullopt;
    return selection;
}

bool selectArea(Interpreter& in, const Value& where, std::span<const double> numbers, std::string_view what,
                Selection& selection) {
    const std::string name = nameOf(in, selection);
    const auto* buffer = selection.object ? std::get_if<BufferView>(&*selection.object) : nullptr;
    const std::size_t wanted = buffer != nullptr ? 2 : 4;
    if (numbers.size() != wanted)
        return refuse(in, where, "glib-E26",
                      fmt::format("{}: {} of '{}' needs {}, found {}", what,
                                  buffer != nullptr ? "a range of elements" : "a rectangle", name,
                                  buffer != nullptr ? "2 numbers, the first and the last"
                                                    : "4 numbers, x y width height",
                                  numbers.size()));
    if (buffer != nullptr) {
        const double first = numbers[0], last = numbers[1];
        if (last < first)
            return refuse(in, where, "glib-E29",
                          fmt::format("{}: the first element {} stands after the last, {}", what,
                                      glib::numberText(first), glib::numberText(last)));
        const Buffer& declared = in.scene.buffers[buffer->buffer];
        const bool isOutside = first < 0 || (declared.count && elementOf(in, *buffer) &&
                                             last >= static_cast<double>(*declared.count));
        if (isOutside)
            return refuse(in, where, "glib-E05",
                          fmt::format("{}: the elements {} to {} are not all among the {} of '{}'", what,
                                      glib::numberText(first), glib::numberText(last),
                                      declared.count ? std::to_string(*declared.count) : "elements", name));
    } else {
        const double x = numbers[0], y = numbers[1], w = numbers[2], h = numbers[3];
        std::optional<std::array<int, 3>> size;
        if (selection.object) {
            const auto& view = std::get<TextureView>(*selection.object);
            size = sizeOfLevel(in.scene.textures[view.texture], view.level.value_or(0));
        }
        const bool isInside =
            x >= 0 && y >= 0 && w >= 1 && h >= 1 && (!size || (x + w <= (*size)[0] && y + h <= (*size)[1]));
        if (!isInside)
            return refuse(in, where, "glib-E05",
                          fmt::format("{}: the rectangle of {} x {} at {} {} is not inside of '{}'{}", what,
                                      glib::numberText(w), glib::numberText(h), glib::numberText(x),
                                      glib::numberText(y), name,
                                      size ? fmt::format(", which has {} x {} texels", (*size)[0], (*size)[1])
                                           : std::string()));
    }
    selection.area.assign(numbers.begin(), numbers.end());
    return true;
}

namespace {

/// The type of what a function makes of a selection; nothing for the structure of a shader.
std::optional<Type> typeOf(const Interpreter& in, const Selection& selection) {
    const auto* buffer = selection.object ? std::get_if<BufferView>(&*selection.object) : nullptr;
    if (buffer != nullptr && !elementOf(in, *buffer)) return std::nullopt;
    if (!selection.part.empty()) return Type::vector(selection.part.size());
    if (buffer != nullptr) return elementOf(in, *buffer);
    if (!selection.object) return Type::vector(4);
    return Type::vector(componentsOf(in.scene.textures[std::get<TextureView>(*selection.object).texture]));
}

/// A part of an expression's text as an expression, with its place in the scene.
Value partOf(const Value& expression, expression::Range range) {
    Value part;
    part.kind = Value::Kind::expression;
    part.text = expression.text.substr(range.begin, range.end - range.begin);
    part.position = glib::placeIn(expression, range.begin);
    --part.position.column;  // where the parenthesis of an expression stands
    return part;
}

/// The name in an argument as a value: `sky.face(+x).level(k)`.
Value nameIn(const Value& expression, expression::Range range) {
    const std::string& text = expression.text;
    constexpr std::string_view kBlanks = " \t\r\n\\";
    const std::size_t begin = std::min<std::size_t>(text.find_first_not_of(kBlanks, range.begin), range.end);
    const std::size_t last = text.find_last_not_of(kBlanks, range.end - 1);
    Value name;
    name.kind = Value::Kind::word;
    name.text = text.substr(begin, last + 1 - begin);
    name.position = glib::placeIn(expression, begin);
    for (std::size_t at = begin; at <= last;) {
        const std::size_t end = std::min(text.find_first_of(".([", at), last + 1);
        std::string word = text.substr(at, end - at);
        std::erase_if(word, [&](char c) { return kBlanks.find(c) != std::string_view::npos; });
        name.path.push_back({std::move(word), {}});
        at = end;
        if (at <= last && text[at] != '.') {
            int depth = 0;
            std::size_t close = at;
            for (; close <= last; ++close) {
                depth += text[close] == '(' || text[close] == '[' ? 1 : 0;
                depth -= text[close] == ')' || text[close] == ']' ? 1 : 0;
                if (depth == 0) break;
            }
            name.path.back().index.push_back(
                partOf(expression, {static_cast<std::uint32_t>(at + 1), static_cast<std::uint32_t>(close)}));
            at = close + 1;
        }
        at = std::min(text.find('.', at), last + 1) + 1;
    }
    return name;
}

/// False with expr-E07 reported if an argument of a call reads what is known only after the picture.
bool isKnownBefore(Interpreter& in, const Value& argument, std::string_view function) {
    const std::vector<std::string> paths = expression::pathsIn(argument.text);
    const auto isElement = [&](const std::string& path) {
        const expression::Symbol* const symbol = in.names().lookUp(path);
        return symbol != nullptr && Environment::isBuffer(*symbol) &&
               std::ranges::find(paths, path + ".count") == paths.end();
    };
    if (expression::measuresIn(argument.text).empty() && std::ranges::none_of(paths, isElement)) return true;
    return refuse(
        in, argument, "expr-E07",
        fmt::format("{}: its numbers and times are known before anything is drawn; they cannot read "
                    "what textures and buffers hold",
                    function));
}

/// What a call measures. Nothing with the reason reported.
std::optional<Measure> measureOf(Interpreter& in, const Value& value, const expression::MeasureCall& call,
                                 bool takesTimes) {
    const std::string function(call.function);
    const Value name = nameIn(value, call.object);
    auto selection = selectionNamed(in, name);
    if (!selection) return std::nullopt;
    std::vector<Value> arguments;
    for (const expression::Range each : call.numbers) {
        arguments.push_back(partOf(value, each));
        if (!isKnownBefore(in, arguments.back(), function)) return std::nullopt;
    }
    const auto numbers = wholesOf(in, arguments);
    if (!numbers) return std::nullopt;
    if (!numbers->empty() && !selectArea(in, arguments.front(), *numbers, function, *selection))
        return std::nullopt;
    Measure measure{function, std::move(*selection), {}};
    if (!call.seconds) return measure;
    const Value time = partOf(value, *call.seconds);
    if (!takesTimes) {
        in.reportAt(time, "glib-E32",
                    fmt::format("{}: 'at' stands in Expect (condition) alone; a Print looks at one picture",
                                function));
        return std::nullopt;
    }
    if (!isKnownBefore(in, time, function)) return std::nullopt;
    constexpr double kLatest = 1e12;
    const auto seconds = numberIn(in, time, fmt::format("{}: the time", function), 0, kLatest);
    if (!seconds) return std::nullopt;
    measure.seconds = *seconds;
    return measure;
}

}  // namespace

std::shared_ptr<const ConditionNames> namesOfQuestion(Interpreter& in, const Value& value,
                                                      const expression::Wanted& wanted, bool takesTimes) {
    auto names = std::make_shared<ConditionNames>();
    const InnerNames inner(in);
    Environment& environment = in.names();
    bool isKnown = true;  // the types of all names
    for (const expression::MeasureCall& call : expression::measuresIn(value.text)) {
        if (!call.why.empty()) break;  // reading the expression reports it
        if (names->find(call.path)) continue;
        auto measure = measureOf(in, value, call, takesTimes);
        if (!measure) return nullptr;
        const auto type = typeOf(in, measure->of);
        isKnown = isKnown && type;
        expression::Symbol symbol;
        symbol.type = type.value_or(Type::number());
        symbol.depends = expression::Depends::texture;
        environment.bind(call.path, symbol);
        ConditionNames::Name name{call.path, symbol, {}};
        name.measure = std::move(measure);
        names->add(std::move(name));
    }
    const std::vector<std::string> paths = expression::pathsIn(value.text);
    if (isKnown ? !supplyNames(in, value, wanted) : !supplyNames(in, value, paths)) return nullptr;
    // It is read again when it is answered, with all names in it: also those of what is folded, as in
    // arr.count.
    const NotedNames noted(environment);
    static_cast<void>(expression::parse(value.text, {}, noted, wanted));
    std::vector<NotedNames::Note> notes = noted.take();
    for (const std::string& path : paths) notes.emplace_back().path = path;  // if it was not read to its end
    for (const auto& [path, slot, elements, kind, function] : notes) {
        if (function != nullptr) names->add(function);
        const bool isOfScene = kind == NotedNames::Note::Kind::nameOfScene;
        if (kind == NotedNames::Note::Kind::function || names->has(path, isOfScene)) continue;
        const auto symbol = isOfScene ? environment.findInScene(path) : environment.find(path);
        if (!symbol) continue;
        ConditionNames::Name name{path, *symbol, {}};
        name.isOfScene = isOfScene;
        if (any(symbol->depends & expression::Depends::buffer)) {
            constexpr std::string_view kCount = ".count";
            const std::string head =
                path.ends_with(kCount) ? path.substr(0, path.size() - kCount.size()) : path;
            Value word;
            word.kind = Value::Kind::word;
            word.text = head;
            if (const std::size_t point = head.find('.'); point != std::string::npos)
                word.path = {{head.substr(0, point), {}}, {head.substr(point + 1), {}}};
            word.position = value.position;
            const auto object = objectNamed(in, word);
            if (const auto* view = object ? std::get_if<BufferView>(&*object) : nullptr) name.buffer = *view;
            const expression::Symbol* const found = environment.lookUp(head);
            if (found != nullptr && Environment::isBuffer(*found)) name.elementSize = found->type.size();
        }
        const std::size_t count = Environment::isBuffer(*symbol) ? 0 : std::max(1U, symbol->count);
        for (std::size_t i = 0; i < count; ++i) {
            const double* const found = environment.find(symbol->slot, i);
            name.has.push_back(found != nullptr);
            for (std::size_t k = 0; k < symbol->type.size(); ++k)
                name.components.push_back(found != nullptr ? found[k] : 0);
        }
        name.why = environment.whyMissing(symbol->slot, 0);
        names->add(std::move(name));
    }
    return names;
}

}  // namespace glibra::scene
