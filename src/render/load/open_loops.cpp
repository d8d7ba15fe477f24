#include "render/load/open_loops.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <string_view>

#include "base/text.h"

namespace glibra::render {
namespace {

constexpr double kManyRounds = 20'000;

/// Calls `use(word, offset)` for each word of a GLSL text outside of comments and directives.
template <class Use>
void forEachWord(std::string_view text, const Use& use) {
    const auto isOfWord = base::isOfName;
    bool isNewLine = true;
    for (std::size_t i = 0; i < text.size();) {
        const std::string_view rest = text.substr(i);
        if (rest.starts_with("//") || (isNewLine && rest.front() == '#')) {
            i = std::min(text.find('\n', i), text.size());
        } else if (rest.starts_with("/*")) {
            const std::size_t end = text.find("*/", i + 2);
            i = end == std::string_view::npos ? text.size() : end + 2;
        } else if (isOfWord(rest.front())) {
            const std::size_t begin = i;
            while (i < text.size() && isOfWord(text[i])) ++i;
            use(text.substr(begin, i - begin), begin);
            isNewLine = false;
        } else {
            isNewLine = rest.front() == '\n' || (isNewLine && rest.front() == ' ');
            ++i;
        }
    }
}

/// Adds the places of the loops whose rounds are not known.
void addUnknown(const glsl::CountedLoop& loop, const glsl::UniformValue& uniform, std::vector<Place>& to) {
    if (!(glsl::roundsOf(loop, uniform) > 0)) to.push_back(loop.place);
    for (const glsl::CountedLoop& each : loop.inside) addUnknown(each, uniform, to);
}

void addOnce(std::vector<Place>& places, const Place& place) {
    if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
}

}  // namespace

std::vector<Place> openLoops(const glsl::TranslatedStage& stage, const glsl::UniformValue& uniform) {
    std::vector<Place> open, result;
    double rounds = 0;
    for (const glsl::CountedLoop& each : stage.loops) {
        addUnknown(each, uniform, open);
        const double own = glsl::totalRounds(each, uniform);
        rounds += own;
        if (own > kManyRounds) addOnce(open, each.place);
    }
    if (rounds > kManyRounds && open.empty()) open.push_back(stage.loops.front().place);
    for (const Place& each : open) addOnce(result, each);
    for (const Place& each : stage.uncounted) addOnce(result, each);
    return result;
}

std::vector<Place> endlessLoops(const glsl::TranslatedStage& stage) {
    struct Word {
        std::string_view text;
        std::size_t at = 0;
    };
    const std::string_view source = stage.source;
    std::vector<Word> words;
    forEachWord(source, [&](std::string_view word, std::size_t at) { words.push_back({word, at}); });
    const auto matching = [&](std::size_t open, char begins, char ends) {
        int depth = 0;
        for (std::size_t at = open; at < source.size(); ++at) {
            depth += source[at] == begins ? 1 : source[at] == ends ? -1 : 0;
            if (depth == 0) return at;
        }
        return source.size();
    };
    const auto next = [&](std::size_t at) {
        return std::min(source.find_first_not_of(" \t\r\n", at), source.size());
    };
    const auto textAt = [&](std::size_t at, std::size_t length) {
        return source.substr(std::min(at, source.size()), length);
    };
    /// True if the word, or a part of its value, is assigned to, incremented or decremented there.
    const auto isWritten = [&](const Word& word) {
        std::size_t at = next(word.at + word.text.size());
        for (; textAt(at, 1) == "[" || textAt(at, 1) == "."; at = next(at))
            for (at = textAt(at, 1) == "[" ? matching(at, '[', ']') + 1 : next(at + 1);
                 at < source.size() && base::isOfName(source[at]);)
                ++at;
        const std::string_view after = textAt(at, 3);
        const std::size_t last =
            word.at == 0 ? std::string_view::npos : source.find_last_not_of(" \t\r\n", word.at - 1);
        const std::string_view before =
            last == std::string_view::npos || last < 1 ? "" : source.substr(last - 1, 2);
        const bool isAssigned = after.starts_with('=') ? !after.starts_with("==")
                                                       : after.size() > 1 && after[1] == '=' &&
                                                             std::string_view("+-*/%&|^").find(after[0]) !=
                                                                 std::string_view::npos;
        return isAssigned || after.starts_with("<<=") || after.starts_with(">>=") ||
               after.starts_with("++") || after.starts_with("--") || before == "++" || before == "--";
    };
    /// True if the word may get another value there, also as an argument of a function.
    const auto isChange = [&](const Word& word) {
        const std::size_t last =
            word.at == 0 ? std::string_view::npos : source.find_last_not_of(" \t\r\n", word.at - 1);
        const bool isArgument =
            last != std::string_view::npos && (source[last] == '(' || source[last] == ',');
        return isArgument || isWritten(word);
    };
    /// True if a function that is called in the range, or by such a function, may change a variable of that
    /// name, or waits for other invocations that may.
    const auto isChangedByCalls = [&](std::string_view name, std::size_t from, std::size_t to) {
        std::set<std::string_view> called;
        const std::function<bool(std::size_t, std::size_t)> search = [&](std::size_t first, std::size_t end) {
            return std::any_of(words.begin(), words.end(), [&](const Word& word) {
                if (word.at < first || word.at >= end || textAt(next(word.at + word.text.size()), 1) != "(")
                    return false;
                if (word.text.find("arrier") != std::string_view::npos) return true;
                if (!called.insert(word.text).second) return false;
                return std::any_of(words.begin(), words.end(), [&](const Word& defined) {
                    const std::size_t open = next(defined.at + defined.text.size());
                    if (defined.text != word.text || textAt(open, 1) != "(") return false;
                    const std::size_t body = next(matching(open, '(', ')') + 1);
                    if (textAt(body, 1) != "{") return false;
                    const std::size_t last = matching(body, '{', '}');
                    return search(body, last) ||
                           std::any_of(words.begin(), words.end(), [&](const Word& inside) {
                               return inside.at > body && inside.at < last && inside.text == name &&
                                      isChange(inside);
                           });
                });
            });
        };
        return search(from, to);
    };
    std::vector<Place> places;
    for (const Word& loop : words) {
        const std::size_t open = next(loop.at + loop.text.size());
        if ((loop.text != "for" && loop.text != "while") || open >= source.size() || source[open] != '(')
            continue;
        const std::size_t close = matching(open, '(', ')');
        std::size_t begin = open + 1, end = close;
        if (loop.text == "for") {
            begin = std::min(source.find(';', open) + 1, close);
            end = std::min(source.find(';', begin), close);
        }
        const std::string_view condition = source.substr(begin, end - begin);
        const std::size_t body = next(close + 1);
        if (body >= source.size() || source[body] == ';' || condition.find('(') != std::string_view::npos)
            continue;
        const std::size_t last = source[body] == '{' ? matching(body, '{', '}') : source.find(';', body);
        const auto isIn = [](const Word& word, std::size_t from, std::size_t to) {
            return word.at >= from && word.at < to;
        };
        const bool mayEnd = std::any_of(words.begin(), words.end(), [&](const Word& word) {
            if (isIn(word, begin, end)) return isWritten(word) || isChangedByCalls(word.text, begin, last);
            if (!isIn(word, end, last)) return false;
            if (word.text == "break" || word.text == "return" || word.text == "discard") return true;
            const bool isTested = std::any_of(words.begin(), words.end(), [&](const Word& tested) {
                return isIn(tested, begin, end) && tested.text == word.text;
            });
            return isTested && isChange(word);
        });
        const auto line = static_cast<std::size_t>(
            std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(loop.at), '\n'));
        if (mayEnd || line >= stage.lineMap.lines.size() || stage.lineMap.lines[line].file < 0) continue;
        addOnce(places, {stage.lineMap.files[static_cast<std::size_t>(stage.lineMap.lines[line].file)],
                         stage.lineMap.lines[line].line, 1});
    }
    return places;
}

