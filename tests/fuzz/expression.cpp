// Each line of any bytes as an expression: read, and evaluated twice.

#include <algorithm>
#include <array>
#include <cmath>

#include "../expression/table_of_names.h"
#include "check.h"
#include "expression/expression.h"
#include "expression/functions.h"
#include "text_mutator.h"

namespace {

using namespace glibra::expression;
using glibra::expression::test::NameTable;
using glibra::fuzz::check;

constexpr std::array<std::string_view, 3> kWords{"front", "back", "off"};
constexpr std::array kTypes{Type::number(), Type::boolean(), Type::word(), Type::vector(3), Type::matrix(4)};

NameTable table() {
    NameTable names;
    names.addSceneNames();
    for (const NameRow& each : sceneNames())
        names.set(each.path,
                  std::vector<double>(each.type.size(), each.type.kind == Kind::boolean ? 1 : .75));
    names.addCamera("light");
    names.addCamera("slice", 3);
    names.add("pose", Type::number(), Depends::variable, 6);
    for (std::size_t k = 0; k < 5; ++k)
        names.set("pose", static_cast<double>(k), k);  // the last one has no value
    names.add("v", Type::vector(3), Depends::variable);
    names.set("v", std::array{1., -2., 3e100});
    names.add("m", Type::matrix(3), Depends::variable);
    names.set("m", std::array{1., 2., 3., 4., 5., 6., 7., 8., 10.});
    names.add("mode",
              {.type = Type::number(), .depends = Depends::variable, .words = {"off", "back"}, .what = {}});
    names.set("mode", 1);
    return names;
}

void checkProblem(const Problem& problem, std::size_t size) {
    glibra::fuzz::checkMessages({problem.message});
    check(problem.message.id.starts_with("expr-E"), "a problem has an id");
    check(problem.range.begin <= problem.range.end && problem.range.end <= size,
          "a range lies inside the text");
}

void attempt(std::string_view text, const NameTable& names, const Wanted& wanted) {
    const auto expression = parse(text, {}, names, wanted);
    if (!expression) {
        checkProblem(expression.problem, text.size());
        return;
    }
    check(*parse(text, {}, names, wanted) == *expression, "a text means the same twice");
    const auto value = expression->evaluate(names);
    const auto again = expression->evaluate(names);
    check(static_cast<bool>(value) == static_cast<bool>(again), "an expression has a value twice, or never");
    if (!value) return checkProblem(value.problem, text.size());
    check(*value == *again, "an expression has the same value twice");
    check(value->type == expression->type(), "a value has the type of its expression");
    for (const double each : value->all()) check(std::isfinite(each), "a value is finite");
    if (value->type == Type::word()) check(value->word() < kWords.size(), "a word is one of those wanted");
    if (!any(expression->depends()) && expression->uses().empty())
        check(expression->constant() == *value, "what depends on nothing is constant");
}

}  // namespace

const glibra::fuzz::Grammar& glibra::fuzz::grammar() {
    static const Grammar kGrammar = [] {
        Grammar made;
        for (const FunctionRow& row : functionTable()) {
            made.words.emplace_back(row.name());
            made.statements.push_back(std::string(row.name()) + "(1, v, m)");
        }
        for (const NameRow& each : sceneNames()) made.words.emplace_back(each.path);
        for (const NameRow& each : cameraFields()) {
            made.words.push_back("light." + std::string(each.path));
            made.words.push_back("slice[1].prev." + std::string(each.path));
        }
        for (const std::string_view word : kWords) made.words.emplace_back(word);
        for (const char* each :
             {"(a ? front : back)", "pose[i - 1] * 2", "mode == back", "v.zyx / 0", "!(1 < 2) && true"})
            made.statements.emplace_back(each);
        made.separators = " \t,;()[]<>=!?:.+-*/%&|^~";
        return made;
    }();
    return kGrammar;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const NameTable names = table();
    std::string_view text = glibra::fuzz::textOf(data, size);
    for (int line = 0; line < 200 && !text.empty(); ++line) {
        const std::string_view one = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), one.size() + 1));
        attempt(one, names, {});
        attempt(one, names, {kTypes, kWords});
    }
    return 0;
}
