#include "render/check/answers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/text.h"

namespace glibra::render {
namespace {

using scene::Check;
using Kind = scene::Check::Kind;
using Numbers = std::span<const double>;

/// Half of the distance of stored values, and what the conversion to float may add.
constexpr double kHalfStep = .5 + 1e-4;

constexpr std::size_t kMostShown = 8;       // numbers in a message
constexpr std::size_t kMostPrinted = 1000;  // texels or elements of a Print

/// A number with as many digits as tell it from its neighbours: all of a whole number, nine of a float.
std::string shownNumber(double number, bool isDouble = false) {
    if (std::isnan(number)) return "nan";
    constexpr double kWhole = 0x1p53;  // below it, every whole number is a double
    const bool isWhole = std::abs(number) < kWhole && std::trunc(number) == number;
    return isWhole    ? fmt::format("{:.0f}", number)
           : isDouble ? fmt::format("{}", number)
                      : fmt::format("{:.9g}", number);
}

std::string numbersText(Numbers numbers, bool areDoubles) {
    std::vector<std::string> shown;
    for (const double each : numbers.first(std::min(numbers.size(), kMostShown)))
        shown.push_back(shownNumber(each, areDoubles));
    return fmt::format("{}{}", fmt::join(shown, " "), shown.size() < numbers.size() ? " ..." : "");
}

/// Counts what fails, and keeps texts of the first few.
class Examples {
  public:
    template <class Text>
    void add(const Text& text) {
        constexpr std::size_t kKept = 4;
        if (++count_ <= kKept) texts_.push_back(text());
    }
    [[nodiscard]] std::size_t count() const { return count_; }
    /// "1 at 0, 2 at 3, ...": with dots if there are more.
    [[nodiscard]] std::string text() const {
        return fmt::format("{}{}", fmt::join(texts_, ", "), texts_.size() < count_ ? ", ..." : "");
    }

  private:
    std::size_t count_ = 0;
    std::vector<std::string> texts_;
};

/// Where an element lies: "3 4", "3 4 of face 1" of a texture, "3" of a buffer.
std::string placeOf(const Content& content, std::size_t element) {
    const auto width = static_cast<std::size_t>(content.width);
    const auto height = static_cast<std::size_t>(content.height);
    const std::size_t row = element / width;
    std::string place = std::to_string(element % width + static_cast<std::size_t>(content.left));
    if (content.hasRows || content.height * content.depth > 1)
        place += fmt::format(" {}", row % height + static_cast<std::size_t>(content.bottom));
    if (content.depth > 1) place += fmt::format(" of {} {}", content.isCube ? "face" : "layer", row / height);
    return place;
}

/// The same of value number `index`: "3 4 of face 1, component 2".
std::string positionOf(const Content& content, std::size_t index) {
    const auto components = static_cast<std::size_t>(content.components);
    std::string position = placeOf(content, index / components);
    if (components == 1) return position;
    const std::size_t component = index % components;
    return position +
           fmt::format(", component {}", content.picked.empty() ? component : content.picked[component]);
}

class Answerer {
  public:
    Answerer(const Check& check, const CheckQuestions& questions) : check_(check), ask_(questions) {}

    std::optional<Diagnostic> answer() {
        switch (check_.kind) {
            case Kind::pixel:
                return onContent([this](const Content& c) { return pixel(c); });
            case Kind::mean:
                return onContent([this](const Content& c) { return mean(c); });
            case Kind::count:
                return onContent([this](const Content& c) { return count(c); });
            case Kind::buffer:
                return onContent([this](const Content& c) { return elements(c); });
            case Kind::range:
                return onContent([this](const Content& c) { return range(c); });
            case Kind::finite:
                return onContent([this](const Content& c) { return finite(c); });
            case Kind::sum:
                return onContent([this](const Content& c) { return sum(c); });
            case Kind::same:
            case Kind::different:
                return onContent([this](const Content& c) { return relation(c); });
            case Kind::primitives:
                return number("primitives", ask_.primitives());
            case Kind::samples:
                return number("samples", ask_.samples());
            case Kind::condition:
                return condition();
            case Kind::error:
                break;
        }
        return std::nullopt;
    }

  private:
    using Answer = std::optional<Diagnostic>;

    [[nodiscard]] Diagnostic wrong(const std::string& expected, const std::string& found) const {
        return diagnose("check-E01", fmt::format("{}: expected {}, found {}", check_.text, expected, found),
                        check_.place);
    }
    [[nodiscard]] Diagnostic refused(const std::string& why) const {
        return diagnose("check-E02", fmt::format("{}: {}", check_.text, why), check_.place);
    }

