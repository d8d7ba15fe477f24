// gl_FrontColor and its kin, which core GLSL lacks, become one block of varyings between two stages
// (language, 7.6). A stage writes to variables of its own, which are copied into the block when the vertex
// leaves the stage. The last stage before rasterisation clamps colours.

#include <algorithm>
#include <array>

#include "glsl/parse/usage.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

// The built-in varyings that core GLSL lacks (language, 7.6), one row each.

namespace varyings {

enum Varying : std::size_t {
    frontColor,
    backColor,
    frontSecondary,
    backSecondary,
    texCoord,
    fog,
    kVaryingCount
};

constexpr std::array<Varying, kVaryingCount> kVaryings{frontColor,    backColor, frontSecondary,
                                                       backSecondary, texCoord,  fog};

struct Row {
    std::string_view name;  ///< without gl_
    std::string_view type;
    std::string_view unwritten;  ///< the value that a reader gets if no stage writes it
    bool color;
};
constexpr std::array<Row, kVaryingCount> kRows = {
    {{"FrontColor", "vec4", "glibra_CurrentColor", true},
     {"BackColor", "vec4", "glibra_CurrentColor", true},
     {"FrontSecondaryColor", "vec4", "vec4(0., 0., 0., 1.)", true},
     {"BackSecondaryColor", "vec4", "vec4(0., 0., 0., 1.)", true},
     {"TexCoord", "vec4", "vec4(0., 0., 0., 1.)", false},
     {"FogFragCoord", "float", "0.", false}}};
constexpr int kMostTexCoords = 32;

/// The user's name of the varying.
std::string user(Varying which) {
    return "gl_" + std::string(kRows[which].name);
}
/// Its name in translated shaders.
std::string own(Varying which) {
    return "glibra_" + std::string(kRows[which].name);
}

/// The varying that a word names; kVaryingCount for other words. Sets `input` for names that end with In.
inline Varying varyingOf(std::string_view word, bool& input) {
    input = false;
    if (!word.starts_with("gl_")) return kVaryingCount;
    const std::string_view name = word.substr(3);
    for (std::size_t i = 0; i < kVaryingCount; ++i) {
        if (name == kRows[i].name) return static_cast<Varying>(i);
        if (name.ends_with("In") && name.substr(0, name.size() - 2) == kRows[i].name) {
            input = true;
            return static_cast<Varying>(i);
        }
    }
    return kVaryingCount;
}

}  // namespace varyings
using namespace varyings;

/// What a stage does with one varying.
struct Access {
    bool used = false;  ///< it is used as an output
    bool written = false;
    bool read = false;      ///< it is read as an input
    bool anyIndex = false;  ///< it is written with an index that is not constant
    std::set<int> writtenIndices;
    std::map<int, std::uint32_t> readIndices;  ///< constant indices, and the view index of a use
    std::uint32_t place = kNone;
    std::uint32_t readPlace = kNone;
};
using Accesses = std::array<Access, kVaryingCount>;

/// How a varying is interpolated, as a stage redeclares it.
struct Interpolation {
    std::string qualifier;  ///< "flat", "smooth", "noperspective" or empty
    bool centroid = false;
};

char letter(Stage stage) {
    return "vcegfk"[static_cast<std::size_t>(stage)];
}

class Varyings {
  public:
    Varyings(ProgramUnits& program, const std::vector<TokenWalk>& walks) : program_(program), walks_(walks) {}

    void run() {
        for (Unit& unit : program_.units) accesses_.push_back(scan(unit));
        for (Unit& unit : program_.units) {
            removeRedeclarations(unit);
            dropPerVertex(unit);
        }
        for (std::size_t i = 0; i < program_.units.size(); ++i) stage(i);
    }

  private:
    // What the stages do:

    Accesses scan(Unit& unit) {
        Accesses result;
        for (std::uint32_t i = 0; i < unit.view.size(); ++i) {
            if (unit.view[i].kind != TokenKind::word) continue;
            const std::string_view text = unit.text(i);
            if (!text.starts_with("gl_")) continue;
            if (unit.stage == Stage::fragment && (text == "gl_Color" || text == "gl_SecondaryColor")) {
                const bool first = text == "gl_Color";
                for (const Varying each :
                     first ? std::array{frontColor, backColor} : std::array{frontSecondary, backSecondary})
                    markRead(result[each], i);
                continue;
            }
            bool input = false;
            const Varying which = varyingOf(text, input);
            if (which == kVaryingCount || unit.bodies.roles[i] == WordRole::other) continue;
            access(unit, i, which, input, result[which]);
        }
        return result;
    }

