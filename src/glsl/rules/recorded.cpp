// The checks of --check-undefined (language, 7.13): subscripts, fetches, vertices and divisors whose effect
// GLSL leaves open are counted where they happen, and the first one is recorded. The functions return what
// they are given, except that subscripts are limited to the array, since some drivers would stop.

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glsl/facts/facts.h"
#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"
#include "glsl/read/words.h"
#include "glsl/rules/rules.h"
#include "glsl/types/builtins.h"

namespace glibra::glsl {
namespace {

constexpr std::size_t kMostSites = 4096;  // of a program
constexpr std::size_t kLongestText = 60;

/// The coordinates of a texture or image by its type word.
struct TexelSpace {
    int dimensions = 0;
    bool hasLevels = false;
    bool isCube = false;  ///< of an image, whose size lacks the six faces
};
TexelSpace spaceOf(std::string_view word) {
    const std::size_t at = std::min(word.find("sampler"), word.find("image"));
    if (at == std::string_view::npos) return {};
    const std::string_view rest = word.substr(at + (word.substr(at).starts_with("sampler") ? 7 : 5));
    const bool isMultisampled = rest.find("MS") != std::string_view::npos;
    const bool isArray = rest.ends_with("Array") || rest.ends_with("ArrayShadow");
    if (rest.starts_with("Buffer")) return {1, false, false};
    if (rest.starts_with("Cube")) return {3, false, true};
    if (rest.starts_with("2DRect")) return {2, false, false};
    const int plain = rest.starts_with('1') ? 1 : rest.starts_with('2') ? 2 : rest.starts_with('3') ? 3 : 0;
    return {plain == 0 ? 0 : plain + (isArray ? 1 : 0), !isMultisampled, false};
}

class UndefinedChecks {
  public:
    UndefinedChecks(Unit& unit, std::vector<UndefinedSite>& sites) : unit_(unit), sites_(sites) {}

    void run() {
        // All texts are read before the first edit.
        for (const Subscript& each : unit_.bodies.subscripts) subscript(each);
        for (const Call& each : unit_.bodies.calls) call(each);
        divisors();
        // Smaller ranges first, so that brackets nest.
        std::ranges::stable_sort(
            changes_, [](const Change& a, const Change& b) { return a.last - a.first < b.last - b.first; });
        for (const Change& each : changes_) {
            if (each.isInside) {
                unit_.edits.after(each.first, each.before);
                unit_.edits.before(each.last, each.after);
            } else if (each.isOperand) {
                unit_.edits.rightBefore(each.first, each.before);
                unit_.edits.rightAfter(each.last, each.after);
            } else {
                unit_.edits.before(each.first, each.before);
                unit_.edits.after(each.last, each.after);
            }
        }
        declare();
    }

  private:
    using Kind = UndefinedSite::Kind;
    struct Change {
        std::uint32_t first, last;  ///< tokens
        std::string before, after;
        bool isInside = false;   ///< `before` comes after the first token, and `after` before the last one
        bool isOperand = false;  ///< a divisor, which is smaller than all else that ends with it
    };

    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] std::uint32_t match(std::uint32_t at) const { return unit_.bodies.matches[at]; }

    [[nodiscard]] bool isInFunction(std::uint32_t at) const {
        return std::ranges::any_of(unit_.syntax.declarations, [&](const Declaration& each) {
            return each.kind == DeclarationKind::function && each.body.contains(at);
        });
    }

    /// The number of a new site as text; nothing if there are too many.
    std::optional<std::string> site(Kind kind, Range range, std::uint32_t place) {
        if (sites_.size() == kMostSites) return std::nullopt;
        std::string shown = textOf(unit_, range);
        if (shown.size() > kLongestText) shown = shown.substr(0, kLongestText - 3) + "...";
        sites_.push_back({kind, std::move(shown), unit_.place(place)});
        return std::to_string(sites_.size() - 1);
    }

    /// The range as it is emitted.
    [[nodiscard]] std::string emitted(Range range) const {
        std::string result;
        for (std::uint32_t i = range.first; i < range.end; ++i) {
            const Edit* edit = unit_.edits.find(unit_.view[i].raw);
            if (!result.empty()) result += ' ';
            if (edit == nullptr) {
                result += text(i);
                continue;
            }
            result += edit->before;
            result += edit->replaced ? std::string_view(edit->text) : text(i);
            result += edit->after;
        }
        return result;
    }

