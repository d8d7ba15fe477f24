// gl_FragColor, gl_FragData and the locations of the user's own outputs (language, 7.6).

#include <algorithm>

#include "glsl/parse/usage.h"
#include "glsl/rules/rules.h"

namespace glibra::glsl {
namespace {

constexpr int kMostOutputs = 64;

class FragmentOutputs {
  public:
    FragmentOutputs(ProgramUnits& program, Unit& unit) : program_(program), unit_(unit) {}

    void run() {
        const bool color = unit_.isUsed("gl_FragColor");
        const bool data = unit_.isUsed("gl_FragData");
        const Variable* own = firstWrittenOutput();
        if ((color || data) && own)
            return mixed(color ? "gl_FragColor" : "gl_FragData", "the output '" + own->name + "'",
                         own->nameToken);
        if (color && data) return mixed("gl_FragColor", "gl_FragData", unit_.uses["gl_FragData"].front());
        for (Variable& each : unit_.variables)
            if (each.name == "gl_FragData" || each.name == "gl_FragColor") each.removed = true;
        if (color)
            fragColor();
        else if (data)
            fragData();
        else
            locations();
        if (color || data) dropOwnOutputs();
    }

  private:
    [[nodiscard]] bool isOwnOutput(const Variable& each) const {
        return each.storage == Storage::output && !each.removed && !each.name.starts_with("gl_");
    }
    [[nodiscard]] const Variable* firstWrittenOutput() const {
        const auto found = std::ranges::find_if(unit_.variables, [&](const Variable& each) {
            return isOwnOutput(each) && unit_.isWritten(each.name);
        });
        return found == unit_.variables.end() ? nullptr : &*found;
    }
    void mixed(const std::string& first, const std::string& second, std::uint32_t at) {
        program_.report.report("glsl-E10", first + " and " + second + " cannot be mixed", unit_.place(at));
    }

    /// Removes outputs that are never written, because they would take a target from gl_FragColor.
    void dropOwnOutputs() {
        for (Variable& each : unit_.variables) {
            if (!isOwnOutput(each)) continue;
            each.storage = Storage::none;
            each.layout.clear();
            each.interpolation.clear();
            each.changed = true;
        }
    }

    void fragColor() {
        const int targets = std::clamp(program_.request->colorTargets, 1, kMostOutputs);
        unit_.renames["gl_FragColor"] = "glibra_FragColor";
        if (targets == 1) {
            unit_.declare("layout(location = 0) out vec4 glibra_FragColor;");
        } else {
            const std::string count = std::to_string(targets);
            unit_.declare("vec4 glibra_FragColor;");
            unit_.declare("layout(location = 0) out vec4 glibra_FragColors[" + count + "];");
            for (int i = 0; i < targets; ++i)
                unit_.mainEnd.push_back("glibra_FragColors[" + std::to_string(i) + "] = glibra_FragColor;");
        }
        program_.result->fragmentOutputs = targets;
    }

    void fragData() {
        int count = 1;
        for (const std::uint32_t at : unit_.uses["gl_FragData"]) {
            const int index = constantIndex(unit_, at + 1);
            count = std::max(count, index < 0 || index >= kMostOutputs ? 8 : index + 1);
        }
        unit_.renames["gl_FragData"] = "glibra_FragData";
        unit_.declare("layout(location = 0) out vec4 glibra_FragData[" + std::to_string(count) + "];");
        program_.result->fragmentOutputs = count;
    }

    /// The number of locations that an output takes.
    [[nodiscard]] int span(const Variable& variable) const {
        int count = 1;
        const Declaration& declaration = unit_.syntax.declarations[variable.declaration];
        const auto multiply = [&](const std::vector<Range>& dimensions) {
            for (const Range& each : dimensions) {
                long long size = 1;
                if (globalIntegerValue(unit_, each, size))
                    count =
                        std::clamp(count * static_cast<int>(std::clamp(size, 1LL, 64LL)), 1, kMostOutputs);
            }
        };
        multiply(declaration.type.dimensions);
        multiply(declaration.declarators[variable.declarator].dimensions);
        return count;
    }

    void locations() {
        std::set<int> taken;
        int highest = 0;
        const auto take = [&](int first, int count) {
            for (int i = first; i < first + count; ++i) taken.insert(i);
            highest = std::max(highest, first + count);
        };
        for (const Variable& each : unit_.variables)
            if (isOwnOutput(each))
                if (const LayoutItem* item =
                        unit_.syntax.declarations[each.declaration].qualifiers.item("location")) {
                    long long value = 0;
                    if (integerValue(unit_, item->value, value) && value >= 0 && value < kMostOutputs)
                        take(static_cast<int>(value), span(each));
                }
        for (Variable& each : unit_.variables) {
            if (!isOwnOutput(each) || each.layoutValue("location")) continue;
            const int count = span(each);
            int first = 0;
            const auto free = [&] {
                for (int i = first; i < first + count; ++i)
                    if (taken.contains(i)) return false;
                return true;
            };
            while (!free()) ++first;
            take(first, count);
            each.setLayout("location", std::to_string(first));
        }
        program_.result->fragmentOutputs = std::max(1, highest);
    }

    ProgramUnits& program_;
    Unit& unit_;
};

}  // namespace

void placeFragmentOutputs(ProgramUnits& program) {
    if (Unit* unit = program.find(Stage::fragment)) FragmentOutputs(program, *unit).run();
}

}  // namespace glibra::glsl
