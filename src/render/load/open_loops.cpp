#include "render/load/open_loops.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>
#include <utility>

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

/// Notes the places of the loops whose rounds are known and few, those in `open` otherwise.
void sortLoop(const glsl::CountedLoop& loop, const glsl::UniformValue& uniform, std::vector<Place>& counted,
              std::vector<Place>& open) {
    counted.push_back(loop.place);
    if (!(glsl::roundsOf(loop, uniform) > 0)) open.push_back(loop.place);
    for (const glsl::CountedLoop& each : loop.inside) sortLoop(each, uniform, counted, open);
}

void addOnce(std::vector<Place>& places, const Place& place) {
    if (std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
}

}  // namespace

std::vector<Place> openLoops(const glsl::TranslatedStage& stage, const glsl::UniformValue& uniform) {
    std::vector<Place> counted, open, result;
    double rounds = 0;
    for (const glsl::CountedLoop& each : stage.loops) {
        sortLoop(each, uniform, counted, open);
        const double own = glsl::totalRounds(each, uniform);
        rounds += own;
        if (own > kManyRounds) addOnce(open, each.place);
    }
    if (rounds > kManyRounds && open.empty()) open.push_back(stage.loops.front().place);
    for (const Place& each : open) addOnce(result, each);
    // Loops that are not counted: a line has more of their words than counted loops. A `do` ends with a
    // `while`, so only the latter is looked for.
    std::map<std::pair<int, int>, int> words;  // by file and line
    std::size_t from = 0, line = 0;
    forEachWord(stage.source, [&](std::string_view word, std::size_t at) {
        if (word != "for" && word != "while") return;
        for (; from < at; ++from)
            if (stage.source[from] == '\n') ++line;
        if (line >= stage.lineMap.lines.size() || stage.lineMap.lines[line].file < 0) return;
        ++words[{stage.lineMap.lines[line].file, stage.lineMap.lines[line].line}];
    });
    for (const auto& [key, number] : words) {
        const Place place{stage.lineMap.files[static_cast<std::size_t>(key.first)], key.second, 1};
        std::vector<Place> here;
        for (const Place& each : counted)
            if (each.line == place.line && each.file == place.file) addOnce(here, each);
        if (static_cast<std::size_t>(number) > here.size()) addOnce(result, place);
    }
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
    /// True if the word may get another value there.
    const auto isChange = [&](const Word& word) {
        const std::string_view after = source.substr(next(word.at + word.text.size())).substr(0, 3);
        const std::size_t last =
            word.at == 0 ? std::string_view::npos : source.find_last_not_of(" \t\r\n", word.at - 1);
        const std::string_view before =
            last == std::string_view::npos || last < 1 ? "" : source.substr(last - 1, 2);
        const bool isAssigned = after.starts_with('=') ? !after.starts_with("==")
                                                       : after.size() > 1 && after[1] == '=' &&
                                                             std::string_view("+-*/%&|^").find(after[0]) !=
                                                                 std::string_view::npos;
        return isAssigned || after.starts_with("<<=") || after.starts_with(">>=") ||
               after.starts_with("++") || after.starts_with("--") || before == "++" || before == "--" ||
               after.starts_with('[') || after.starts_with('.') ||
               (!before.empty() && (before.back() == '(' || before.back() == ','));
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