    static void markRead(Access& access, std::uint32_t at) {
        access.read = true;
        if (access.readPlace == kNone) access.readPlace = at;
    }

    void access(Unit& unit, std::uint32_t at, Varying which, bool input, Access& access) {
        std::uint32_t subscript = at + 1;
        bool output = false;
        if (unit.bodies.roles[at] == WordRole::member) {
            const std::string_view root = rootOfMember(unit, at);
            if (root != "gl_in" && root != "gl_out") return;
            output = root == "gl_out";
            input = !output;
            if (output) access.used = access.written = true;
        } else if (input) {
            if (unit.text(subscript) == "[") subscript = unit.bodies.matches[subscript] + 1;
        } else if (unit.stage == Stage::fragment) {
            if (which != texCoord && which != fog) return;
            input = true;
        } else {
            output = true;
            access.used = true;
            const auto writes = unit.writes.find(unit.text(at));
            if (writes != unit.writes.end() && std::ranges::binary_search(writes->second, at))
                access.written = true;
        }
        if (access.place == kNone) access.place = at;
        if (input) markRead(access, at);
        if (which == texCoord) index(unit, subscript, at, output, access);
    }

    /// The word before [ ] . of the member at `at`.
    static std::string_view rootOfMember(const Unit& unit, std::uint32_t at) {
        if (at < 4 || unit.text(at - 2) != "]") return {};
        const std::uint32_t open = unit.bodies.matches[at - 2];
        return open > 0 && open < at ? unit.text(open - 1) : std::string_view{};
    }

    void index(const Unit& unit, std::uint32_t subscript, std::uint32_t at, bool output, Access& access) {
        const int value = constantIndex(unit, subscript);
        if (value < 0 || value >= kMostTexCoords) {
            texCoords_ = std::max(texCoords_, 8);
            if (output) access.anyIndex = true;
            return;
        }
        texCoords_ = std::max(texCoords_, value + 1);
        if (output)
            access.writtenIndices.insert(value);
        else
            access.readIndices.emplace(value, at);
    }

    /// Redeclarations are removed: `varying vec4 gl_TexCoord[4];` gives the size, `flat in vec4 gl_Color;`
    /// the interpolation. The fragment stage decides the interpolation, and its gl_Color is front and back
    /// colour.
    void removeRedeclarations(Unit& unit) {
        for (Variable& variable : unit.variables) {
            bool input = false;
            const Varying which = varyingOf(variable.name, input);
            const bool color = unit.stage == Stage::fragment &&
                               (variable.name == "gl_Color" || variable.name == "gl_SecondaryColor");
            if (which == kVaryingCount && !color) continue;
            const Declaration& declaration = unit.syntax.declarations[variable.declaration];
            const Declarator& declarator = declaration.declarators[variable.declarator];
            long long size = 0;
            if (which == texCoord && !declarator.dimensions.empty() &&
                integerValue(unit, declarator.dimensions.back(), size) && size > 0 && size <= kMostTexCoords)
                texCoords_ = std::max(texCoords_, static_cast<int>(size));
            if (!color) {
                interpolate(which, variable);
            } else if (variable.name == "gl_Color") {
                interpolate(frontColor, variable);
                interpolate(backColor, variable);
            } else {
                interpolate(frontSecondary, variable);
                interpolate(backSecondary, variable);
            }
            variable.removed = true;
        }
    }

    void interpolate(Varying which, const Variable& variable) {
        Interpolation& own = interpolations_[which];
        if (!variable.interpolation.empty()) own.qualifier = variable.interpolation;
        own.centroid = own.centroid || variable.centroid;
    }

