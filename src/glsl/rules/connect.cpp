// Matches the user's own variables between two stages (language, 7.9).

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/suggest.h"
#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"
#include "glsl/parse/variables.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

constexpr int kMostVertices = 32;

/// True for inputs and outputs that are arrays with one element per vertex.
bool isPerVertex(Stage stage, Storage storage, bool patch) {
    if (patch) return false;
    if (stage == Stage::tessControl) return true;
    return storage == Storage::input && (stage == Stage::tessEvaluation || stage == Stage::geometry);
}

class Interface {
  public:
    Interface(ProgramUnits& program, Unit& writer, Unit& reader)
        : program_(program), writer_(writer), reader_(reader) {}

    void run() {
        for (Variable& each : reader_.variables)
            if (each.storage == Storage::input && !each.removed && !each.name.starts_with("gl_"))
                variable(each);
        for (const Declaration& each : reader_.syntax.declarations)
            if (each.kind == DeclarationKind::block && each.qualifiers.storage == Storage::input) block(each);
        interpolations();
    }

  private:
    [[nodiscard]] Variable* output(const std::string& name) {
        for (Variable& each : writer_.variables)
            if (each.storage == Storage::output && each.name == name && !each.removed) return &each;
        return nullptr;
    }
    [[nodiscard]] Variable* outputAt(const std::string& location) {
        for (Variable& each : writer_.variables) {
            const std::string* own =
                each.storage == Storage::output && !each.removed ? each.layoutValue("location") : nullptr;
            if (own && *own == location) return &each;
        }
        return nullptr;
    }

    void variable(Variable& input) {
        Variable* source = output(input.name);
        const std::string* location = input.layoutValue("location");
        if (location) {
            // Variables match by location if both sides have one. Otherwise they match by name, and a
            // location on one side only would prevent that.
            if (Variable* there = outputAt(*location)) {
                if (!isWritten(*there)) unwritten(input);
                return;
            }
            if (source && !source->layoutValue("location")) input.removeLayout("location");
        } else if (source && source->layoutValue("location")) {
            source->removeLayout("location");
        }
        if (!source) return unwritten(input);
        if (!sameType(*source, input)) return mismatch(*source, input);
        if (!isWritten(*source)) return unwritten(input);
        if (program_.request->target.version < 440 && source->interpolation != input.interpolation) {
            source->interpolation = input.interpolation;  // before 4.40 both have to be equal
            source->changed = true;
        }
    }

    [[nodiscard]] bool isWritten(const Variable& output) const { return writer_.isWritten(output.name); }

    /// The array sizes without the one that counts vertices.
    [[nodiscard]] static std::vector<std::string> sizes(const Variable& variable, Stage stage) {
        std::vector<std::string> all = variable.sizes();
        if (isPerVertex(stage, variable.storage, variable.patch) && !all.empty()) all.erase(all.begin());
        return all;
    }
    [[nodiscard]] bool sameType(const Variable& output, const Variable& input) const {
        if (output.type != input.type || output.patch != input.patch) return false;
        const std::vector<std::string> a = sizes(output, writer_.stage), b = sizes(input, reader_.stage);
        if (a.size() != b.size()) return false;
        // The linker checks sizes that are not plain numbers.
        const auto number = [](const std::string& text) {
            return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
        };
        for (std::size_t i = 0; i < a.size(); ++i)
            if (number(a[i]) && number(b[i]) && std::atoi(a[i].c_str()) != std::atoi(b[i].c_str()))
                return false;
        return true;
    }
    [[nodiscard]] static std::string described(const Variable& variable, Stage stage) {
        std::string text = variable.type.empty() ? "a struct" : variable.type;
        for (const std::string& each : sizes(variable, stage)) text += "[" + each + "]";
        return (variable.patch ? "patch " : "") + text;
    }
    void mismatch(const Variable& output, const Variable& input) {
        const Place here = reader_.place(input.nameToken);
        program_.report.report("glsl-E02",
                               "'" + input.name + "' is " + described(output, writer_.stage) + " in " +
                                   shortPlace(writer_.place(output.nameToken)) + " and " +
                                   described(input, reader_.stage) + " in " + shortPlace(here),
                               here);
    }