void explainRemovedLoops(const scene::Scene& scene, const plan::FramePlan& plan, ProgramLibrary& programs,
                         Diagnostics& diagnostics) {
    const auto follows = [](const Diagnostic& each) {
        return each.id == "glib-W24" || each.id == "draw-W10";
    };
    if (std::ranges::none_of(diagnostics, follows)) return;
    std::vector<Place> explained;
    for (const plan::PlannedProgram& each : plan.programs) {
        const glsl::TranslatedProgram* text = programs.translated(each.variant);
        if (text == nullptr || !each.variant.program) continue;
        std::vector<Place> loops;
        for (const glsl::TranslatedStage& stage : text->stages)
            for (const Place& place : endlessLoops(stage)) addOnce(loops, place);
        // The subject of both messages is the program.
        const std::string& name = scene.programs[each.variant.program].name;
        const auto isOfLoop = [&](const Diagnostic& found) {
            return follows(found) && found.subject == name;
        };
        if (loops.empty() || std::erase_if(diagnostics, isOfLoop) == 0) continue;
        for (const Place& place : loops) addOnce(explained, place);
    }
    for (const Place& place : explained)
        diagnostics.push_back(diagnose("view-W02",
                                       "this loop never ends, because nothing in it changes its condition; "
                                       "compilers remove it with all that follows",
                                       place));
}

}  // namespace glibra::render