    /// True if all names in the range are constants.
    [[nodiscard]] bool isConstant(Range range) const {
        for (std::uint32_t i = range.first; i < range.end; ++i) {
            const WordRole role = unit_.bodies.roles[i];
            if (role != WordRole::local && role != WordRole::global) continue;
            if (role == WordRole::local ? !constantLocals().contains(text(i)) : !isConstantName(text(i)))
                return false;
        }
        return true;
    }
    [[nodiscard]] const std::set<std::string_view>& constantLocals() const {
        if (!hasLocals_) {
            std::set<std::string_view> others;
            for (const LocalVariable& each : unit_.bodies.locals)
                (each.constToken == kNone ? others : constants_).insert(text(each.name));
            for (const std::string_view each : others) constants_.erase(each);
            hasLocals_ = true;
        }
        return constants_;
    }
    [[nodiscard]] bool isConstantName(std::string_view name) const {
        const Variable* variable = unit_.variable(name);
        if (variable != nullptr) return variable->storage == Storage::constant;
        if (findBuiltinUniform(name) != nullptr) return false;
        return name.starts_with("gl_Max") || (!unit_.isDeclared(name) && !name.starts_with("gl_"));
    }

    void wrap(Range range, const std::string& function, const std::string& rest, bool isOperand = false) {
        changes_.push_back({unit_.view[range.first].raw, unit_.view[range.end - 1].raw, function + "(",
                            ", " + rest + ")", false, isOperand});
    }

    // ---- Subscripts

    /// True for the vertex of the invocation in an array that a control stage writes or reads for each
    /// vertex. The invocation's outputs may be indexed by this name alone, and it lies inside.
    [[nodiscard]] bool isOwnVertex(std::uint32_t object, Range index) const {
        if (unit_.stage != Stage::tessControl || index.end != index.first + 1 ||
            text(index.first) != "gl_InvocationID" || unit_.bodies.roles[object] == WordRole::local)
            return false;
        const Variable* variable = unit_.variable(text(object));
        return variable == nullptr || (variable->storage == Storage::output && !variable->patch);
    }

    void subscript(const Subscript& each) {
        const std::uint32_t close = match(each.open);
        if (close >= unit_.view.size() || !isInFunction(each.open)) return;
        const Range index{each.open + 1, close};
        if (index.empty() || isConstant(index)) return;
        if (isOwnVertex(each.object.first, index)) return;
        std::string length;
        if (each.type.arrayDepth > 0) {
            if (!isIdle(unit_, each.object)) return;
            length = emitted(each.object) + ".length()";
        } else if (each.type.vector()) {
            length = std::to_string(each.type.rows);
        } else if (each.type.matrix()) {
            length = std::to_string(each.type.columns);
        } else {
            return;
        }
        const auto number = site(Kind::subscript, {each.object.first, close + 1}, each.open);
        if (!number) return;
        changes_.push_back({unit_.view[each.open].raw, unit_.view[close].raw, "glibra_element(",
                            ", " + length + ", " + *number + ")", true, false});
        usesElements_ = true;
    }

    // ---- Fetches and vertices

    void call(const Call& each) {
        const std::string_view name = text(each.name);
        const bool isUsers = unit_.isDeclared(name);
        if (isUsers || !isInFunction(each.name)) return;
        if (name == "EmitVertex") return vertex(each);
        if (name.starts_with("texelFetch")) return fetch(each, name.find("Offset") != std::string_view::npos);
        if (name.starts_with("imageLoad") || name.starts_with("imageStore") ||
            name.starts_with("imageAtomic"))
            return image(each);
        if (name == "mod" && each.arguments.size() == 2 && isUniform(each.arguments[1]))
            divisor(each.arguments[1], false);
    }

    void vertex(const Call& each) {
        if (unit_.mostVertices <= 0 || text(each.name + 1) != "(") return;
        const auto number = site(Kind::vertices, {each.name, each.name + 3}, each.name);
        if (!number) return;
        if (emitVertex_.empty()) emitVertex_ = emitted({each.name, each.name + 1});
        unit_.edits.replace(unit_.view[each.name].raw, "glibra_vertex");
        unit_.edits.after(unit_.view[each.name + 1].raw, *number);
    }

    [[nodiscard]] Range whole(const Call& each) const { return {each.name, match(each.name + 1) + 1}; }

    void texel(const Call& each, const std::string& size, const std::string& offset) {
        const auto number = site(Kind::texel, whole(each), each.name);
        if (!number) return;
        wrap(each.arguments[1], "glibra_texel", size + ", " + offset + *number);
        usesTexels_ = true;
    }