    [[nodiscard]] int vertices() const {
        return reader_.stage == Stage::geometry ? verticesOfPrimitive(program_.result->geometryInput)
                                                : kMostVertices;
    }

    /// The output of the stage before whose name is nearest; empty if none is near.
    [[nodiscard]] std::string nearestOutput(const std::string& input) const {
        std::vector<std::string_view> outputs;
        for (const Variable& each : writer_.variables)
            if (each.storage == Storage::output && !each.removed && !each.name.starts_with("gl_") &&
                isWritten(each))
                outputs.emplace_back(each.name);
        return base::nearestName(input, outputs, 1);  // all begin with a v
    }

    /// Turns the input into a variable with the value zero.
    void unwritten(Variable& input) {
        if (reader_.isUsed(input.name)) {
            const std::string nearest = nearestOutput(input.name);
            const std::string hint = nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
            program_.report.report(about(
                diagnose("glsl-W11", "'" + input.name + "' is written by no earlier stage, it reads 0" + hint,
                         reader_.place(input.nameToken)),
                input.name, nearest));
        }
        if (input.type.empty()) return;
        unwritten_.insert(input.name);
        if (input.isArray()) {
            const bool perVertex = isPerVertex(reader_.stage, Storage::input, input.patch);
            std::string& first = input.nameSizes.empty() ? input.typeSizes.front() : input.nameSizes.front();
            if (perVertex || first.empty()) {
                first = std::to_string(perVertex ? vertices() : implicitSize(input.name));
                (input.nameSizes.empty() ? input.changed : input.sizesChanged) = true;
            }
        }
        std::vector<std::string> all = input.sizes();
        numberSizes(input, all);
        input.storage = Storage::none;
        input.interpolation.clear();
        input.layout.clear();
        input.centroid = input.sample = input.patch = false;
        input.changed = true;
        if (const auto value = zeroValue(reader_, input.type, all)) input.initializer = " = " + *value;
    }

    /// Replaces the texts of sizes by their values, where these are known.
    void numberSizes(const Variable& input, std::vector<std::string>& all) const {
        const Declaration& declaration = reader_.syntax.declarations[input.declaration];
        std::vector<Range> ranges = declaration.declarators[input.declarator].dimensions;
        ranges.insert(ranges.end(), declaration.type.dimensions.begin(), declaration.type.dimensions.end());
        for (std::size_t i = 0; i < all.size() && i < ranges.size(); ++i)
            if (all[i] == textOf(reader_, ranges[i])) all[i] = sizeText(reader_, ranges[i]);
    }

    /// The size that GLSL gives an array without one: the largest constant index + 1.
    [[nodiscard]] int implicitSize(std::string_view name) const {
        int size = 1;
        for (std::uint32_t i = 0; i + 1 < reader_.view.size(); ++i)
            if (reader_.text(i) == name) size = std::max(size, constantIndex(reader_, i + 1) + 1);
        return size;
    }

    /// interpolateAtCentroid and its kin take inputs only. A variable that stands for an input has the same
    /// value everywhere.
    void interpolations() {
        if (unwritten_.empty()) return;
        std::map<std::uint32_t, bool> calls;  // of each spelled word, whether all its calls are such
        for (const std::string_view function :
             {"interpolateAtCentroid", "interpolateAtSample", "interpolateAtOffset"}) {
            const auto uses = reader_.uses.find(function);
            if (uses == reader_.uses.end() || reader_.isUserName(function)) continue;
            for (const std::uint32_t use : uses->second) {
                std::uint32_t argument = use + 1;
                while (reader_.text(argument) == "(") ++argument;
                const bool stands = unwritten_.contains(reader_.text(argument));
                const auto [found, isNew] = calls.emplace(reader_.view[use].raw, stands);
                if (!isNew) found->second = found->second && stands;
            }
        }
        for (const auto& [token, stands] : calls) {
            if (!stands) continue;
            for (const char* const type : {"float", "vec2", "vec3", "vec4"})
                for (const char* const place : {"", ", int place", ", vec2 place"})
                    reader_.declare(std::string(type) + " glibra_interpolated(" + type + " value" + place +
                                    ") { return value; }");
            reader_.edits.replace(token, "glibra_interpolated");
        }
    }

