// A scene of 100,000 lines, against two loops that do less: one only splits the text into words, the other
// also reads the numbers.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

#include "glib/script.h"

namespace {

using namespace glibra;

constexpr int kLines = 100'000;

/// Objects of eight lines each: a comment, a matrix, transforms, a colour, a shape, an empty line.
const std::string& scene() {
    static const std::string made = [] {
        std::string text = "##OpenGL GLIB\nVertex a.vert\nFragment a.frag\nProgram A uKa .2 uKd <0. .7 1.>\n";
        for (int i = 0, lines = 4; lines < kLines; ++i, lines += 8)
            fmt::format_to(std::back_inserter(text),
                           "# object {0}\nPushMatrix\n\tTranslate {1:.3f} {2:.3f} 0.\n\tRotate {3} 0. 1. 0.\n"
                           "\tColor {4:.2f} .5 0.\n\tSphere 1. 20 20\nPopMatrix\n\n",
                           i, .01 * i, 1 - .02 * i, i % 360, i % 100 / 100.);
        return text;
    }();
    return made;
}

void report(benchmark::State& state) {
    state.counters["lines/s"] = benchmark::Counter(
        static_cast<double>(kLines) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

void parseScene(benchmark::State& state) {
    const std::string& text = scene();
    for (auto _ : state) benchmark::DoNotOptimize(glib::parse(text, "long.glib"));
    report(state);
}

template <bool readsNumbers>
void splitScene(benchmark::State& state) {
    const std::string& text = scene();
    for (auto _ : state) {
        std::size_t words = 0;
        double sum = 0;
        for (std::size_t at = 0;;) {
            at = text.find_first_not_of(" \t\n", at);
            if (at == std::string::npos) break;
            const std::size_t end = std::min(text.find_first_of(" \t\n", at), text.size());
            ++words;
            if constexpr (readsNumbers) {
                double value = 0;
                std::from_chars(text.data() + at, text.data() + end, value);
                sum += value;
            }
            at = end;
        }
        benchmark::DoNotOptimize(words);
        benchmark::DoNotOptimize(sum);
    }
    report(state);
}

BENCHMARK(parseScene)->Unit(benchmark::kMillisecond);
BENCHMARK(splitScene<false>)->Name("splitIntoWords")->Unit(benchmark::kMillisecond);
BENCHMARK(splitScene<true>)->Name("splitIntoWordsAndNumbers")->Unit(benchmark::kMillisecond);

}  // namespace
