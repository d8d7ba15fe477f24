#include "support.h"

#include <array>

namespace glibra::expression::test {

NameTable sceneTable() {
    NameTable table;
    table.addSceneNames();
    const auto number = [&](const char* name, double value) {
        table.add(name, Type::number(), Depends::variable);
        table.set(name, value);
    };
    number("a", 2);
    number("b", 3);
    number("c", 5);
    number("x", -.5);
    table.set("time", 2.5);
    table.set("aspect", 1.5);
    table.set("window", std::array{600., 400.});
    table.set("mouse", std::array{.25, .75});
    table.set("mouse.down", 1);
    table.add("yes", Type::boolean(), Depends::variable);
    table.add("no", Type::boolean(), Depends::variable);
    table.set("yes", 1);
    table.set("no", 0.);
    table.add("u", Type::vector(2), Depends::variable);
    table.add("v", Type::vector(3), Depends::variable);
    table.add("w", Type::vector(4), Depends::variable);
    table.set("u", std::array{1., 2.});
    table.set("v", std::array{1., 2., 3.});
    table.set("w", std::array{1., 2., 3., 4.});
    table.add("m3", Type::matrix(3), Depends::variable);
    table.add("m4", Type::matrix(4), Depends::variable);
    table.set("m3", std::array{2., 0., 1., 1., 3., 0., 0., 1., 4.});
    table.set("m4", std::array{2., 0., 1., 0., 1., 3., 0., 0., 0., 1., 4., 0., 5., 6., 7., 1.});
    table.add("pose", Type::number(), Depends::variable, 6);
    for (std::size_t k = 0; k < 6; ++k) table.set("pose", 10 + static_cast<double>(k), k);
    table.add("points", Type::vector(2), Depends::variable, 2);
    table.set("points", std::array{1., 2.}, 0);
    table.set("points", std::array{3., 4.}, 1);
    table.add("color", {.type = Type::number(),
                        .depends = Depends::variable,
                        .words = {"red", "green", "blue"},
                        .what = {}});
    table.set("color", 1);
    table.addCamera("light");
    table.set("light.near", .5);
    table.set("light.prev.near", .25);
    table.set("light.position", std::array{4., 5., 6.});
    table.addCamera("slice", 3);
    for (std::size_t k = 0; k < 3; ++k) table.set("slice.far", 100 * static_cast<double>(k), k);
    table.add("brick", {.type = Type::record(), .depends = Depends::texture, .words = {}, .what = "texture"});
    table.add("brick.size", Type::vector(2), Depends::texture);
    table.set("brick.size", std::array{512., 256.});
    return table;
}

Expression parsed(std::string_view text, const Wanted& wanted) {
    auto expression = parse(text, {}, sceneTable(), wanted);
    EXPECT_TRUE(expression) << text << ": " << toString(expression.problem.message);
    return expression ? *expression : *parse("0", {}, NameTable());
}

Value valueOf(std::string_view text) {
    const auto value = parsed(text).evaluate(sceneTable());
    EXPECT_TRUE(value) << text << ": " << toString(value.problem.message);
    return value ? *value : Value{};
}

double numberOf(std::string_view text) {
    const Value value = valueOf(text);
    EXPECT_EQ(value.type.size(), 1U) << text;
    return value.number();
}

Problem problemOf(std::string_view text, const Wanted& wanted) {
    const NameTable table = sceneTable();
    const auto expression = parse(text, {}, table, wanted);
    if (!expression) return expression.problem;
    const auto value = expression->evaluate(table);
    EXPECT_FALSE(value) << text;
    return value.problem;
}

std::string problemText(std::string_view text, const Wanted& wanted) {
    const Problem problem = problemOf(text, wanted);
    return problem.message.id + " '" +
           std::string(text.substr(problem.range.begin, problem.range.end - problem.range.begin)) +
           "': " + problem.message.text;
}

}  // namespace glibra::expression::test
