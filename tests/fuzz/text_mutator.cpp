// The custom mutator and the custom crossover of libFuzzer for text (see text_mutator.h).

#include "text_mutator.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <utility>

#include "check.h"
#include "random.h"

/// Changes bytes without regard to any form. libFuzzer has one, and driver.cpp has another.
extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t largest);

namespace glibra::fuzz {
namespace {

using Lines = std::vector<std::string>;

Lines linesOf(std::string_view text) {
    Lines lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return lines;
}

std::string textOf(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) text += line;
    return text;
}

/// A range of bytes of a line.
struct Token {
    std::size_t begin, length;
};

std::vector<Token> tokensOf(std::string_view line) {
    const std::string_view separators = grammar().separators;
    const auto separates = [&](char c) {
        return c == '\n' || c == '\r' || separators.find(c) != separators.npos;
    };
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < line.size();) {
        std::size_t end = at;
        while (end < line.size() && !separates(line[end])) ++end;
        if (end > at) tokens.push_back({at, end - at});
        at = end + 1;
    }
    return tokens;
}

bool beginsNumber(std::string_view token) {
    return !token.empty() && (std::isdigit(static_cast<unsigned char>(token.front())) ||
                              token.front() == '-' || token.front() == '+' || token.front() == '.');
}

std::string replacement(std::string_view old, Random& random) {
    if (beginsNumber(old) ? !random.oneIn(8) : random.oneIn(8))
        return std::string(random.oneOf(kExtremeNumbers));
    return grammar().words.empty() ? std::string(old) : random.oneOf(grammar().words);
}

void changeTokens(std::string& line, Random& random) {
    const std::vector<Token> tokens = tokensOf(line);
    if (tokens.empty()) return;
    const auto [at, length] = random.oneOf(tokens);
    switch (random.below(6)) {
        case 0:
        case 1:
            line.replace(at, length, replacement(std::string_view(line).substr(at, length), random));
            break;
        case 2: {  // swap two
            Token first{at, length}, second = random.oneOf(tokens);
            if (first.begin == second.begin) break;
            if (first.begin > second.begin) std::swap(first, second);
            const std::string a = line.substr(first.begin, first.length),
                              b = line.substr(second.begin, second.length);
            line.replace(second.begin, second.length, a);
            line.replace(first.begin, first.length, b);
            break;
        }
        case 3:
            line.erase(at, length);
            break;
        case 4:
            line.insert(at, line.substr(at, length) + " ");
            break;
        default:
            line.insert(at, replacement({}, random) + " ");
            break;
    }
}

std::string newStatement(Random& random) {
    if (!grammar().statements.empty()) return random.oneOf(grammar().statements) + "\n";
    return grammar().words.empty() ? "\n" : random.oneOf(grammar().words) + "\n";
}

void changeLines(Lines& lines, Random& random) {
    const auto place = [&] {
        return lines.begin() + static_cast<std::ptrdiff_t>(random.below(lines.size() + 1));
    };
    const std::size_t index = random.below(lines.size());
    switch (random.below(8)) {
        case 0:
            if (!lines.empty()) lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(index));
            break;
        case 1:
            if (!lines.empty()) lines.insert(place(), std::string(lines[index]));
            break;
        case 2:
            if (!lines.empty()) std::swap(lines[index], lines[random.below(lines.size())]);
            break;
        case 3:
            lines.insert(place(), newStatement(random));
            break;
        case 4:  // often enough to meet a limit
            if (!lines.empty() && random.oneIn(8))
                lines.insert(place(), std::size_t{1} << random.below(11), std::string(lines[index]));
            break;
        default:
            if (!lines.empty()) changeTokens(lines[index], random);
            break;
    }
}

std::size_t store(std::string_view text, std::uint8_t* data, std::size_t largest) {
    const std::size_t size = std::min(text.size(), largest);
    std::memcpy(data, text.data(), size);
    return size;
}

}  // namespace
}  // namespace glibra::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t largest,
                                               unsigned seed) {
    using namespace glibra::fuzz;
    Random random(seed);
    if (random.oneIn(4)) return LLVMFuzzerMutate(data, size, largest);
    Lines lines = linesOf(textOf(data, size));
    for (std::size_t changes = 1 + random.below(4); changes > 0; --changes) changeLines(lines, random);
    return store(textOf(lines), data, largest);
}

/// Lines of the first input, then lines of the second, then the rest of the first.
extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* first, std::size_t firstSize,
                                                 const std::uint8_t* second, std::size_t secondSize,
                                                 std::uint8_t* out, std::size_t largest, unsigned seed) {
    using namespace glibra::fuzz;
    Random random(seed);
    Lines lines = linesOf(textOf(first, firstSize));
    const Lines others = linesOf(textOf(second, secondSize));
    const std::size_t from = random.below(others.size()), count = 1 + random.below(others.size() - from);
    const auto begin = others.begin() + static_cast<std::ptrdiff_t>(from);
    if (!others.empty())
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(random.below(lines.size() + 1)), begin,
                     begin + static_cast<std::ptrdiff_t>(count));
    return store(textOf(lines), out, largest);
}
