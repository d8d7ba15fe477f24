#include "render/draw/labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "image/text.h"
#include "plan/uniform_names.h"

namespace glibra::render {
namespace {

constexpr int kLabelMargin = 4;  ///< pixels around the block, at scale 1

std::string valueText(const std::vector<double>& values, const plan::ValueType& type) {
    std::string text;
    for (const double each : values) {
        if (!text.empty()) text += ' ';
        if (type.base == plan::BaseType::boolean)
            text += each != 0 ? "true" : "false";
        else
            text += fmt::format("{:.{}f}", each, type.isInteger() ? 0 : 4);
    }
    return text;
}

std::string labelOf(const scene::Variable& variable) {
    std::string value;
    if (!variable.words.empty()) {
        const auto chosen = static_cast<std::size_t>(std::max(0.0, variable.current.front()));
        value = variable.words.at(std::min(chosen, variable.words.size() - 1));
    } else {
        plan::ValueType type;
        if (variable.form == glib::UniformForm::truth) type.base = plan::BaseType::boolean;
        value = valueText(variable.current, type);
    }
    return variable.name + " = " + value;
}

/// The value of the binding that a tag names; null if there is none that a user could see as a number.
const std::vector<double>* valuesOf(const plan::PlannedProgram& planned, const plan::NamedUniform& named) {
    for (const plan::UniformBinding& each : planned.values) {
        const auto* literal = std::get_if<plan::Literal>(&each.value);
        if (literal && each.uniform == named.uniform && each.firstElement == named.element &&
            !literal->values.empty())
            return &literal->values;
    }
    return nullptr;
}

}  // namespace

std::string titleOf(const scene::Scene& scene, scene::ProgramIndex program) {
    const std::string& name = scene.programs[program].name;
    int sameName = 0;
    int before = 0;
    for (const scene::ProgramIndex i : scene.programs.indices()) {
        if (scene.programs[i].name != name) continue;
        ++sameName;
        if (i <= program) ++before;
    }
    return sameName > 1 ? fmt::format("{} ({})", name, before) : name;
}

std::vector<std::string> labelsOf(const scene::Scene& scene, std::span<const plan::FramePlan* const> plans) {
    std::vector<std::string> lines;
    for (const scene::Variable& each : scene.variables) lines.push_back(labelOf(each));
    std::vector<const plan::PlannedProgram*> programs;
    for (const plan::FramePlan* plan : plans)
        for (const plan::PlannedProgram& each : plan->programs)
            if (each.variant.program && each.interface->usable) programs.push_back(&each);
    std::ranges::stable_sort(
        programs, [](const auto* a, const auto* b) { return a->variant.program < b->variant.program; });
    std::set<std::pair<scene::ProgramIndex, std::string>> known;  // a program may be planned in variants
    for (const plan::PlannedProgram* planned : programs) {
        const plan::UniformNames names(*planned->interface);
        for (const glib::UniformSpec& spec : scene.programs[planned->variant.program].uniforms)
            for (const plan::NamedUniform& named : names.find(spec.tag)) {
                const plan::ValueType& type = at(planned->interface->uniforms, named.uniform).type;
                const std::vector<double>* values = valuesOf(*planned, named);
                if (!values || type.isOpaque() || !known.emplace(planned->variant.program, spec.tag).second)
                    continue;
                lines.push_back(fmt::format("{} : {} = {}", titleOf(scene, planned->variant.program),
                                            spec.tag, valueText(*values, type)));
            }
    }
    return lines;
}

LabelBlock labelBlock(int width, int height, std::vector<std::string> lines, LabelCorner corner) {
    constexpr int kRowsPerScale = 720;
    LabelBlock block;
    block.scale = std::max(1, (height + kRowsPerScale / 2) / kRowsPerScale);
    const int margin = kLabelMargin * block.scale;
    const auto most =
        static_cast<std::size_t>(std::max(0, height - 2 * margin) / (image::kLineHeight * block.scale));
    if (lines.size() > most) {
        const std::size_t left = lines.size() - most + 1;
        lines.resize(most);
        if (most > 0) lines.back() = fmt::format("... and {} more", left);
    }
    std::size_t longest = 0;
    for (const std::string& each : lines) longest = std::max(longest, each.size());
    // A pixel more on each side for the outline.
    block.width = (static_cast<int>(longest) * image::kCharacterWidth + 2) * block.scale;
    block.height = static_cast<int>(lines.size()) * image::kLineHeight * block.scale;
    const bool isRight = corner == LabelCorner::bottomRight || corner == LabelCorner::topRight;
    const bool isTop = corner == LabelCorner::topLeft || corner == LabelCorner::topRight;
    block.left = isRight ? std::max(margin, width - margin - block.width) : margin;
    block.top = isTop ? margin : height - margin - block.height;
    block.lines = std::move(lines);
    return block;
}

void drawLabels(image::Image& picture, const LabelBlock& block, int left, int top) {
    for (const std::string& each : block.lines) {
        image::drawText(picture, left + block.scale, top, each, block.scale);
        top += image::kLineHeight * block.scale;
    }
}

}  // namespace glibra::render