    /// gl_PerVertex of core GLSL has none of these members. Without a declaration it has all core members.
    static void dropPerVertex(Unit& unit) {
        for (const Declaration& block : unit.syntax.declarations) {
            if (block.kind != DeclarationKind::block || unit.text(block.name) != "gl_PerVertex") continue;
            const bool old = std::ranges::any_of(block.members, [&](const Declaration& member) {
                bool input = false;
                return !member.declarators.empty() &&
                       (varyingOf(unit.text(member.declarators[0].name), input) != kVaryingCount ||
                        unit.text(member.declarators[0].name) == "gl_ClipVertex");
            });
            if (old) unit.remove(block.tokens);
        }
    }

    // What is emitted for them:

    [[nodiscard]] std::string typeOf(Varying which) const { return std::string(kRows[which].type); }
    [[nodiscard]] std::string size(Varying which) const {
        return which == texCoord ? "[" + std::to_string(texCoords_) + "]" : "";
    }
    [[nodiscard]] std::string initial(Varying which) const {
        if (which != texCoord) return std::string(which == fog ? "0." : "vec4(0., 0., 0., 1.)");
        std::string text = "vec4[" + std::to_string(texCoords_) + "](";
        for (int i = 0; i < texCoords_; ++i) text += std::string(i ? ", " : "") + "vec4(0., 0., 0., 1.)";
        return text + ")";
    }

    /// True if stage `index` - 1 passes `which` to stage `index`.
    [[nodiscard]] bool passes(std::size_t index, Varying which) const {
        return index > 0 && accesses_[index - 1][which].written && accesses_[index][which].read;
    }

    /// The qualifiers of a member of the block that the fragment stage reads. Before 4.20 centroid needs the
    /// block's `direction`.
    [[nodiscard]] std::string qualifiers(Varying which, std::string_view direction) const {
        const Interpolation& own = interpolations_[which];
        const bool byCommand = program_.request->flatColors && kRows[which].color && own.qualifier.empty();
        std::string text = byCommand ? "flat" : own.qualifier;
        if (own.centroid) text += (text.empty() ? "centroid " : " centroid ") + std::string(direction);
        return text.empty() ? text : text + " ";
    }

    [[nodiscard]] std::string block(std::size_t reader, std::string_view direction) const {
        std::string members;
        const bool rasterised = program_.units[reader].stage == Stage::fragment;
        for (const Varying which : kVaryings) {
            if (!passes(reader, which)) continue;
            members += " " + (rasterised ? qualifiers(which, direction) : "") + typeOf(which) + " " +
                       std::string(kRows[which].name) + size(which) + ";";
        }
        if (members.empty()) return {};
        return std::string(direction) + " glibra_Varyings_" + letter(program_.units[reader - 1].stage) +
               " {" + members + " }";
    }

    void stage(std::size_t index) {
        Unit& unit = program_.units[index];
        if (index > 0) inputs(index, unit);
        if (unit.stage == Stage::fragment)
            fragment(index, unit);
        else
            outputs(index, unit);
        rewrite(index, unit, walks_[index]);
    }

    void inputs(std::size_t index, Unit& unit) {
        const std::string text = block(index, "in");
        const bool array = unit.stage != Stage::fragment;
        if (!text.empty()) unit.declare(text + " glibra_in" + (array ? "[];" : ";"));
        for (const Varying which : kVaryings) {
            const Access& access = accesses_[index][which];
            if (!access.read) continue;
            if (!passes(index, which)) {
                if (array || which == frontColor) currentColor(unit, which);
                if (array)
                    unit.declare(typeOf(which) + size(which) + " glibra_unwritten" +
                                 std::string(kRows[which].name) + "(int i) { return " +
                                 (which == texCoord ? initial(which) : std::string(kRows[which].unwritten)) +
                                 "; }");
                if (which != backColor && which != backSecondary) unwritten(unit, which, access.readPlace);
            } else if (which == texCoord) {
                const Access& writer = accesses_[index - 1][which];
                for (const auto& [element, at] : access.readIndices)
                    if (!writer.anyIndex && !writer.writtenIndices.contains(element))
                        warn(unit, "gl_TexCoord[" + std::to_string(element) + "]", at);
            }
        }
    }

