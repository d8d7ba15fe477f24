#include "expression/constructors.h"

#include <fmt/format.h>

#include <cmath>

#include "expression/apply.h"

namespace glibra::expression {
namespace {

const char* applyCut(double* stack, const Instruction& /*i*/) {
    stack[0] = std::trunc(stack[0]);
    return nullptr;
}

/// The type that a constructor makes.
Type typeNamed(std::string_view name) {
    if (name == "float" || name == "int") return Type::number();
    if (name == "bool") return Type::boolean();
    const auto size = static_cast<std::size_t>(name.back() - '0');
    if (name.starts_with("mat")) return Type::matrix(size);
    return Type::vector(size, name.starts_with("bvec") ? Kind::boolean : Kind::number);
}

Construction with(const Type& type, Apply apply, std::size_t components) {
    Construction construction{{type, {}}, nullptr, {}};
    construction.call.instruction.op = Op::call;
    construction.call.instruction.apply = apply;
    construction.call.instruction.a = static_cast<std::uint8_t>(components);
    construction.call.instruction.n = static_cast<std::uint8_t>(type.size());
    return construction;
}

}  // namespace

Construction construct(std::string_view name, std::span<const Type> arguments) {
    const Type type = typeNamed(name);
    const auto fail = [](const char* id, std::string why) { return Construction{{}, id, std::move(why)}; };
    std::size_t components = 0;
    for (const Type& each : arguments) {
        if (each.kind != Kind::number && each.kind != Kind::boolean)
            return fail("expr-E03", fmt::format("{} is not made of a {}", name, expression::name(each)));
        if (each.isMatrix() && (arguments.size() > 1 || type.isVector()))
            return fail("expr-E03",
                        fmt::format("{} is not made of a matrix; use its columns, such as m[0]", name));
        components += each.size();
    }
    const std::size_t wanted = type.size();
    const Type first = arguments.empty() ? Type{} : arguments.front();
    if (wanted == 1) {
        if (arguments.size() != 1)
            return fail("expr-E04", fmt::format("{} takes 1 argument, found {}", name, arguments.size()));
        return with(type, name == "int" ? applyCut : name == "bool" ? applyTruth : applyFirst, components);
    }
    if (arguments.size() == 1 && first.isMatrix()) return with(type, applyResize, components);
    if (arguments.size() == 1 && first.size() == 1 && type.isMatrix())
        return with(type, applyDiagonal, components);
    const auto booleans = [&](Construction construction) {
        if (type.kind != Kind::boolean) return construction;
        construction.call.instruction.apply =
            construction.call.instruction.apply == applySpread
                ? +[](double* stack, const Instruction& i) {
                      applySpread(stack, i);
                      return applyTruth(stack, i);
                  }
                : applyTruth;
        return construction;
    };
    if (arguments.size() == 1 && first.size() == 1) return booleans(with(type, applySpread, components));
    // GLSL: the last argument may have more components than are needed, but not only such.
    const bool hasUnused =
        components > wanted && (type.isMatrix() || components - arguments.back().size() >= wanted);
    if (components < wanted || hasUnused)
        return fail("expr-E04", fmt::format("{} needs {} components, found {}", name, wanted, components));
    return booleans(with(type, applyFirst, components));
}

}  // namespace glibra::expression