    void block(const Declaration& input) {
        const std::string_view name = reader_.text(input.name);
        if (name.starts_with("gl_")) return;
        for (const Declaration& each : writer_.syntax.declarations)
            if (each.kind == DeclarationKind::block && each.qualifiers.storage == Storage::output &&
                writer_.text(each.name) == name)
                return;
        if (const LayoutItem* location = input.qualifiers.item("location"); location) return;
        program_.report.report(about(
            diagnose("glsl-W11", "'" + std::string(name) + "' is written by no earlier stage, it reads 0",
                     reader_.place(input.name)),
            std::string(name)));
        for (const Declarator& each : input.declarators) unwritten_.emplace(reader_.text(each.name));
        if (input.declarators.empty())
            for (const Declaration& member : input.members)
                for (const Declarator& each : member.declarators) unwritten_.emplace(reader_.text(each.name));
        reader_.remove({input.tokens.first, input.body.first});
        input.declarators.empty() ? openBlock(input) : structBlock(input);
    }

    /// Handles a block that no stage writes. Without an instance name its members are global names.
    void openBlock(const Declaration& input) {
        reader_.edits.remove(reader_.view[input.body.first].raw);
        reader_.remove({input.body.end - 1, input.tokens.end});
        members(input, true);
    }

    void structBlock(const Declaration& input) {
        const std::string type = "glibra_Zero" + std::string(reader_.text(input.name));
        reader_.edits.replace(reader_.view[input.tokens.first].raw, "struct " + type + " ");
        members(input, false);
        const Declarator& instance = input.declarators.front();
        std::string element = type + "(" + memberValues(input) + ")";
        if (!instance.dimensions.empty()) {
            const int count = vertices();
            reader_.remove(instance.dimensionTokens);
            std::string all;
            for (int i = 0; i < count; ++i) all += (i ? ", " : "") + element;
            element = type + "[" + std::to_string(count) + "](" + all + ")";
            reader_.edits.after(reader_.view[instance.name].raw, "[" + std::to_string(count) + "]");
        }
        reader_.edits.after(reader_.view[instance.name].raw, " = " + element);
    }

    void members(const Declaration& input, bool initialise) {
        for (const Declaration& member : input.members) {
            reader_.remove(member.qualifiers.tokens);
            for (const Declarator& name : member.declarators)
                if (!name.dimensions.empty() && name.dimensions.front().empty())
                    reader_.edits.after(reader_.view[name.name + 1].raw,
                                        std::to_string(implicitSize(reader_.text(name.name))));
            for (const Declarator& name : member.declarators)
                if (const auto value = memberValue(member, name); value && initialise)
                    reader_.edits.after(reader_.view[name.dimensionTokens.end - 1].raw, " = " + *value);
        }
    }
    [[nodiscard]] std::optional<std::string> memberValue(const Declaration& member,
                                                         const Declarator& name) const {
        std::vector<std::string> sizes;
        for (const Range& each : name.dimensions)
            sizes.push_back(each.empty() ? std::to_string(implicitSize(reader_.text(name.name)))
                                         : sizeText(reader_, each));
        for (const Range& each : member.type.dimensions) sizes.push_back(sizeText(reader_, each));
        return zeroValue(reader_, std::string(member.type.name), sizes);
    }
    [[nodiscard]] std::string memberValues(const Declaration& input) const {
        std::string text;
        for (const Declaration& member : input.members)
            for (const Declarator& name : member.declarators)
                text += (text.empty() ? "" : ", ") + memberValue(member, name).value_or("0");
        return text;
    }

    ProgramUnits& program_;
    Unit& writer_;
    Unit& reader_;
    std::set<std::string, std::less<>> unwritten_;  ///< inputs, and instances or members of blocks
};

}  // namespace

void connectStages(ProgramUnits& program) {
    for (std::size_t i = 1; i < program.units.size(); ++i)
        Interface(program, program.units[i - 1], program.units[i]).run();
}

}  // namespace glibra::glsl