    [[nodiscard]] std::string text(double number) const { return shownNumber(number, isOfDoubles_); }
    [[nodiscard]] std::string text(Numbers numbers) const { return numbersText(numbers, isOfDoubles_); }

    static std::string reasonOf(const Diagnostics& problems) {
        return problems.empty() ? "it cannot be read" : problems.front().text;
    }

    template <class Work>
    Answer onContent(const Work& work) {
        const auto content = ask_.contents.of(check_.of);
        if (!content) return refused(reasonOf(content.diagnostics));
        isOfDoubles_ = (*content)->isOfDoubles;
        return work(**content);
    }

    /// Values of a normalised format are equal if they are the same multiple of its step.
    [[nodiscard]] bool equal(double wanted, double found, const Content& content) const {
        if (wanted == found || (std::isnan(wanted) && std::isnan(found))) return true;
        return std::abs(wanted - found) <= std::max(check_.tolerance, content.step * kHalfStep);
    }
    [[nodiscard]] bool equal(Numbers wanted, Numbers found, const Content& content) const {
        for (std::size_t i = 0; i < std::min(wanted.size(), found.size()); ++i)
            if (!equal(wanted[i], found[i], content)) return false;
        return true;
    }
    [[nodiscard]] std::string wantedText() const { return text(check_.wanted) + withinText(); }
    [[nodiscard]] std::string withinText() const {
        return check_.tolerance > 0 ? " within " + text(check_.tolerance) : std::string();
    }
    /// Why the wanted components do not fit the content; empty if they do.
    [[nodiscard]] std::string misfit(const Content& content) const {
        if (check_.wanted.size() <= static_cast<std::size_t>(content.components)) return {};
        return fmt::format("'{}' has {} components, not {}", content.name, content.components,
                           check_.wanted.size());
    }
    [[nodiscard]] static Numbers shown(Numbers found, std::size_t count) {
        return found.first(std::min(found.size(), count));
    }

    [[nodiscard]] Answer pixel(const Content& content) const {
        const double x = std::floor(check_.numbers.at(0)), y = std::floor(check_.numbers.at(1));
        if (!(x >= 0 && y >= 0 && x < content.width && y < content.height))
            return refused(
                fmt::format("'{}' has {} x {} pixels", content.name, content.width, content.height));
        if (const std::string why = misfit(content); !why.empty()) return refused(why);
        const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(content.width) +
                           static_cast<std::size_t>(x);
        const Numbers found = content.at(index);
        if (equal(check_.wanted, found, content)) return std::nullopt;
        return wrong(wantedText(), text(shown(found, check_.wanted.size())));
    }

    [[nodiscard]] Answer mean(const Content& content) const {
        const auto& n = check_.numbers;
        const double x = std::floor(n.at(0)), y = std::floor(n.at(1)), w = std::floor(n.at(2)),
                     h = std::floor(n.at(3));
        if (!(x >= 0 && y >= 0 && w >= 1 && h >= 1 && x + w <= content.width && y + h <= content.height))
            return refused(
                fmt::format("'{}' has {} x {} pixels", content.name, content.width, content.height));
        if (const std::string why = misfit(content); !why.empty()) return refused(why);
        Content area;
        area.components = content.components;
        for (auto row = static_cast<std::size_t>(y); row < static_cast<std::size_t>(y + h); ++row) {
            const std::size_t first =
                row * static_cast<std::size_t>(content.width) + static_cast<std::size_t>(x);
            for (std::size_t i = first; i < first + static_cast<std::size_t>(w); ++i)
                area.values.insert(area.values.end(), content.at(i).begin(), content.at(i).end());
        }
        std::vector<double> sum = sumsOf(area);
        for (double& each : sum) each /= w * h;
        if (equal(check_.wanted, sum, content)) return std::nullopt;
        return wrong(wantedText(), text(shown(sum, check_.wanted.size())));
    }

    [[nodiscard]] Answer count(const Content& content) const {
        if (const std::string why = misfit(content); !why.empty()) return refused(why);
        std::size_t found = 0;
        for (std::size_t i = 0; i < content.size(); ++i)
            found += equal(check_.wanted, content.at(i), content) ? 1U : 0U;
        const double least = check_.numbers.at(0), most = check_.numbers.back();
        const auto number = static_cast<double>(found);
        if (number >= least && number <= most) return std::nullopt;
        const std::string wanted =
            least == most ? text(least) : fmt::format("{} to {}", text(least), text(most));
        return wrong(wanted + " pixels", fmt::format("{}", found));
    }

