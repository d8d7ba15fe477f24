#include "glsl/es/expressions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <utility>

#include "glsl/parse/types.h"
#include "glsl/read/words.h"

namespace glibra::glsl {

// ---- Conversions

namespace {

/// Functions of textures whose argument of that number is an offset, and stays an integer.
struct Offset {
    std::string_view function;
    std::size_t argument;
};
constexpr std::array kOffsets = std::to_array<Offset>({
    {"textureOffset", 2},
    {"textureProjOffset", 2},
    {"textureLodOffset", 3},
    {"textureProjLodOffset", 3},
    {"textureGradOffset", 4},
    {"textureProjGradOffset", 4},
});
/// Functions of textures that take numbers with fractions.
constexpr std::string_view kTextureFunctions =
    " texture textureProj textureLod textureProjLod textureGrad textureProjGrad textureOffset "
    "textureProjOffset textureLodOffset textureProjLodOffset textureGradOffset textureProjGradOffset ";
/// Functions that compare two vectors of one type.
constexpr std::string_view kComparisons =
    " lessThan lessThanEqual greaterThan greaterThanEqual equal notEqual ";

/// The type that both sides of an operator get.
BaseType commonBase(const Type& a, const Type& b) {
    for (const BaseType each : {BaseType::doublePrecision, BaseType::floating, BaseType::unsignedInteger})
        if (a.base == each || b.base == each) return each;
    return a.base;
}

bool joins(std::string_view sign) {
    return sign != "<<" && sign != ">>" && sign != "&&" && sign != "||" && sign != "^^" && sign != ",";
}

class Converter {
  public:
    explicit Converter(Unit& unit) : unit_(unit), bodies_(unit.bodies) {
        for (const Declaration& each : unit.syntax.declarations) {
            if (each.kind == DeclarationKind::function || each.kind == DeclarationKind::prototype)
                addFunction(each);
            if (each.type.isStruct) addStructure(each);
        }
        for (const Declaration& each : bodies_.declarations)
            if (each.type.isStruct) addStructure(each);
        for (const LocalVariable& each : bodies_.locals) locals_.emplace(each.name, each.type);
    }

    void run() {
        for (const Declaration& each : unit_.syntax.declarations) {
            if (each.code != kNone) visit(each.code);
            const Type type = typeOfWord(each.type.name);
            for (const Declarator& declarator : each.declarators) {
                // GLSL ES has no initialisers of uniforms.
                if (declarator.value == kNone || each.qualifiers.storage == Storage::uniform) continue;
                visit(declarator.value);
                give(declarator.value,
                     arrayOf(type, each.type.dimensions.size() + declarator.dimensions.size()));
            }
        }
    }

  private:
    struct Structure {
        std::vector<Type> members;
    };

    static Type typeOf(const Parameter& each) {
        return arrayOf(typeOfWord(each.type.name), each.type.dimensions.size() + each.dimensions.size());
    }
    void addFunction(const Declaration& declaration) {
        std::vector<const Declaration*>& known = functions_[unit_.text(declaration.name)];
        const bool isKnown = std::ranges::any_of(known, [&](const Declaration* each) {
            return std::ranges::equal(each->parameters, declaration.parameters, {}, typeOf, typeOf);
        });
        if (!isKnown) known.push_back(&declaration);
    }
    void addStructure(const Declaration& declaration) {
        Structure& structure = structures_[declaration.type.name];
        for (const Declaration& member : declaration.members)
            for (const Declarator& each : member.declarators)
                structure.members.push_back(arrayOf(typeOfWord(member.type.name),
                                                    member.type.dimensions.size() + each.dimensions.size()));
    }

    [[nodiscard]] const Node& node(std::uint32_t id) const { return bodies_.nodes[id]; }

    /// Inner conversions are written before outer ones, so that brackets nest.
    void visit(std::uint32_t id) {
        for (const std::uint32_t each : bodies_.children(id)) visit(each);
        const Node& at = node(id);
        if (at.kind == NodeKind::chain) chain(at);
        if (at.kind == NodeKind::assignment) assign(at);
        if (at.kind == NodeKind::selection) select(at);
        if (at.kind == NodeKind::call) call(at);
        if (at.kind == NodeKind::arrayCall) {
            const Type element = typeOfWord(unit_.text(at.token));
            for (const std::uint32_t each : bodies_.children(id)) give(each, element);
        }
        if (at.kind != NodeKind::declarator || at.child == kNone) return;
        if (const auto local = locals_.find(at.token); local != locals_.end()) give(at.child, local->second);
    }