    void fetch(const Call& each, bool hasOffset) {
        if (each.arguments.size() < 2 || !isIdle(unit_, each.arguments[0])) return;
        const TexelSpace space = spaceOf(each.types[0].word);
        if (space.dimensions == 0) return;
        const std::string map = emitted(each.arguments[0]);
        const bool hasLevel = space.hasLevels && each.arguments.size() >= 3;
        if (hasLevel && !isIdle(unit_, each.arguments[2])) return;
        std::string offset;
        if (hasOffset) offset = emitted(each.arguments.back()) + ", ";
        const bool mayMissLevel = hasLevel && !isConstantZero(each.arguments[2]);
        std::string level = hasLevel ? emitted(each.arguments[2]) : "";
        if (mayMissLevel) level = "clamp(" + level + ", 0, textureQueryLevels(" + map + ") - 1)";
        texel(each, "textureSize(" + map + (hasLevel ? ", " + level : "") + ")", offset);
        if (!mayMissLevel) return;
        if (const auto number = site(Kind::level, whole(each), each.name)) {
            wrap(each.arguments[2], "glibra_element", "textureQueryLevels(" + map + "), " + *number);
            usesElements_ = true;
        }
    }
    [[nodiscard]] bool isConstantZero(Range range) const {
        return range.end == range.first + 1 && text(range.first) == "0";
    }

    void image(const Call& each) {
        if (each.arguments.size() < 2 || !isIdle(unit_, each.arguments[0])) return;
        const TexelSpace space = spaceOf(each.types[0].word);
        if (space.dimensions == 0) return;
        std::string size = "imageSize(" + emitted(each.arguments[0]) + ")";
        if (space.isCube)
            size =
                each.types[0].word.ends_with("Array") ? size + " * ivec3(1, 1, 6)" : "ivec3(" + size + ", 6)";
        texel(each, size, "");
    }

    // ---- Divisors

    /// True for an expression of uniforms and constants, with a uniform.
    [[nodiscard]] bool isUniform(Range range) const {
        bool any = false;
        for (std::uint32_t i = range.first; i < range.end; ++i) {
            const WordRole role = unit_.bodies.roles[i];
            if (role == WordRole::local && !constantLocals().contains(text(i))) return false;
            if (role != WordRole::global || isConstantName(text(i))) {
                const bool isCall = text(i + 1) == "(" && unit_.view[i].kind == TokenKind::word;
                if (isCall && unit_.isDeclared(text(i))) return false;
                continue;
            }
            const Variable* variable = unit_.variable(text(i));
            const bool isOfUniform = variable != nullptr
                                         ? variable->storage == Storage::uniform
                                         : isUniformMember(text(i)) || findBuiltinUniform(text(i)) != nullptr;
            if (!isOfUniform) return false;
            any = true;
        }
        return any;
    }
    /// A member of a uniform block, or the block.
    [[nodiscard]] bool isUniformMember(std::string_view name) const {
        const auto declared = unit_.declared.find(name);
        if (declared == unit_.declared.end()) return false;
        return std::ranges::any_of(unit_.syntax.declarations, [&](const Declaration& each) {
            return each.kind == DeclarationKind::block && each.qualifiers.storage == Storage::uniform &&
                   each.tokens.contains(declared->second);
        });
    }

    void divisors() {
        for (const std::string_view each : {"dmat2", "dmat3", "dmat4"})
            if (unit_.isUsed(each)) return;
        std::map<std::uint32_t, std::uint32_t> found;  // by the operator: the node of the divisor
        for (const Node& each : unit_.bodies.nodes)
            if (each.kind == NodeKind::assignment && listed(" /= %= ", text(each.token)))
                found.emplace(each.token, each.lastChild);
            else if (each.kind == NodeKind::chain)
                for (std::uint32_t one = unit_.bodies.nodes[each.child].next; one != kNone;
                     one = unit_.bodies.nodes[one].next)
                    if (listed(" / % ", text(unit_.bodies.nodes[one].first - 1)))
                        found.emplace(unit_.bodies.nodes[one].first - 1, one);
        for (const auto& [op, node] : found) {
            const Range range = unit_.bodies.nodes[node].range();
            if (!range.empty() && isInFunction(op) && !isConstant(range))
                divisor(range, text(op).size() == 1);
        }
    }

    void divisor(Range range, bool isOperand) {
        const auto number = site(Kind::divisor, range, range.first);
        if (!number) return;
        // Float divisors that differ from pixel to pixel may be 0: the quotient is infinite then.
        wrap(range, isUniform(range) ? "glibra_divisor" : "glibra_wholeDivisor", *number, isOperand);
        usesDivisors_ = true;
    }

    // ---- Functions