    [[nodiscard]] Answer elements(const Content& content) const {
        const double first = check_.numbers.empty() ? 0 : std::floor(check_.numbers.front());
        const double begin = first * content.components;
        if (!(first >= 0) ||
            begin + static_cast<double>(check_.wanted.size()) > static_cast<double>(content.values.size()))
            return refused(fmt::format("'{}' has {} values in {} elements", content.name,
                                       content.values.size(), content.size()));
        const Numbers found =
            std::span(content.values).subspan(static_cast<std::size_t>(begin), check_.wanted.size());
        Examples differing;
        std::size_t wrongAt = 0;
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (equal(check_.wanted[i], found[i], content)) continue;
            if (differing.count() == 0) wrongAt = i;
            differing.add([&] {
                return fmt::format("value {} is {}, not {}", i, text(found[i]), text(check_.wanted[i]));
            });
        }
        if (differing.count() == 0) return std::nullopt;
        if (found.size() <= kMostShown) return wrong(wantedText(), text(found));
        if (differing.count() == 1)
            return wrong(fmt::format("{} as value {}", text(check_.wanted[wrongAt]), wrongAt),
                         text(found[wrongAt]));
        return wrong(base::counted(found.size(), "value"),
                     fmt::format("{} that differ: {}", differing.count(), differing.text()));
    }

    /// Reports the values that fail.
    template <class Holds>
    [[nodiscard]] Answer each(const Content& content, const std::string& wanted, const Holds& holds) const {
        Examples failing;
        for (std::size_t i = 0; i < content.values.size(); ++i)
            if (!holds(content.values[i]))
                failing.add(
                    [&] { return fmt::format("{} at {}", text(content.values[i]), positionOf(content, i)); });
        if (failing.count() == 0) return std::nullopt;
        if (failing.count() == 1) return wrong(wanted, failing.text());
        return wrong(wanted, fmt::format("{} others: {}", failing.count(), failing.text()));
    }
    [[nodiscard]] Answer range(const Content& content) const {
        const double least = check_.numbers.at(0), most = check_.numbers.at(1);
        return each(content, fmt::format("{} to {}", text(least), text(most)),
                    [&](double value) { return value >= least && value <= most; });
    }
    [[nodiscard]] Answer finite(const Content& content) const {
        return each(content, "finite values", [](double value) { return std::isfinite(value); });
    }

    [[nodiscard]] Answer sum(const Content& content) const {
        if (const std::string why = misfit(content); !why.empty()) return refused(why);
        const std::vector<double> sums = sumsOf(content);
        bool holds = true;
        for (std::size_t i = 0; i < check_.wanted.size(); ++i) {
            if (sums[i] == check_.wanted[i]) continue;
            holds = holds && std::abs(sums[i] - check_.wanted[i]) <= check_.tolerance;
        }
        if (holds) return std::nullopt;
        return wrong(wantedText(), text(shown(sums, check_.wanted.size())));
    }

    [[nodiscard]] Answer relation(const Content& content) const {
        const auto read = ask_.contents.of(check_.other);
        if (!read) return refused(reasonOf(read.diagnostics));
        const Content* const other = read->get();
        const bool fits = content.width == other->width && content.height == other->height &&
                          content.depth == other->depth && content.components == other->components;
        const bool wantsSame = check_.kind == Kind::same;
        if (!fits) {
            if (!wantsSame) return std::nullopt;
            return wrong("the same content",
                         fmt::format("{} x {} x {} x {} and {} x {} x {} x {} values", content.width,
                                     content.height, content.depth, content.components, other->width,
                                     other->height, other->depth, other->components));
        }
        Examples differing;
        double largest = 0;
        for (std::size_t i = 0; i < content.values.size(); ++i) {
            const double a = content.values[i], b = other->values[i];
            if (a == b || (std::isnan(a) && std::isnan(b)) || std::abs(a - b) <= check_.tolerance) continue;
            differing.add(
                [&] { return fmt::format("{} and {} at {}", text(a), text(b), positionOf(content, i)); });
            if (!std::isnan(a - b)) largest = std::max(largest, std::abs(a - b));
        }
        if (wantsSame == (differing.count() == 0)) return std::nullopt;
        return wantsSame
                   ? wrong("the same content" + withinText(),
                           fmt::format("{}{}: {}", base::counted(differing.count(), "differing value"),
                                       largest > 0 ? ", by up to " + text(largest) : "", differing.text()))
                   : wrong("different content", "the same" + withinText());
    }

