// Calls that read what textures and buffers hold: where they begin and end in an expression (language, 1.8).

#include "expression/measures.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support.h"

namespace glibra::expression::test {
namespace {

std::string slice(const std::string& text, Range range) {
    return text.substr(range.begin, range.end - range.begin);
}

/// "function|object|numbers...@seconds" of each call.
std::vector<std::string> callsIn(const std::string& text) {
    std::vector<std::string> all;
    for (const MeasureCall& each : measuresIn(text)) {
        std::string shown = std::string(each.function) + "|" + slice(text, each.object);
        for (const Range number : each.numbers) shown += "|" + slice(text, number);
        if (each.seconds) shown += "@" + slice(text, *each.seconds);
        all.push_back(each.why.empty() ? shown : each.why);
    }
    return all;
}

TEST(MeasureCalls, HaveANameNumbersAndATime) {
    using Calls = std::vector<std::string>;
    EXPECT_EQ(callsIn("1 + 2 * sin(x)"), Calls{});
    EXPECT_EQ(callsIn("sum(a) == mean(b.level(1)) at 3"), (Calls{"sum|a", "mean|b.level(1)@ 3"}));
    EXPECT_EQ(callsIn("largest(sky.face(+x).level(k + 1), 0, 0, min(4, n), 4).r"),
              Calls{"largest|sky.face(+x).level(k + 1)| 0| 0| min(4, n)| 4"});
    EXPECT_EQ(callsIn("sum(a).x at 0 - sum(a)[1] at (t + 1) * 2"), (Calls{"sum|a@ 0", "sum|a@ (t + 1)"}));
    EXPECT_EQ(callsIn("least(a) at t.x[2] > 0"), Calls{"least|a@ t.x[2]"});
    EXPECT_EQ(callsIn("least(a) at -1"), Calls{"least|a@ -1"});
    EXPECT_EQ(callsIn("sum(sum)"), Calls{"sum|sum"});
    EXPECT_EQ(callsIn("sum[0] + a.sum + sum"), Calls{}) << "names that are spelled like a function";
}

TEST(MeasureCalls, SayWhatIsWrong) {
    for (const char* text :
         {"sum()", "sum(1)", "sum(a + b)", "sum(a b)", "sum( , 1)", "sum(2 * a)", "sum(.a)"})
        EXPECT_EQ(callsIn(text),
                  std::vector<std::string>{"sum needs the name of a texture or buffer: sum(NAME)"})
            << text;
    EXPECT_EQ(callsIn("sum(a"), std::vector<std::string>{"sum: a closing parenthesis is missing"});
    EXPECT_EQ(callsIn("sum(a, (1"), std::vector<std::string>{"sum: a closing parenthesis is missing"});
    EXPECT_EQ(callsIn("sum(a) at"), std::vector<std::string>{"sum: a time in seconds follows 'at'"});
    EXPECT_EQ(callsIn("sum(a) at == 1"), std::vector<std::string>{"sum: a time in seconds follows 'at'"});
}

TEST(MeasureCalls, PathsAreThoseOutsideOfThem) {
    EXPECT_EQ(pathsIn("sum(a.level(k)) + b.c.d * side[i].view[0].x"),
              (std::vector<std::string>{"b", "b.c", "b.c.d", "side", "i", "side.view", "side.view.x"}));
}

TEST(MeasureCalls, AreValuesOfTheTypeThatTheirNameHas) {
    NameTable names = sceneTable();
    Symbol vector;
    vector.type = Type::vector(3);
    const double now[] = {1, 2, 3}, before[] = {10, 20, 30};
    names.set(names.add("sum(p)", vector), now, 0);
    names.set(names.add("sum(p) at   0", vector), before, 0);
    const auto value = [&](const char* text) {
        const auto parsed = parse(text, {}, names);
        if (!parsed) return toString(parsed.problem.message);
        const auto found = parsed->evaluate(names);
        return found ? std::to_string(found->number()) : toString(found.problem.message);
    };
    EXPECT_EQ(value("sum(p).y"), std::to_string(2.));
    EXPECT_EQ(value("sum(p).z at  0"), std::to_string(30.));
    EXPECT_EQ(value("(sum(p) at  0).y - 3 * sum(p)[1] at  0"), std::to_string(-40.));
    EXPECT_EQ(value("2 * sum(p).x at  0 + 1"), std::to_string(21.));
    EXPECT_NE(value("sum(q)").find("'sum(q)' has no value here: only Expect (condition) and Print"),
              std::string::npos)
        << value("sum(q)");
    EXPECT_NE(value("sum(p) at  0 at 1").find("found 'at'"), std::string::npos) << value("sum(p) at  0 at 1");
    EXPECT_NE(value("2 at 1").find("a time may stand after sum, mean, least and largest"), std::string::npos);
}

}  // namespace
}  // namespace glibra::expression::test