    void declare() {
        if (!usesElements_ && !usesTexels_ && !usesDivisors_ && emitVertex_.empty()) return;
        const auto add = [&](const std::string& line) { unit_.declare(line); };
        add("layout(std430) buffer glibra_Undefined { int glibra_undefined[]; };");
        add("void glibra_note(int site, int value, int limit) { if (atomicAdd(glibra_undefined[3 * site], 1) "
            "== 0) { glibra_undefined[3 * site + 1] = value; glibra_undefined[3 * site + 2] = limit; } }");
        if (usesElements_) {
            add("int glibra_element(int i, int n, int site) { if (i < 0 || i >= n) glibra_note(site, i, n); "
                "return clamp(i, 0, max(n - 1, 0)); }");
            add("uint glibra_element(uint i, int n, int site) { return uint(glibra_element(int(min(i, "
                "0x7fffffffu)), n, site)); }");
        }
        if (usesTexels_) texelFunctions();
        if (usesDivisors_) divisorFunctions();
        if (emitVertex_.empty()) return;
        add("int glibra_vertices = 0;");
        const std::string most = std::to_string(unit_.mostVertices);
        add("void glibra_vertex(int site) { if (++glibra_vertices > " + most +
            ") glibra_note(site, glibra_vertices, " + most + "); " + emitVertex_ + "(); }");
    }

    void texelFunctions() {
        unit_.declare(
            "int glibra_texel(int p, int n, int o, int site) { if (p + o < 0 || p + o >= n) "
            "glibra_note(site, p + o, n); return p; }");
        unit_.declare("int glibra_texel(int p, int n, int site) { return glibra_texel(p, n, 0, site); }");
        for (int size = 2; size <= 3; ++size) {
            const std::string type = "ivec" + std::to_string(size);
            unit_.declare(type + " glibra_texel(" + type + " p, " + type + " n, " + type +
                          " o, int site) { for (int i = 0; i < " + std::to_string(size) +
                          "; ++i) if (p[i] + o[i] < 0 || p[i] + o[i] >= n[i]) { glibra_note(site, p[i] + "
                          "o[i], n[i]); break; } return p; }");
            unit_.declare(type + " glibra_texel(" + type + " p, " + type +
                          " n, int site) { return glibra_texel(p, n, " + type + "(0), site); }");
        }
    }

    void divisorFunctions() {
        const auto add = [&](const std::string& function, const std::string& type, const std::string& test) {
            unit_.declare(type + " " + function + "(" + type + " x, int site) { " +
                          (test.empty() ? "" : "if (" + test + ") glibra_note(site, 0, 0); ") +
                          "return x; }");
        };
        for (const std::string function : {"glibra_divisor", "glibra_wholeDivisor"}) {
            const bool isWhole = function == "glibra_wholeDivisor";
            for (const std::string prefix : {"", "d", "i", "u"}) {
                const bool isFloat = prefix.empty() || prefix == "d";
                const std::string scalar = prefix.empty()  ? "float"
                                           : prefix == "d" ? "double"
                                           : prefix == "i" ? "int"
                                                           : "uint";
                const bool isTested = !isFloat || !isWhole;
                add(function, scalar, isTested ? "x == " + scalar + "(0)" : "");
                for (const char size : {'2', '3', '4'}) {
                    const std::string type = prefix + "vec" + size;
                    add(function, type, isTested ? "any(equal(x, " + type + "(0)))" : "");
                }
            }
            for (const char columns : {'2', '3', '4'})
                for (const char rows : {'2', '3', '4'})
                    add(function, std::string("mat") + columns + "x" + rows, "");
        }
    }

    Unit& unit_;
    std::vector<UndefinedSite>& sites_;
    std::vector<Change> changes_;
    std::string emitVertex_;  ///< the function as the stage calls it; empty: it does not
    bool usesElements_ = false, usesTexels_ = false, usesDivisors_ = false;
    mutable std::set<std::string_view> constants_;
    mutable bool hasLocals_ = false;
};

}  // namespace

void recordUndefined(Unit& unit, std::vector<UndefinedSite>& sites) {
    if (unit.request->target.version >= 430) UndefinedChecks(unit, sites).run();
}

// Loops note that the driver has ended them (ProgramRequest::recordsLoops). A shader cannot see it in the
// values of its variables: after a loop the compiler takes the condition for false. So the condition also
// goes into an array whose subscript the compiler does not know.

namespace {

/// Adds the places of the loops that compilers unroll. Their rounds do not count.
void addUnrolled(const std::vector<CountedLoop>& loops, std::vector<Place>& to) {
    for (const CountedLoop& each : loops) {
        if (isUnrolled(each)) to.push_back(each.place);
        addUnrolled(each.inside, to);
    }
}

class LoopRecorder {
  public:
    LoopRecorder(Unit& unit, std::vector<Place>& sites) : unit_(unit), sites_(sites) {
        addUnrolled(loopsOf(unit).loops, unrolled_);
    }