    /// Converts an integer to the base type of `wanted`, in its own shape.
    void give(std::uint32_t id, const Type& wanted) {
        if (node(id).kind == NodeKind::list) {
            Type element = wanted;
            if (element.arrayDepth > 0) --element.arrayDepth;
            const std::uint32_t inside = node(id).child;
            if (node(inside).kind != NodeKind::sequence) return give(inside, element);
            for (const std::uint32_t each : bodies_.children(inside)) give(each, element);
            return;
        }
        if (wanted.numeric()) convert(node(id).range(), node(id).type, wanted.base);
    }
    void convert(Range range, Type own, BaseType base) {
        if (!own.numeric() || !own.integral() || own.base == base || range.empty()) return;
        if (base != BaseType::floating && base != BaseType::unsignedInteger) return;
        if (own.base == BaseType::unsignedInteger && base != BaseType::floating) return;
        own.base = base;
        unit_.convert(range, wordOf(own));
    }

    void chain(const Node& at) {
        Type left;
        std::uint32_t end = at.first;
        bool isFirst = true;
        for (std::uint32_t each = at.child; each != kNone; each = node(each).next) {
            const Type right = node(each).type;
            const std::string_view sign = isFirst ? std::string_view() : unit_.text(node(each).first - 1);
            if (isFirst) {
                left = right;
            } else if (!joins(sign) || !left.numeric() || !right.numeric()) {
                left = binaryType(sign, left, right);
            } else {
                const BaseType base = commonBase(left, right);
                convert({at.first, end}, left, base);
                convert(node(each).range(), right, base);
                Type both = left, other = right;
                both.base = other.base = base;
                left = binaryType(sign, both, other);
            }
            end = node(each).end;
            isFirst = false;
        }
    }

    void assign(const Node& at) {
        const std::string_view sign = unit_.text(at.token);
        if (sign != "<<=" && sign != ">>=") give(node(at.child).next, node(at.child).type);
    }

    void select(const Node& at) {
        const std::uint32_t yes = node(at.child).next, no = node(yes).next;
        if (!node(yes).type.numeric() || !node(no).type.numeric()) return;
        const BaseType base = commonBase(node(yes).type, node(no).type);
        convert(node(yes).range(), node(yes).type, base);
        convert(node(no).range(), node(no).type, base);
    }

    void call(const Node& at) {
        const std::string_view name = unit_.text(at.token);
        if (const auto own = functions_.find(name); own != functions_.end())
            return ofFunction(at, own->second);
        if (const auto own = structures_.find(name); own != structures_.end()) {
            std::size_t i = 0;
            for (std::uint32_t each = at.child; each != kNone && i < own->second.members.size();
                 each = node(each).next)
                give(each, own->second.members[i++]);
            return;
        }
        if (unit_.isDeclared(name)) return;
        if (listed(kComparisons, name)) {
            BaseType base = BaseType::unknown;
            for (std::uint32_t each = at.child; each != kNone; each = node(each).next)
                base = base == BaseType::unknown ? node(each).type.base
                                                 : commonBase(node(each).type, scalarType(base));
            for (std::uint32_t each = at.child; each != kNone; each = node(each).next)
                convert(node(each).range(), node(each).type, base);
        }
        if (listed(kTextureFunctions, name)) ofTexture(at, name);
    }

    void ofFunction(const Node& at, const std::vector<const Declaration*>& overloads) {
        std::size_t count = 0;
        for (std::uint32_t each = at.child; each != kNone; each = node(each).next) ++count;
        // What fits several of one number of arguments has been converted already (chooseOverloads).
        const Declaration* only = nullptr;
        for (const Declaration* each : overloads) {
            if (each->parameters.size() != count) continue;
            if (only) return;
            only = each;
        }
        if (!only) return;
        std::size_t i = 0;
        for (std::uint32_t each = at.child; each != kNone; each = node(each).next) {
            const Parameter& parameter = only->parameters[i++];
            const Storage storage = parameter.qualifiers.storage;
            if (storage != Storage::output && storage != Storage::inputOutput) give(each, typeOf(parameter));
        }
    }

