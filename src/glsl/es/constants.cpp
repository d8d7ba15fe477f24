#include "glsl/es/constants.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <utility>

#include "glsl/parse/types.h"

namespace glibra::glsl {
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
