#pragma once
// The types of expressions. Where the parser is not sure, the type is unknown.

#include <span>
#include <string_view>
#include <vector>

#include "glsl/parse/bodies.h"
#include "glsl/parse/scope.h"

namespace glibra::glsl {

class Expressions {
  public:
    Expressions(std::span<const ViewToken> view, const std::vector<std::uint32_t>& matches, Names& names,
                Bodies& bodies)
        : view_(view), matches_(matches), names_(names), bodies_(bodies) {}

    /// The type of the expression in `range`. Also records its calls and gives its words their roles.
    Type typeOf(Range range);
    /// Gives the words in `range` their roles.
    void markUses(Range range);

  private:
    [[nodiscard]] std::string_view peek(std::uint32_t ahead = 0) const;
    bool accept(std::string_view text);
    /// The index after the bracket that closes the one here.
    [[nodiscard]] std::uint32_t afterBracket() const;
    Type parse(Range range);
    Type assignment();
    Type binary(int lowest);
    Type unary();
    Type postfix();
    Type primary();
    Type call(std::uint32_t name);
    Type index(const Type& array);

    std::span<const ViewToken> view_;
    const std::vector<std::uint32_t>& matches_;
    Names& names_;
    Bodies& bodies_;
    std::uint32_t at_ = 0;
    std::uint32_t end_ = 0;
    int depth_ = 0;
};

}  // namespace glibra::glsl