    void ofTexture(const Node& at, std::string_view name) {
        const auto* const offset =
            std::ranges::find_if(kOffsets, [&](const Offset& each) { return each.function == name; });
        std::size_t i = 0;
        for (std::uint32_t each = at.child; each != kNone; each = node(each).next, ++i) {
            if (i == 0 || (offset != kOffsets.end() && i == offset->argument)) continue;
            convert(node(each).range(), node(each).type, BaseType::floating);
        }
    }

    Unit& unit_;
    const Bodies& bodies_;
    std::map<std::string_view, std::vector<const Declaration*>> functions_;
    std::map<std::string_view, Structure> structures_;
    std::map<std::uint32_t, Type> locals_;  ///< by the token of the name
};

}  // namespace

void writeConversions(Unit& unit) {
    Converter(unit).run();
}

// ---- Initialisers of uniforms

namespace {

using Numbers = std::optional<std::vector<double>>;

/// The components of constant expressions of literals, constructors, arithmetic and constants of the file,
/// in single precision; matrices by columns, booleans as 0 and 1. Nothing for other expressions.
class Evaluation {
  public:
    explicit Evaluation(const Unit& unit) : unit_(unit) {}

    [[nodiscard]] Numbers of(std::uint32_t id) {
        if (depth_ > kDeepest) return std::nullopt;
        ++depth_;
        Numbers result = expression(id);
        --depth_;
        return result;
    }

  private:
    static constexpr int kDeepest = 100;

    [[nodiscard]] const Node& node(std::uint32_t id) const { return unit_.bodies.nodes[id]; }

    [[nodiscard]] Numbers expression(std::uint32_t id) {
        const Node& at = node(id);
        switch (at.kind) {
            case NodeKind::number:
                return literal(unit_.text(at.token), at.type);
            case NodeKind::name:
                return name(unit_.text(at.token));
            case NodeKind::group:
                return of(at.child);
            case NodeKind::prefix:
                return prefix(at);
            case NodeKind::chain:
                return chain(at);
            case NodeKind::call:
                return constructor(at, typeOfWord(unit_.text(at.token)));
            case NodeKind::arrayCall:
                return elements(at.child, typeOfWord(unit_.text(at.token)));
            default:
                return std::nullopt;
        }
    }

    static Numbers literal(std::string_view text, const Type& type) {
        if (type.base == BaseType::floating)
            return std::vector<double>{std::strtof(std::string(text).c_str(), nullptr)};
        if (!type.integral()) return std::nullopt;
        return std::vector<double>{static_cast<double>(std::strtoull(std::string(text).c_str(), nullptr, 0))};
    }

    [[nodiscard]] Numbers name(std::string_view text) {
        if (text == "true" || text == "false") return std::vector<double>{text == "true" ? 1. : 0.};
        const Variable* variable = unit_.firstVariable(text);
        if (!variable || variable->storage != Storage::constant || variable->isArray()) return std::nullopt;
        const Declaration& declaration = unit_.syntax.declarations[variable->declaration];
        const std::uint32_t value = declaration.declarators[variable->declarator].value;
        return value == kNone ? std::nullopt : of(value);
    }

    [[nodiscard]] Numbers prefix(const Node& at) {
        Numbers value = of(at.child);
        for (std::uint32_t i = at.first; value && i < node(at.child).first; ++i) {
            const std::string_view sign = unit_.text(i);
            if (sign != "-" && sign != "+") return std::nullopt;
            if (sign == "-")
                for (double& each : *value) each = -each;
        }
        return value;
    }