    void unwritten(Unit& unit, Varying which, std::uint32_t at) {
        const Access& access = accesses_[static_cast<std::size_t>(&unit - program_.units.data())][which];
        if (which == texCoord && !access.readIndices.empty()) {
            for (const auto& [element, place] : access.readIndices)
                warn(unit, "gl_TexCoord[" + std::to_string(element) + "]", place);
            return;
        }
        warn(unit, std::string(unit.text(at)), at);
    }
    void warn(Unit& unit, const std::string& what, std::uint32_t at) {
        if (unit.isSupplied) return;
        program_.report.reportOnce(unit.path + what, "glsl-W13", what + " is written by no stage",
                                   unit.place(at));
    }
    static void currentColor(Unit& unit, Varying which) {
        if (which == frontColor || which == backColor) unit.declare("uniform vec4 glibra_CurrentColor;");
    }

    /// Also handles a fragment stage without an earlier stage, which reads the values of unwritten varyings.
    void fragment(std::size_t index, Unit& unit) {
        if (index == 0)
            for (const Varying which : kVaryings)
                if (accesses_[0][which].read) currentColor(unit, which);
        const auto value = [&](Varying which) {
            return passes(index, which)
                       ? "glibra_in." + std::string(kRows[which].name)
                       : (which == texCoord ? initial(which) : std::string(kRows[which].unwritten));
        };
        const auto color = [&](Varying front, Varying back, const std::string& name) {
            if (!accesses_[index][front].read) return;
            const std::string text =
                passes(index, back) ? "gl_FrontFacing ? " + value(front) + " : " + value(back) : value(front);
            unit.declare("vec4 glibra_" + name + " = " + text + ";");
            unit.renames["gl_" + name] = "glibra_" + name;
        };
        color(frontColor, backColor, "Color");
        color(frontSecondary, backSecondary, "SecondaryColor");
        for (const Varying which : {texCoord, fog}) {
            if (!accesses_[index][which].read) continue;
            unit.declare(typeOf(which) + " " + own(which) + size(which) + " = " + value(which) + ";");
            unit.renames[user(which)] = own(which);
        }
    }

    void outputs(std::size_t index, Unit& unit) {
        const bool control = unit.stage == Stage::tessControl;
        const std::size_t reader = index + 1;
        const bool last = reader >= program_.units.size() || program_.units[reader].stage == Stage::fragment;
        const std::string text = reader < program_.units.size() ? block(reader, "out") : "";
        if (!text.empty()) unit.declare(text + " glibra_out" + (control ? "[];" : ";"));
        std::vector<std::string> copies;
        for (const Varying which : kVaryings) {
            if (!accesses_[index][which].used) continue;
            const bool passed = reader < program_.units.size() && passes(reader, which);
            if (passed) unit.varyingComponents += which == fog ? 1 : 4 * (which == texCoord ? texCoords_ : 1);
            if (control && passed) continue;
            unit.declare(typeOf(which) + " " + own(which) + size(which) + " = " + initial(which) + ";");
            if (control) continue;
            unit.renames[user(which)] = own(which);
            const std::string source =
                last && kRows[which].color ? "clamp(" + own(which) + ", 0., 1.)" : own(which);
            if (passed)
                copies.push_back("glibra_out." + std::string(kRows[which].name) + " = " + source + ";");
        }
        if (copies.empty()) return;
        // Before the user's text, so that none of its macros or functions changes it.
        std::string body;
        for (const std::string& each : copies) body += " " + each;
        unit.declare("void glibra_copyVaryings() {" + body + " }");
        if (unit.stage != Stage::geometry) {
            unit.mainEnd.emplace_back("glibra_copyVaryings();");
            return;
        }
        const auto tiled = unit.renames.find("EmitVertex");
        const std::string emit = tiled == unit.renames.end() ? "EmitVertex" : tiled->second;
        unit.declare("void glibra_EmitVertex() { glibra_copyVaryings(); " + emit + "(); }");
        unit.renames["EmitVertex"] = "glibra_EmitVertex";
        program_.result->userNames["glibra_EmitVertex"] = "EmitVertex";
    }

    // Names that need more than another spelling, which are array members and the names with In:

