// Finds the images and storage blocks that a compute stage writes whole: each invocation stores the texel, or
// the element, of its own number, under no condition except that the number is within a size.

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "glsl/facts/facts.h"
#include "glsl/facts/formula.h"
#include "glsl/parse/straight_line.h"
#include "glsl/parse/usage.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

/// A component of an integer vector, as far as the text shows what it is.
struct KnownNumber {
    bool isSize = false;  ///< of `object`; otherwise the number of the invocation
    int axis = 0;
    std::string_view object{};  ///< image, sampler or array
};
using KnownVector = std::vector<KnownNumber>;

/// The components of a type of integers; 0 for other types.
std::size_t integerComponents(std::string_view type) {
    if (type == "int" || type == "uint") return 1;
    if (type.size() != 5 || (!type.starts_with("ivec") && !type.starts_with("uvec"))) return 0;
    return type.back() >= '2' && type.back() <= '4' ? static_cast<std::size_t>(type.back() - '0') : 0;
}

/// The components of the size of an image or sampler, which are those of a texel's place too; 0 for shapes
/// whose texels have other numbers.
std::size_t axesOfTexels(std::string_view type) {
    for (const std::string_view other : {"Cube", "Buffer", "MS", "Rect", "Shadow"})
        if (type.find(other) != std::string_view::npos) return 0;
    const std::size_t layers = type.ends_with("Array") ? 1 : 0;
    for (const auto& [word, axes] : {std::pair{"1D", 1U}, std::pair{"2D", 2U}, std::pair{"3D", 3U}})
        if (type.find(word) != std::string_view::npos) return axes + layers;
    return 0;
}

class WholeWriteSearch {
  public:
    explicit WholeWriteSearch(const Unit& unit) : unit_(unit), search_(unit) {}

    std::vector<WholeWrite> find() {
        constexpr std::array<std::string_view, 9> kFunctions{
            "imageStore",  "imageSize",     "textureSize",     "any", "all", "lessThan",
            "greaterThan", "lessThanEqual", "greaterThanEqual"};
        const std::optional<Range> main = bodyOfMain(unit_);
        if (!main ||
            std::ranges::any_of(kFunctions, [&](std::string_view each) { return unit_.isUserName(each); }))
            return {};
        noteLocals(*main);
        findArrays();
        walk({main->first + 1, main->end - 1}, 0);
        std::vector<WholeWrite> found;
        for (const auto& [name, store] : stores_) {
            const auto& [axes, sizes] = store;
            if (!isOnlyStored(name)) continue;
            const auto array = arrays_.find(name);
            WholeWrite& write = found.emplace_back();
            write.axes = axes;
            write.isBlock = array != arrays_.end();
            write.name = write.isBlock ? array->second : name;
            for (const std::string_view each : sizes) {
                const auto sized = arrays_.find(each);
                write.sizes.emplace_back(sized == arrays_.end() ? each : sized->second);
            }
        }
        return found;
    }