    [[nodiscard]] Numbers chain(const Node& at) {
        Numbers left = of(at.child);
        bool isIntegral = node(at.child).type.integral();  // what stands on the left: 1 / 2 * .5 is 0
        for (std::uint32_t each = node(at.child).next; left && each != kNone; each = node(each).next) {
            if (!at.type.numeric() || at.type.matrix()) return std::nullopt;
            isIntegral = isIntegral && node(each).type.integral();
            const Numbers right = of(each);
            left = right ? joined(*left, unit_.text(node(each).first - 1), *right, isIntegral) : std::nullopt;
        }
        return left;
    }
    static Numbers joined(const std::vector<double>& a, std::string_view sign, const std::vector<double>& b,
                          bool isIntegral) {
        if (a.size() != b.size() && a.size() != 1 && b.size() != 1) return std::nullopt;
        std::vector<double> all(std::max(a.size(), b.size()));
        for (std::size_t i = 0; i < all.size(); ++i) {
            const double x = a[a.size() == 1 ? 0 : i], y = b[b.size() == 1 ? 0 : i];
            if (sign == "+")
                all[i] = x + y;
            else if (sign == "-")
                all[i] = x - y;
            else if (sign == "*")
                all[i] = x * y;
            else if (sign == "/" && y != 0)
                all[i] = isIntegral ? std::trunc(x / y) : x / y;
            else
                return std::nullopt;
            if (!isIntegral) all[i] = static_cast<double>(static_cast<float>(all[i]));
        }
        return all;
    }

    [[nodiscard]] Numbers constructor(const Node& at, const Type& type) {
        if (!type.numeric() || unit_.isDeclared(unit_.text(at.token))) return std::nullopt;
        std::vector<double> all;
        for (std::uint32_t each = at.child; each != kNone; each = node(each).next) {
            const Numbers part = of(each);
            if (!part || node(each).type.matrix()) return std::nullopt;
            all.insert(all.end(), part->begin(), part->end());
        }
        const auto count = static_cast<std::size_t>(type.components());
        if (all.size() == 1 && type.matrix()) {
            const double diagonal = all.front();
            all.assign(count, 0);
            for (std::size_t i = 0; i < std::min(type.columns, type.rows); ++i)
                all[i * type.rows + i] = diagonal;
        } else if (all.size() == 1) {
            all = std::vector<double>(count, all.front());
        }
        if (all.size() < count) return std::nullopt;
        all.resize(count);
        if (type.integral())
            for (double& each : all) each = std::trunc(each);
        if (type.base == BaseType::boolean)
            for (double& each : all) each = each != 0 ? 1 : 0;
        return all;
    }

    [[nodiscard]] Numbers elements(std::uint32_t first, const Type& type) {
        if (!type.numeric()) return std::nullopt;
        std::vector<double> all;
        for (std::uint32_t each = first; each != kNone; each = node(each).next) {
            const Numbers part = of(each);
            if (!part || part->size() != static_cast<std::size_t>(type.components())) return std::nullopt;
            all.insert(all.end(), part->begin(), part->end());
        }
        return all;
    }

    const Unit& unit_;
    int depth_ = 0;
};

}  // namespace

bool addInitialValues(const Unit& unit, const std::string& uniform, std::string_view type, std::uint32_t node,
                      std::vector<InitialValue>& values) {
    const std::vector<Node>& nodes = unit.bodies.nodes;
    const auto structure = std::ranges::find_if(unit.syntax.declarations, [&](const Declaration& each) {
        return each.type.isStruct && each.type.name == type;
    });
    if (structure == unit.syntax.declarations.end()) {
        Numbers numbers = Evaluation(unit).of(node);
        if (numbers) values.push_back({uniform, std::string(type), std::move(*numbers)});
        return numbers.has_value();
    }
    std::uint32_t part = nodes[node].child;
    if (nodes[node].kind == NodeKind::arrayCall) {
        for (int i = 0; part != kNone; part = nodes[part].next, ++i)
            if (!addInitialValues(unit, uniform + "[" + std::to_string(i) + "]", type, part, values))
                return false;
        return true;
    }
    if (nodes[node].kind != NodeKind::call) return false;
    for (const Declaration& member : structure->members)
        for (const Declarator& each : member.declarators) {
            const std::string name = uniform + "." + std::string(unit.text(each.name));
            if (part == kNone || !addInitialValues(unit, name, member.type.name, part, values)) return false;
            part = nodes[part].next;
        }
    return true;
}

}  // namespace glibra::glsl