    void rewrite(std::size_t index, Unit& unit, const TokenWalk& walk) {
        for (std::uint32_t i = 0; i < unit.tokens.size(); ++i) {
            if (unit.tokens[i].kind != TokenKind::word) continue;
            const std::string_view text = unit.tokens[i].text;
            if (text == "gl_in" || text == "gl_out") {
                member(index, unit, walk, i);
                continue;
            }
            if (text == "EmitStreamVertex") emitStream(unit, walk, i);
            bool input = false;
            const Varying which = varyingOf(text, input);
            if (which != kVaryingCount && input) subscripted(index, unit, walk, i, which);
        }
    }

    void member(std::size_t index, Unit& unit, const TokenWalk& walk, std::uint32_t at) {
        const std::uint32_t open = walk.next(at);
        if (walk.text(open) != "[" || walk.match(open) == kNone) return;
        const std::uint32_t close = walk.match(open);
        const std::uint32_t dot = walk.next(close);
        const std::uint32_t name = walk.next(dot);
        bool input = false;
        const Varying which = walk.text(dot) == "." ? varyingOf(walk.text(name), input) : kVaryingCount;
        if (which == kVaryingCount || input) return;
        if (walk.text(at) == "gl_in") {
            unit.edits.remove(dot);
            unit.edits.remove(name);
            read(index, unit, at, open, close, which);
        } else if (index + 1 < program_.units.size() && passes(index + 1, which)) {
            unit.edits.replace(at, "glibra_out");
            unit.edits.replace(name, std::string(kRows[which].name));
        } else {
            for (std::uint32_t i = at; i != kNone && i != name; i = walk.next(i)) unit.edits.remove(i);
            unit.edits.replace(name, own(which));
        }
    }

    void subscripted(std::size_t index, Unit& unit, const TokenWalk& walk, std::uint32_t at, Varying which) {
        const std::uint32_t open = walk.next(at);
        if (walk.text(open) == "[" && walk.match(open) != kNone) {
            read(index, unit, at, open, walk.match(open), which);
        } else if (unit.stage == Stage::geometry) {
            program_.report.report("glsl-E03",
                                   std::string(walk.text(at)) +
                                       " without a subscript cannot be emulated; write " +
                                       std::string(walk.text(at)) + "[i]",
                                   unit.placeOfToken(at));
        }
    }

    void read(std::size_t index, Unit& unit, std::uint32_t at, std::uint32_t open, std::uint32_t close,
              Varying which) {
        const std::string name(kRows[which].name);
        if (passes(index, which)) {
            unit.edits.replace(at, "glibra_in");
            unit.edits.after(close, "." + name);
        } else {
            unit.edits.replace(at, "glibra_unwritten" + name);
            unit.edits.replace(open, "(");
            unit.edits.replace(close, ")");
        }
    }

    /// EmitStreamVertex takes a constant, so a function cannot call it with a parameter.
    static void emitStream(Unit& unit, const TokenWalk& walk, std::uint32_t at) {
        const auto emit = unit.renames.find("EmitVertex");
        if (emit == unit.renames.end() || emit->second != "glibra_EmitVertex") return;
        const std::uint32_t open = walk.next(at);
        const std::uint32_t close = walk.text(open) == "(" ? walk.match(open) : kNone;
        if (close == kNone || walk.text(walk.next(close)) != ";") return;
        unit.edits.before(at, "{ glibra_copyVaryings(); ");
        unit.edits.after(walk.next(close), " }");
    }

    ProgramUnits& program_;
    const std::vector<TokenWalk>& walks_;
    std::vector<Accesses> accesses_;
    int texCoords_ = 1;
    std::array<Interpolation, kVaryingCount> interpolations_;
};

}  // namespace

void connectBuiltinVaryings(ProgramUnits& program, const std::vector<TokenWalk>& walks) {
    Varyings(program, walks).run();
    for (Unit& unit : program.units) {
        if (unit.stage == Stage::fragment || !unit.isUsed("gl_ClipVertex")) continue;
        unit.declare("vec4 glibra_ClipVertex;");
        unit.renames["gl_ClipVertex"] = "glibra_ClipVertex";
        program.report.report("glsl-W17", "gl_ClipVertex has no effect",
                              unit.place(unit.uses["gl_ClipVertex"].front()));
    }
}

}  // namespace glibra::glsl
