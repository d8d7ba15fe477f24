// Finds the images and storage blocks that a compute stage writes whole: each invocation stores the texel, or
// the element, of its own number, under no condition except that the number is within a size.

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <string_view>

#include "glsl/facts/facts.h"
#include "glsl/facts/formula.h"
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
        if (const std::uint32_t code = unit_.function("main")->code; code != kNone) walk(code, 0);
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
    [[nodiscard]] std::uint32_t match(std::uint32_t at) const { return unit_.bodies.matches[at]; }
    [[nodiscard]] WordRole role(std::uint32_t at) const { return unit_.bodies.roles[at]; }
    [[nodiscard]] const Node& node(std::uint32_t id) const { return unit_.bodies.nodes[id]; }
    [[nodiscard]] Bodies::Children children(std::uint32_t id) const { return unit_.bodies.children(id); }
    [[nodiscard]] std::uint32_t withoutBrackets(std::uint32_t id) const {
        while (node(id).kind == NodeKind::group) id = node(id).child;
        return id;
    }
    /// True for a call of the function with so many arguments.
    [[nodiscard]] bool isCall(std::uint32_t id, std::string_view function, int arguments) const {
        return node(id).kind == NodeKind::call && text(node(id).token) == function &&
               unit_.bodies.childCount(id) == arguments;
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
    [[nodiscard]] std::optional<KnownVector> value(std::uint32_t id, int depth) {
        if (depth > kDeepest || !search_.spend(1)) return std::nullopt;
        const Node& it = node(id);
        const std::string_view word = text(it.token);
        if (it.kind == NodeKind::group) return value(it.child, depth + 1);
        if (it.kind == NodeKind::member) {
            const std::optional<KnownVector> object = value(it.child, depth);
            return object ? swizzled(*object, word) : std::nullopt;
        }
        if (it.kind == NodeKind::name) {
            if (role(it.token) == WordRole::local) return local(word, depth);
            if (word != "gl_GlobalInvocationID" || role(it.token) != WordRole::global) return std::nullopt;
            return KnownVector{{false, 0}, {false, 1}, {false, 2}};
        }
        if (it.kind == NodeKind::method) {
            const Node& array = node(it.child);
            const bool isLength = array.kind == NodeKind::name && arrays_.contains(text(array.token)) &&
                                  role(array.token) == WordRole::global && word == "length" &&
                                  it.end == it.token + 3;
            return isLength ? std::optional(KnownVector{{true, 0, text(array.token)}}) : std::nullopt;
        }
        if (it.kind != NodeKind::call) return std::nullopt;
        if (const std::size_t components = integerComponents(word); components > 0)
            return constructed(components, id, depth);
        return word == "imageSize" || word == "textureSize" ? size(it) : std::nullopt;
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

    std::optional<KnownVector> constructed(std::size_t components, std::uint32_t call, int depth) {
        KnownVector result;
        for (const std::uint32_t each : children(call)) {
            const std::optional<KnownVector> part = value(each, depth + 1);
            if (!part) return std::nullopt;
            result.insert(result.end(), part->begin(), part->end());
        }
        if (unit_.bodies.childCount(call) == 1 && result.size() == 1)
            result.resize(components, result.front());
        if (result.size() < components) return std::nullopt;
        result.resize(components);
        return result;
    }

    [[nodiscard]] std::optional<KnownVector> size(const Node& call) const {
        if (call.child == kNone) return std::nullopt;
        const Node& object = node(call.child);
        const std::string_view type = uniformType(object.first);
        const bool isBase = text(call.token) == "imageSize"
                                ? object.next == kNone && isImageTypeWord(type)
                                : object.next != kNone && node(object.next).next == kNone &&
                                      node(object.next).end == node(object.next).first + 1 &&
                                      text(node(object.next).token) == "0" && type.find("sampler") < 2;
        const std::size_t axes = isBase && object.kind == NodeKind::name ? axesOfTexels(type) : 0;
        if (axes == 0) return std::nullopt;
        KnownVector result;
        for (std::size_t i = 0; i < axes; ++i)
            result.push_back({true, static_cast<int>(i), text(object.first)});
        return result;
    }

    // ---- Conditions

    /// True if the numbers of invocations are compared with sizes along the same axes. The sizes are noted.
    bool comparesWithSizes(std::uint32_t numbers, std::uint32_t sizes) {
        const auto left = value(numbers, 0), right = value(sizes, 0);
        if (!left || !right || left->size() != right->size()) return false;
        for (std::size_t i = 0; i < left->size(); ++i)
            if ((*left)[i].isSize || !(*right)[i].isSize || (*left)[i].axis != (*right)[i].axis) return false;
        for (const KnownNumber& each : *right) sizes_.insert(each.object);
        return true;
    }

    /// True if `condition` has the value `wanted` for every invocation whose number is within the sizes.
    bool holdsWithin(std::uint32_t condition, bool wanted, int depth) {
        condition = withoutBrackets(condition);
        if (depth > kDeepest || !search_.spend(1)) return false;
        const Node& it = node(condition);
        const std::string_view sign = text(it.token);
        if (it.kind == NodeKind::chain) {
            // `a && b` holds if both do, and `a || b` does not if neither does.
            if (sign != (wanted ? "&&" : "||")) return comparesScalars(it, wanted);
            for (const std::uint32_t each : children(condition))
                if (!holdsWithin(each, wanted, depth + 1)) return false;
            return true;
        }
        if (it.kind == NodeKind::prefix)
            return sign == "!" && node(it.child).first == it.first + 1 &&
                   holdsWithin(it.child, !wanted, depth + 1);
        return isCall(condition, wanted ? "all" : "any", 1) && comparesVectors(it.child, wanted);
    }
    bool comparesVectors(std::uint32_t call, bool wanted) {
        call = withoutBrackets(call);
        const std::uint32_t first = node(call).child, second = node(call).lastChild;
        if (isCall(call, wanted ? "lessThan" : "greaterThanEqual", 2))
            return comparesWithSizes(first, second);
        return isCall(call, wanted ? "greaterThan" : "lessThanEqual", 2) && comparesWithSizes(second, first);
    }
    bool comparesScalars(const Node& chain, bool wanted) {
        const std::string_view sign = text(chain.token);
        if (node(chain.child).next != chain.lastChild) return false;
        if (sign == (wanted ? "<" : ">=")) return comparesWithSizes(chain.child, chain.lastChild);
        return sign == (wanted ? ">" : "<=") && comparesWithSizes(chain.lastChild, chain.child);
    }

    // ---- Statements

    /// Notes what the invocations within the sizes execute. False if they may not get beyond the statement.
    bool walk(std::uint32_t id, int depth) {
        const Node& it = node(id);
        if (depth > kDeepest || !search_.spend(1)) return false;
        if (it.kind == NodeKind::block) {
            for (const std::uint32_t each : children(id))
                if (!walk(each, depth + 1)) return false;
            return true;
        }
        if (it.kind == NodeKind::branch) return walkIf(id, depth);
        if (it.kind == NodeKind::declaration) noteDeclaration(id);
        if (it.kind == NodeKind::evaluation && isCall(it.child, "imageStore", 3)) noteStore(node(it.child));
        if (it.kind == NodeKind::evaluation && node(it.child).kind == NodeKind::assignment)
            noteElement(node(it.child));
        return it.kind == NodeKind::declaration || it.kind == NodeKind::evaluation || !mayLeave(it.range());
    }

    bool walkIf(std::uint32_t id, int depth) {
        const std::uint32_t condition = node(id).child, first = node(condition).next,
                            second = node(first).next;
        const std::set<std::string_view> before = sizes_;
        if (holdsWithin(condition, true, 0)) return walk(first, depth + 1);
        sizes_ = before;
        if (holdsWithin(condition, false, 0)) return second == kNone || walk(second, depth + 1);
        sizes_ = before;
        return !mayLeave(node(first).range()) && (second == kNone || !mayLeave(node(second).range()));
    }

    bool mayLeave(Range range) {
        return !search_.spend(range.end - range.first) || unit_.hasAny(range, {"return", "discard"});
    }

    void noteDeclaration(std::uint32_t id) {
        const Declaration& declared = unit_.bodies.declarations[node(id).token];
        const std::size_t components = integerComponents(declared.type.name);
        if (components == 0 || !declared.type.dimensions.empty()) return;
        for (const Declarator& each : declared.declarators)
            if (each.dimensions.empty() && each.value != kNone)
                locals_.emplace(text(each.name), std::pair(components, each.value));
    }
    void noteStore(const Node& call) {
        const Node& object = node(call.child);
        const std::string_view type = object.kind == NodeKind::name ? uniformType(object.token) : "";
        if (isImageTypeWord(type) && isOwnNumber(object.next, axesOfTexels(type)))
            noteStored(object.token, axesOfTexels(type));
    }
    void noteElement(const Node& assignment) {
        const Node& element = node(assignment.child);
        const std::uint32_t name = element.first;
        if (element.kind == NodeKind::subscript && node(element.child).kind == NodeKind::name &&
            role(name) == WordRole::global && arrays_.contains(text(name)) && text(assignment.token) == "=" &&
            isOwnNumber(element.lastChild, 1))
            noteStored(name, 1);
    }
    void noteStored(std::uint32_t name, std::size_t axes) {
        stores_.try_emplace(std::string(text(name)), static_cast<int>(axes), sizes_);
    }
    bool isOwnNumber(std::uint32_t place, std::size_t axes) {
        const std::optional<KnownVector> known = value(place, 0);
        if (!known || axes == 0 || known->size() != axes) return false;
        for (std::size_t i = 0; i < axes; ++i)
            if ((*known)[i].isSize || (*known)[i].axis != static_cast<int>(i)) return false;
        return true;
    }

    const Unit& unit_;
    FormulaSearch search_;
    std::set<std::string_view> kept_;
    std::map<std::string_view, std::string, std::less<>> arrays_;  ///< by the array: the name of its block
    /// By name: the components and the node of the initialiser.
    std::map<std::string_view, std::pair<std::size_t, std::uint32_t>> locals_;
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
