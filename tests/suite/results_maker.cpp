#include "results_maker.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <iterator>
#include <limits>

namespace glibra::suite {
namespace {

std::uint64_t bits(double value) {
    return std::bit_cast<std::uint64_t>(value);
}
std::uint64_t bits(const std::optional<double>& value) {
    return value ? bits(*value) : 0xDEAD;
}

}  // namespace

std::string ResultsMaker::text() {
    const char* const pieces[] = {"teapot",       "\"",
                                  "\\",           "\n",
                                  "\t",           "\x01",
                                  "\x7f",         "\xc3\xa9",
                                  "\xe2\x80\xa8", "\xf0\x9f\xab\x96",
                                  "</script>",    "{\"bytes\":\"\"}",
                                  "\xff",         "\xc3",
                                  "\xed\xa0\x80", " "};
    std::string made;
    for (std::size_t count = below(6); count > 0; --count) made += pieces[below(std::size(pieces))];
    if (below(8) == 0) made.push_back('\0');
    return made;
}

double ResultsMaker::figure() {
    switch (below(8)) {
        case 0:
            return std::numeric_limits<double>::infinity();
        case 1:
            return -std::numeric_limits<double>::infinity();
        case 2:
            return std::numeric_limits<double>::quiet_NaN();
        case 3:
            return -0.;
        case 4:
            return static_cast<double>(below(1000));
        case 5:
            return std::numeric_limits<double>::denorm_min();
        default:
            break;
    }
    const double any = std::bit_cast<double>(random_());
    return std::isfinite(any) ? any : 0.1;
}

Diagnostic ResultsMaker::diagnostic() {
    return {static_cast<Severity>(below(3)), text(), text(),
            Place{text(), static_cast<int>(below(1U << 31U)), static_cast<int>(below(100))}};
}

ShotResult ResultsMaker::shot() {
    ShotResult made;
    made.suite = text();
    made.shot = text();
    made.verdict = static_cast<Verdict>(below(9));
    made.reason = text();
    made.script = text();
    made.got = text();
    made.expected = text();
    made.difference = text();
    const char* const variants[] = {"", "nvidia", "d3d12", "osmesa-llvmpipe", "also9"};
    made.goldenVariant = variants[below(std::size(variants))];
    made.exact = chance();
    made.changed = chance();
    made.width = static_cast<int>(below(1 << 24));
    made.height = static_cast<int>(below(1 << 24));
    made.judgement.same = chance();
    made.judgement.decidedBy = static_cast<image::Rung>(below(6));
    made.judgement.reason = text();
    made.judgement.comparison = {chance(),
                                 chance(),
                                 random_(),
                                 figure(),
                                 static_cast<int>(below(9)),
                                 static_cast<int>(below(9)),
                                 static_cast<int>(below(4)),
                                 figure()};
    made.judgement.beyond = random_();
    made.judgement.bias = figure();
    made.judgement.flip = maybe();
    made.judgement.structure = maybe();
    made.tolerance = {.largest = figure(),
                      .fraction = figure(),
                      .cluster = static_cast<int>(below(100)),
                      .line = static_cast<int>(below(100)),
                      .bias = figure(),
                      .flip = maybe(),
                      .structure = maybe(),
                      .relative = figure(),
                      .absolute = figure()};
    made.judgement.cluster = random_();
    made.judgement.line = random_();
    made.judgement.clusterX = static_cast<int>(random_());
    made.judgement.clusterY = static_cast<int>(random_());
    made.judgement.biasX = static_cast<int>(random_());
    made.judgement.biasY = static_cast<int>(random_());
    for (std::size_t count = below(3); count > 0; --count) made.diagnostics.push_back(diagnostic());
    made.milliseconds = static_cast<double>(below(1'000'000'000)) / 7;
    made.steps = {{figure(), figure()}, {random_(), random_()}};
    made.toPass = text();
    made.noTolerance = text();
    made.awaits = {text(), text()};
    made.awaitsStore = chance();
    made.reproduce = text();
    made.accept = text();
    made.driver = text();
    made.fingerprint = text();
    made.driverKey = text();
    made.acceptKey = text();
    return made;
}

RunResult ResultsMaker::run() {
    RunResult made;
    made.driver = text();
    made.machine = text();
    made.shard = text();
    made.command = text();
    made.seconds = static_cast<double>(below(1'000'000'000)) / 7;
    made.began = text();
    made.missingShards = text();
    if (chance()) made.planned = {{text(), {text(), text()}, text()}, {text(), {}}};
    return made;
}

void expectEqual(const ShotResult& a, const ShotResult& b) {
    EXPECT_EQ(a.suite, b.suite);
    EXPECT_EQ(a.fingerprint, b.fingerprint);
    EXPECT_EQ(a.driverKey, b.driverKey);
    EXPECT_EQ(a.acceptKey, b.acceptKey);
    EXPECT_EQ(a.steps.pixels, b.steps.pixels);
    EXPECT_EQ(a.steps.limits.size(), b.steps.limits.size());
    EXPECT_EQ(a.toPass, b.toPass);
    EXPECT_EQ(a.noTolerance, b.noTolerance);
    EXPECT_EQ(a.awaits, b.awaits);
    EXPECT_EQ(a.awaitsStore, b.awaitsStore);
    EXPECT_EQ(a.shot, b.shot);
    EXPECT_EQ(a.verdict, b.verdict);
    EXPECT_EQ(a.reason, b.reason);
    EXPECT_EQ(a.script, b.script);
    EXPECT_EQ(a.got, b.got);
    EXPECT_EQ(a.expected, b.expected);
    EXPECT_EQ(a.difference, b.difference);
    EXPECT_EQ(a.goldenVariant, b.goldenVariant);
    EXPECT_EQ(a.exact, b.exact);
    EXPECT_EQ(a.changed, b.changed);
    EXPECT_EQ(a.width, b.width);
    EXPECT_EQ(a.height, b.height);
    EXPECT_EQ(a.judgement.same, b.judgement.same);
    EXPECT_EQ(a.judgement.decidedBy, b.judgement.decidedBy);
    EXPECT_EQ(a.judgement.reason, b.judgement.reason);
    const image::Comparison &first = a.judgement.comparison, &second = b.judgement.comparison;
    EXPECT_EQ(first.sameSize, second.sameSize);
    EXPECT_EQ(first.identical, second.identical);
    EXPECT_EQ(first.differingPixels, second.differingPixels);
    EXPECT_EQ(bits(first.largest), bits(second.largest));
    EXPECT_EQ(first.x, second.x);
    EXPECT_EQ(first.y, second.y);
    EXPECT_EQ(first.component, second.component);
    EXPECT_EQ(bits(first.rootMeanSquare), bits(second.rootMeanSquare));
    EXPECT_EQ(a.judgement.beyond, b.judgement.beyond);
    EXPECT_EQ(bits(a.judgement.bias), bits(b.judgement.bias));
    EXPECT_EQ(bits(a.judgement.flip), bits(b.judgement.flip));
    EXPECT_EQ(bits(a.judgement.structure), bits(b.judgement.structure));
    EXPECT_EQ(bits(a.tolerance.largest), bits(b.tolerance.largest));
    EXPECT_EQ(bits(a.tolerance.fraction), bits(b.tolerance.fraction));
    EXPECT_EQ(a.tolerance.cluster, b.tolerance.cluster);
    EXPECT_EQ(a.judgement.cluster, b.judgement.cluster);
    EXPECT_EQ(a.judgement.clusterX, b.judgement.clusterX);
    EXPECT_EQ(a.judgement.clusterY, b.judgement.clusterY);
    EXPECT_EQ(a.judgement.biasX, b.judgement.biasX);
    EXPECT_EQ(a.judgement.biasY, b.judgement.biasY);
    EXPECT_EQ(bits(a.tolerance.bias), bits(b.tolerance.bias));
    EXPECT_EQ(bits(a.tolerance.flip), bits(b.tolerance.flip));
    EXPECT_EQ(bits(a.tolerance.structure), bits(b.tolerance.structure));
    EXPECT_EQ(bits(a.tolerance.relative), bits(b.tolerance.relative));
    EXPECT_EQ(bits(a.tolerance.absolute), bits(b.tolerance.absolute));
    ASSERT_EQ(a.diagnostics.size(), b.diagnostics.size());
    for (std::size_t i = 0; i < a.diagnostics.size(); ++i) {
        EXPECT_EQ(a.diagnostics[i].severity, b.diagnostics[i].severity);
        EXPECT_EQ(a.diagnostics[i].id, b.diagnostics[i].id);
        EXPECT_EQ(a.diagnostics[i].text, b.diagnostics[i].text);
        EXPECT_EQ(a.diagnostics[i].place, b.diagnostics[i].place);
    }
    EXPECT_EQ(bits(a.milliseconds), bits(b.milliseconds));
    EXPECT_EQ(a.reproduce, b.reproduce);
    EXPECT_EQ(a.accept, b.accept);
    EXPECT_EQ(a.driver, b.driver);
}

}  // namespace glibra::suite