    /// False: the stage has no loop.
    bool run() {
        const std::size_t before = sites_.size();
        for (const Declaration& each : unit_.syntax.declarations)
            if (each.kind == DeclarationKind::function && each.code != kNone) visit(each.code);
        return sites_.size() > before;
    }

  private:
    [[nodiscard]] std::string_view text(std::uint32_t at) const { return unit_.text(at); }
    [[nodiscard]] std::uint32_t match(std::uint32_t at) const { return unit_.bodies.matches[at]; }
    [[nodiscard]] std::uint32_t raw(std::uint32_t at) const { return unit_.view[at].raw; }

    [[nodiscard]] const Node& node(std::uint32_t id) const { return unit_.bodies.nodes[id]; }
    [[nodiscard]] bool isLoop(std::uint32_t id) const {
        const NodeKind kind = node(id).kind;
        return kind == NodeKind::forLoop || kind == NodeKind::whileLoop || kind == NodeKind::doLoop;
    }

    void visit(std::uint32_t id) {
        for (const std::uint32_t each : unit_.bodies.children(id)) visit(each);  // inner brackets come first
        if (isLoop(id)) record(id);
    }

    void record(std::uint32_t id) {
        const Node& loop = node(id);
        const Place place = unit_.place(loop.first);
        const bool isDo = loop.kind == NodeKind::doLoop;
        const std::uint32_t body = isDo ? loop.child : loop.lastChild;
        const std::uint32_t open = isDo ? node(body).end + 1 : loop.first + 1;
        if (text(open) != "(" || match(open) >= loop.end ||
            std::ranges::find(unrolled_, place) != unrolled_.end())
            return;
        const std::string site = std::to_string(sites_.size());
        const std::string inLoop = "glibra_inLoop[" + site + " + glibra_NoLoop]";
        sites_.push_back(place);
        markBreaks(body, inLoop);
        markCondition(conditionOf(unit_, loop, {open, match(open) + 1}), site);
        unit_.edits.before(raw(loop.first), "{ ");
        unit_.edits.after(raw(loop.end - 1),
                          " if (" + inLoop + " != 0) glibra_cutLoops[" + site + "] = 1; }");
    }

    void markCondition(Range condition, const std::string& site) {
        const std::uint32_t before = beforeValue(unit_, condition);
        const bool isEmpty = condition.end - condition.first <= 2;
        unit_.edits.after(raw(before), isEmpty ? " glibra_goes((true" : " glibra_goes((");
        unit_.edits.before(raw(condition.end - 1), "), " + site + ")");
    }

    void markBreaks(std::uint32_t id, const std::string& inLoop) {
        const Node& it = node(id);
        if (isLoop(id) || it.kind == NodeKind::choice) return;
        for (const std::uint32_t each : unit_.bodies.children(id)) markBreaks(each, inLoop);
        if (it.kind != NodeKind::jump || text(it.first) != "break" || text(it.first + 1) != ";") return;
        unit_.edits.before(raw(it.first), "{ " + inLoop + " = 0; ");
        unit_.edits.after(raw(it.first + 1), " }");
    }

    Unit& unit_;
    std::vector<Place>& sites_;
    std::vector<Place> unrolled_;
};

}  // namespace

void recordCutLoops(ProgramUnits& program) {
    if (!program.request->recordsLoops || program.request->target.version < 430) return;
    std::vector<Place>& sites = program.result->loopSites;
    std::vector<Unit*> recorded;
    for (Unit& unit : program.units)
        if (LoopRecorder(unit, sites).run()) recorded.push_back(&unit);
    for (Unit* unit : recorded) {
        unit->declare("layout(std430) buffer glibra_CutLoops { int glibra_cutLoops[]; };");
        unit->declare("uniform int glibra_NoLoop;");  // it is 0
        unit->declare("int glibra_inLoop[" + std::to_string(sites.size()) + "];");
        unit->declare(
            "bool glibra_goes(bool on, int site) { glibra_inLoop[site + glibra_NoLoop] = int(on); return on; "
            "}");
        const bool isQuiet =
            std::ranges::none_of(program.units, [](const Unit& each) { return writesMemory(each); });
        // Hidden fragments stay out, as they do where nothing is recorded.
        if (unit->stage == Stage::fragment && isQuiet && !unit->isUsed("gl_FragDepth"))
            unit->declare("layout(early_fragment_tests) in;");
    }
}

}  // namespace glibra::glsl