    [[nodiscard]] Answer number(const char* what, std::uint64_t found) const {
        const double wanted = check_.numbers.at(0);
        if (std::abs(static_cast<double>(found) - wanted) <= check_.tolerance) return std::nullopt;
        return wrong(fmt::format("{} {}{}", text(wanted), what, withinText()), fmt::format("{}", found));
    }

    [[nodiscard]] Answer condition() const {
        const Result<scene::Answer> answer = ask_.condition(check_);
        if (!answer)
            return answer.diagnostics.empty() ? refused("it has no value") : answer.diagnostics.front();
        return answer->value.truth() ? std::nullopt : Answer(wrong("true", answer->found));
    }

    const Check& check_;
    const CheckQuestions& ask_;
    bool isOfDoubles_ = false;  ///< Content::isOfDoubles
};

}  // namespace

std::optional<Diagnostic> answer(const Check& check, const CheckQuestions& questions) {
    return Answerer(check, questions).answer();
}

namespace {

/// The numbers of an element: records member by member, matrices row by row.
std::string elementText(const Content& content, Numbers numbers) {
    const auto text = [&](std::size_t i) {
        const bool isDouble =
            i < content.kinds.size() && content.kinds[i] == plan::NumberKind::doublePrecision;
        return shownNumber(numbers[i], isDouble);
    };
    std::string all;
    const auto add = [&](std::size_t first, std::size_t count, std::size_t step) {
        for (std::size_t i = 0; i < count; ++i) all += " " + text(first + i * step);
    };
    if (content.members.empty()) add(0, numbers.size(), 1);
    for (const plan::BufferColumn& each : content.members) {
        if (content.members.size() > 1)
            all += fmt::format("{} {}", &each != &content.members.front() ? "," : "", each.name);
        const auto columns = static_cast<std::size_t>(each.matrixColumns);
        const std::size_t rows = each.count / columns;
        if (columns == 1) add(each.first, each.count, 1);
        for (std::size_t row = 0; columns > 1 && row < rows; ++row) {
            const std::size_t at = all.size() + 1;
            add(each.first + row, columns, rows);
            all.insert(at, "[");
            all += "]";
        }
    }
    return all;
}

}  // namespace

Diagnostics printedElements(const scene::Print& print, const Content& content) {
    Diagnostics notes;
    const std::size_t count = content.size();
    for (std::size_t i = 0; i < std::min<std::size_t>(count, kMostPrinted); ++i)
        notes.push_back(diagnose(
            "check-N02",
            fmt::format("{}[{}]:{}", print.name, placeOf(content, i), elementText(content, content.at(i))),
            print.place));
    if (count > kMostPrinted)
        notes.push_back(diagnose("check-N02",
                                 fmt::format("Print {}: {} more {}; --save {}=FILE.{} writes all", print.name,
                                             count - kMostPrinted, content.isBuffer ? "elements" : "texels",
                                             content.name, content.isBuffer ? "csv" : "exr"),
                                 print.place));
    return notes;
}

Diagnostics withoutExpected(const std::vector<Check>& checks, Diagnostics diagnostics) {
    Diagnostics missing;
    for (const Check& each : checks) {
        if (each.kind != Kind::error) continue;
        const auto removed =
            std::erase_if(diagnostics, [&](const Diagnostic& found) { return found.id == each.word; });
        if (removed == 0)
            missing.push_back(diagnose(
                "check-E01", fmt::format("{}: expected {}, which was not reported", each.text, each.word),
                each.place));
    }
    append(diagnostics, std::move(missing));
    return diagnostics;
}

Diagnostics withoutPicture(const std::vector<Check>& checks, Diagnostics diagnostics) {
    std::string causes;
    for (const Diagnostic& each : diagnostics)
        if (each.severity == Severity::error && causes.find(each.id) == std::string::npos)
            causes += (causes.empty() ? "" : ", ") + each.id;
    diagnostics = withoutExpected(checks, std::move(diagnostics));
    if (hasError(diagnostics)) return diagnostics;
    for (const Check& each : checks)
        if (each.kind != Kind::error)
            diagnostics.push_back(
                diagnose("check-E02",
                         fmt::format("{}: there is no picture to look at, because of {}", each.text, causes),
                         each.place));
    return diagnostics;
}

Diagnostics reportIdle(const std::vector<scene::IdleCheck>& checks) {
    Diagnostics diagnostics;
    for (const scene::IdleCheck& each : checks)
        diagnostics.push_back(diagnose(each.mayRun ? "check-N01" : "check-W01",
                                       fmt::format("{} is not answered: {}", each.text, each.why),
                                       each.place));
    return diagnostics;
}

}  // namespace glibra::render