  private:
    static constexpr int kDeepest = 32;
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] std::uint32_t match(std::uint32_t at) const { return search_.match(at); }
    [[nodiscard]] WordRole role(std::uint32_t at) const { return unit_.bodies.roles[at]; }
    /// True if a bracket opens at `at` and the range ends behind the one that closes it.
    [[nodiscard]] bool isBracket(Range range, std::string_view opens, std::uint32_t at) const {
        return range.contains(at) && text(at) == opens && match(at) + 1 == range.end;
    }
    /// The inside of a call of that function that is the whole range.
    [[nodiscard]] std::optional<Range> inside(Range range, std::string_view function) const {
        if (text(range.first) != function || !isBracket(range, "(", range.first + 1)) return std::nullopt;
        return Range{range.first + 2, range.end - 1};
    }
    [[nodiscard]] Range withoutBrackets(Range range) const {
        while (isBracket(range, "(", range.first)) range = {range.first + 1, range.end - 1};
        return range;
    }

    // ---- Names

    /// Local names that are declared once in main and never changed.
    void noteLocals(Range main) {
        std::map<std::string_view, int> declared;
        std::set<std::string_view> changed;
        const std::set<std::string_view> writing = functionsThatWriteArguments(unit_);
        std::uint32_t changing = main.first;  // the end of a call that may change its arguments
        for (std::uint32_t at = main.first; at < main.end; ++at) {
            if (role(at) == WordRole::localDeclaration) ++declared[text(at)];
            if (role(at) == WordRole::local && (at < changing || isWrittenAt(unit_, at)))
                changed.insert(text(at));
            if (role(at) == WordRole::global && text(at + 1) == "(" && writing.contains(text(at)))
                changing = std::max(changing, match(at + 1));
        }
        for (const auto& [name, count] : declared)
            if (count == 1 && !changed.contains(name)) kept_.insert(name);
    }

    /// Storage blocks that are a single array and nothing else.
    void findArrays() {
        for (const Declaration& each : unit_.syntax.declarations) {
            const bool isSingle = each.kind == DeclarationKind::block &&
                                  each.qualifiers.storage == Storage::buffer && each.declarators.empty() &&
                                  each.members.size() == 1 && each.members.front().declarators.size() == 1;
            if (!isSingle) continue;
            const Declaration& member = each.members.front();
            const Declarator& name = member.declarators.front();
            const bool isOpen = member.type.dimensions.empty() && name.dimensions.size() == 1 &&
                                name.dimensions.front().empty();
            if (isOpen) arrays_.emplace(text(name.name), std::string(text(each.name)));
        }
    }

    /// The type of a uniform that is no array; empty for everything else.
    [[nodiscard]] std::string_view uniformType(std::uint32_t at) const {
        if (role(at) != WordRole::global) return {};
        const Variable* found = unit_.firstVariable(text(at));
        const bool isIt =
            found != nullptr && found->storage == Storage::uniform && !found->isArray() && !found->removed;
        return isIt ? std::string_view(found->type) : std::string_view();
    }

    /// True if the stage does nothing with the image or array but store, and ask for its size.
    [[nodiscard]] bool isOnlyStored(std::string_view name) const {
        const auto uses = unit_.uses.find(name);
        if (uses == unit_.uses.end()) return false;
        return std::ranges::all_of(uses->second, [&](std::uint32_t at) {
            if (!arrays_.contains(name))
                return at >= 2 && text(at - 1) == "(" && role(at - 2) == WordRole::global &&
                       (text(at - 2) == "imageStore" || text(at - 2) == "imageSize");
            if (text(at + 1) == "." && text(at + 2) == "length") return true;
            return text(at + 1) == "[" && text(match(at + 1) + 1) == "=";
        });
    }

    // ---- Values

    /// What an expression of integers is.
    [[nodiscard]] std::optional<KnownVector> value(Range range, int depth) {
        range = withoutBrackets(range);
        if (range.empty() || depth > kDeepest || !search_.spend(range.end - range.first)) return std::nullopt;
        std::uint32_t at = range.first;
        std::optional<KnownVector> known = primary(at, range.end, depth);
        while (known && at < range.end) {
            if (text(at) != "." || at + 2 > range.end) return std::nullopt;
            known = swizzled(*known, text(at + 1));
            at += 2;
        }
        return known;
    }

    /// The value that begins at `at`, which moves behind it.
    std::optional<KnownVector> primary(std::uint32_t& at, std::uint32_t end, int depth) {
        const std::uint32_t name = at;
        const std::string_view word = text(name);
        if (word == "(") {
            const std::uint32_t close = match(at);
            if (close >= end) return std::nullopt;
            at = close + 1;
            return value({name + 1, close}, depth + 1);
        }
        if (word == "gl_GlobalInvocationID" && role(name) == WordRole::global) {
            ++at;
            return KnownVector{{false, 0}, {false, 1}, {false, 2}};
        }
        if (role(name) == WordRole::local) {
            ++at;
            return local(word, depth);
        }
        if (arrays_.contains(word) && role(name) == WordRole::global) {
            if (name + 5 > end || text(name + 1) != "." || text(name + 2) != "length" ||
                text(name + 3) != "(" || text(name + 4) != ")")
                return std::nullopt;
            at = name + 5;
            return KnownVector{{true, 0, word}};
        }
        if (name + 1 >= end || text(name + 1) != "(" || match(name + 1) >= end) return std::nullopt;
        at = match(name + 1) + 1;
        const Range arguments{name + 2, at - 1};
        if (const std::size_t components = integerComponents(word); components > 0)
            return constructed(components, arguments, depth);
        if (word == "imageSize" || word == "textureSize") return size(word, arguments);
        return std::nullopt;
    }

    [[nodiscard]] static std::optional<KnownVector> swizzled(const KnownVector& of, std::string_view names) {
        KnownVector result;
        for (const char each : names) {
            constexpr std::string_view kNames = "xyzwrgbastpq";
            const std::size_t component = kNames.find(each);
            if (component == std::string_view::npos || component % 4 >= of.size()) return std::nullopt;
            result.push_back(of[component % 4]);
        }
        return result;
    }

    std::optional<KnownVector> local(std::string_view name, int depth) {
        const auto found = locals_.find(name);
        if (found == locals_.end() || !kept_.contains(name)) return std::nullopt;
        std::optional<KnownVector> known = value(found->second.second, depth + 1);
        return known && known->size() == found->second.first ? known : std::nullopt;
    }

    std::optional<KnownVector> constructed(std::size_t components, Range arguments, int depth) {
        KnownVector result;
        const std::vector<Range> parts = search_.parts(arguments, ",");
        for (const Range& each : parts) {
            const std::optional<KnownVector> part = value(each, depth + 1);
            if (!part) return std::nullopt;
            result.insert(result.end(), part->begin(), part->end());
        }
        if (parts.size() == 1 && result.size() == 1) result.resize(components, result.front());
        if (result.size() < components) return std::nullopt;
        result.resize(components);
        return result;
    }

    [[nodiscard]] std::optional<KnownVector> size(std::string_view function, Range arguments) const {
        const std::uint32_t length = arguments.end - arguments.first;
        const bool isImage = function == "imageSize";
        const std::string_view type = uniformType(arguments.first);
        const bool isBase = isImage ? length == 1 && isImageTypeWord(type)
                                    : length == 3 && text(arguments.first + 1) == "," &&
                                          text(arguments.first + 2) == "0" && type.find("sampler") < 2;
        const std::size_t axes = isBase ? axesOfTexels(type) : 0;
        if (axes == 0) return std::nullopt;
        KnownVector result;
        for (std::size_t i = 0; i < axes; ++i)
            result.push_back({true, static_cast<int>(i), text(arguments.first)});
        return result;
    }

    // ---- Conditions

    /// True if the numbers of invocations are compared with sizes along the same axes. The sizes are noted.
    bool comparesWithSizes(Range numbers, Range sizes) {
        const auto left = value(numbers, 0), right = value(sizes, 0);
        if (!left || !right || left->size() != right->size()) return false;
        for (std::size_t i = 0; i < left->size(); ++i)
            if ((*left)[i].isSize || !(*right)[i].isSize || (*left)[i].axis != (*right)[i].axis) return false;
        for (const KnownNumber& each : *right) sizes_.insert(each.object);
        return true;
    }

    /// True if `condition` has the value `wanted` for every invocation whose number is within the sizes.
    bool holdsWithin(Range condition, bool wanted, int depth) {
        condition = withoutBrackets(condition);
        if (condition.empty() || depth > kDeepest || !search_.spend(condition.end - condition.first))
            return false;
        // `a && b` holds if both do, and `a || b` does not if neither does.
        const std::vector<Range> parts = search_.parts(condition, wanted ? "&&" : "||");
        if (parts.size() > 1)
            return std::ranges::all_of(parts,
                                       [&](Range each) { return holdsWithin(each, wanted, depth + 1); });
        if (search_.parts(condition, wanted ? "||" : "&&").size() > 1) return false;
        if (text(condition.first) == "!") {
            const Range rest{condition.first + 1, condition.end};
            const bool isOne = isBracket(rest, "(", rest.first) || isBracket(rest, "(", rest.first + 1);
            return isOne && holdsWithin(rest, !wanted, depth + 1);
        }
        if (const auto vectors = inside(condition, wanted ? "all" : "any"))
            return comparesVectors(*vectors, wanted);
        return comparesScalars(condition, wanted);
    }
    bool comparesVectors(Range call, bool wanted) {
        call = withoutBrackets(call);
        if (const auto pair = inside(call, wanted ? "lessThan" : "greaterThanEqual"))
            if (const auto parts = search_.parts(*pair, ","); parts.size() == 2)
                return comparesWithSizes(parts[0], parts[1]);
        if (const auto pair = inside(call, wanted ? "greaterThan" : "lessThanEqual"))
            if (const auto parts = search_.parts(*pair, ","); parts.size() == 2)
                return comparesWithSizes(parts[1], parts[0]);
        return false;
    }
    bool comparesScalars(Range condition, bool wanted) {
        if (const auto sides = search_.parts(condition, wanted ? "<" : ">="); sides.size() == 2)
            return comparesWithSizes(sides[0], sides[1]);
        if (const auto sides = search_.parts(condition, wanted ? ">" : "<="); sides.size() == 2)
            return comparesWithSizes(sides[1], sides[0]);
        return false;
    }

    // ---- Statements

    /// Notes what the invocations within the sizes execute. False if they may not get beyond the range.
    bool walk(Range range, int depth) {
        if (depth > kDeepest) return false;
        for (std::uint32_t at = range.first; at < range.end;) {
            if (!search_.spend(1)) return false;
            const std::string_view word = text(at);
            std::uint32_t end = afterStatement(at, range.end, 0);
            if (end > range.end || end <= at) return false;
            if (word == "{") {
                if (!walk({at + 1, end - 1}, depth + 1)) return false;
            } else if (word == "if") {
                if (!walkIf(at, end, range.end, depth)) return false;
            } else if (isStatementWord(word)) {
                if (mayLeave({at, end})) return false;
            } else {
                note({at, end - 1});
            }
            at = end;
        }
        return true;
    }

    /// The same for an `if`. `end`: where its first statement ends; moves behind that of `else`.
    bool walkIf(std::uint32_t at, std::uint32_t& end, std::uint32_t last, int depth) {
        const Range condition{at + 2, match(at + 1)};
        const Range first{condition.end + 1, end};
        Range second{end, end};
        if (end < last && text(end) == "else") {
            second = {end + 1, afterStatement(end + 1, last, 1)};
            end = second.end;
            if (end > last) return false;
        }
        const std::set<std::string_view> before = sizes_;
        if (holdsWithin(condition, true, 0)) return walk(first, depth + 1);
        sizes_ = before;
        if (holdsWithin(condition, false, 0)) return walk(second, depth + 1);
        sizes_ = before;
        return !mayLeave(first) && !mayLeave(second);
    }

    /// The index behind the statement that begins at `at`; past the end if that is not clear. An `if` ends
    /// before its `else`.
    std::uint32_t afterStatement(std::uint32_t at, std::uint32_t end, int depth) {
        const std::uint32_t nowhere = end + 1;
        if (depth > kDeepest || at >= end || !search_.spend(1)) return nowhere;
        const std::string_view word = text(at);
        if (word == "{") return match(at) < end ? match(at) + 1 : nowhere;
        if (word == "if" || word == "for" || word == "while" || word == "switch") {
            if (text(at + 1) != "(" || match(at + 1) >= end) return nowhere;
            const std::uint32_t body = match(at + 1) + 1;
            const std::uint32_t behind = afterStatement(body, end, depth + 1);
            // The inner `if` takes the `else`.
            if (word == "if" && depth > 0 && behind < end && text(behind) == "else")
                return afterStatement(behind + 1, end, depth + 1);
            return behind;
        }
        if (word == "do") {
            const std::uint32_t behind = afterStatement(at + 1, end, depth + 1);
            const bool isWhole = behind < end && text(behind) == "while" && text(behind + 1) == "(" &&
                                 match(behind + 1) + 1 < end && text(match(behind + 1) + 1) == ";";
            return isWhole ? match(behind + 1) + 2 : nowhere;
        }
        if (word == "else" || word == "case" || word == "default") return nowhere;
        for (; at < end; ++at) {
            if (text(at) == ";") return at + 1;
            if (text(at) == "}" || !search_.spend(1)) return nowhere;
            if (search_.opens(at)) at = match(at);
        }
        return nowhere;
    }

    bool mayLeave(Range range) {
        return !search_.spend(range.end - range.first) || unit_.hasAny(range, {"return", "discard"});
    }

    /// A declaration, or an expression, without its ';'.
    void note(Range statement) {
        std::uint32_t at = statement.first;
        while (text(at) == "const" || text(at) == "lowp" || text(at) == "mediump" || text(at) == "highp")
            ++at;
        if (integerComponents(text(at)) > 0 && at + 1 < statement.end && search_.isWord(at + 1))
            return noteDeclaration(statement);
        if (text(statement.first) == "imageStore") return noteStore(statement);
        noteElement(statement);
    }
    void noteDeclaration(Range statement) {
        const Declaration declared = parseVariable(unit_.view, statement.first, statement.end + 1);
        const std::size_t components = integerComponents(declared.type.name);
        if (components == 0 || !declared.type.dimensions.empty()) return;
        for (const Declarator& each : declared.declarators)
            if (each.dimensions.empty() && !each.initializer.empty())
                locals_.emplace(text(each.name), std::pair(components, each.initializer));
    }
    void noteStore(Range statement) {
        const auto call = inside(statement, "imageStore");
        if (!call) return;
        const std::vector<Range> arguments = search_.parts(*call, ",");
        if (arguments.size() != 3 || arguments[0].end != arguments[0].first + 1) return;
        const std::string_view type = uniformType(arguments[0].first);
        if (isImageTypeWord(type) && isOwnNumber(arguments[1], axesOfTexels(type)))
            noteStored(arguments[0].first, axesOfTexels(type));
    }
    void noteElement(Range statement) {
        const std::uint32_t name = statement.first;
        if (role(name) != WordRole::global || !arrays_.contains(text(name)) || text(name + 1) != "[") return;
        const std::uint32_t close = match(name + 1);
        if (close < statement.end && text(close + 1) == "=" && isOwnNumber({name + 2, close}, 1))
            noteStored(name, 1);
    }
    void noteStored(std::uint32_t name, std::size_t axes) {
        stores_.try_emplace(std::string(text(name)), static_cast<int>(axes), sizes_);
    }
    bool isOwnNumber(Range place, std::size_t axes) {
        const std::optional<KnownVector> known = value(place, 0);
        if (!known || axes == 0 || known->size() != axes) return false;
        for (std::size_t i = 0; i < axes; ++i)
            if ((*known)[i].isSize || (*known)[i].axis != static_cast<int>(i)) return false;
        return true;
    }

    const Unit& unit_;
    TokenSearch search_;
    std::set<std::string_view> kept_;
    std::map<std::string_view, std::string, std::less<>> arrays_;  ///< by the array: the name of its block
    /// By name: the components and the initialiser.
    std::map<std::string_view, std::pair<std::size_t, Range>> locals_;
    std::set<std::string_view> sizes_;  ///< of what the invocations that go on lie in
    /// With the axes of the place, and the sizes then.
    std::map<std::string, std::pair<int, std::set<std::string_view>>, std::less<>> stores_;
};

}  // namespace

std::vector<WholeWrite> wholeWritesOf(const Unit& unit) {
    if (unit.stage != Stage::compute) return {};
    return WholeWriteSearch(unit).find();
}

}  // namespace glibra::glsl
