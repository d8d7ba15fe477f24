// The indices that `Vertices ... indices BUFFER` reads, and the elements that draws take from buffers
// (language, 12.6).

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "base/suggest.h"
#include "base/text.h"
#include "glib/number.h"
#include "plan/accesses.h"
#include "plan/buffers.h"
#include "render/load/device_scene.h"

namespace glibra::render {
namespace {

constexpr double kRestartAt = std::numeric_limits<std::uint32_t>::max();
constexpr double kRestartOfInts = -1;

/// The buffers that nodes of the plan write to.
std::set<scene::BufferIndex> writtenBuffers(const plan::FramePlan& plan) {
    std::set<scene::BufferIndex> written;
    for (const plan::NodeAccess& node : plan.accesses)
        for (const plan::Object& each : node.written)
            if (const auto* buffer = std::get_if<scene::BufferIndex>(&each)) written.insert(*buffer);
    return written;
}

}  // namespace

std::optional<DeviceScene::Indices> DeviceScene::indicesOf(const scene::Draw& draw) const {
    const plan::BufferLayout* layout = draw.indices.buffer ? buffers_.layout(draw.indices.buffer) : nullptr;
    const gpu::Buffer* buffer = layout != nullptr ? buffers_.buffer(draw.indices) : nullptr;
    if (buffer == nullptr) return std::nullopt;
    const plan::MemoryPattern& pattern = layout->pattern;
    if (pattern.element.size() != 1 || pattern.stride != sizeof(GLuint) ||
        pattern.elementsAt % sizeof(GLuint) != 0)
        return std::nullopt;
    const plan::NumberKind kind = pattern.element.front().kind;
    if (kind != plan::NumberKind::integer && kind != plan::NumberKind::unsignedInteger) return std::nullopt;
    // Vertices are counted by ints.
    const std::uint64_t most = std::numeric_limits<int>::max();
    return Indices{buffer, pattern.elementsAt, static_cast<int>(std::min(layout->elements, most))};
}

std::optional<std::string> DeviceScene::elementsProblem(const plan::FramePlan& plan,
                                                        const plan::PlannedDraw& planned) const {
    const scene::Draw& draw = plan.drawOf(planned);
    const scene::Shape& shape = scene_.shapes[draw.shape];
    if (!planned.inputs) return std::nullopt;
    std::uint64_t vertices = 0, instances = 0;  // 0: not known here
    if (!draw.instancesFrom) instances = static_cast<std::uint64_t>(draw.instances);
    if (shape.bare && !draw.verticesFrom && !draw.indices.buffer && !shape.numbers.empty())
        vertices = static_cast<std::uint64_t>(shape.numbers[0]);
    for (const plan::InputSource& each : plan.inputs[planned.inputs].sources) {
        const std::optional<Elements> of = elementsOf(plan, each);
        const std::uint64_t needed = each.isPerInstance ? instances : vertices;
        if (!of || needed <= of->count) continue;
        return fmt::format("{}: {} {} are more than the {} elements of '{}'", draw.word,
                           base::groupedText(needed), each.isPerInstance ? "instances" : "vertices",
                           base::groupedText(of->count),
                           scene_.buffers[std::get<scene::BufferView>(each.from).buffer].name);
    }
    return std::nullopt;
}

Diagnostics DeviceScene::membersProblems(const plan::FramePlan& plan,
                                         const plan::PlannedDraw& planned) const {
    Diagnostics problems;
    if (!planned.inputs) return problems;
    const scene::Draw& draw = plan.drawOf(planned);
    for (const plan::InputSource& each : plan.inputs[planned.inputs].sources) {
        const auto* view = std::get_if<scene::BufferView>(&each.from);
        const plan::BufferLayout* layout = view != nullptr ? buffers_.layout(view->buffer) : nullptr;
        if (layout == nullptr || each.part.member.empty() || elementsOf(plan, each)) continue;
        const std::optional<base::StorageBlock> block = plan::blockOf(plan, view->buffer);
        std::string advice =
            "; its members have names where a block of a program holds it, and otherwise 'offset' and "
            "'stride' "
            "say which numbers are meant";
        if (block) {
            const plan::BufferTable table = plan::tableOf(*layout, &*block, layout->pattern.element.size());
            std::vector<std::string_view> names;
            for (const plan::BufferColumn& column : table.columns) names.push_back(column.name);
            advice = base::suggestion(each.part.member, names);
            if (advice.empty()) advice = fmt::format("; its members are {}", fmt::join(names, ", "));
        }
        problems.push_back(
            diagnose("draw-E12",
                     fmt::format("{}: an attribute reads the member '{}' of buffer '{}', which has "
                                 "none of that name{}",
                                 draw.word, each.part.member, scene_.buffers[view->buffer].name, advice),
                     draw.place));
    }
    return problems;
}

Diagnostics DeviceScene::checkElements(const plan::FramePlan& plan) const {
    Diagnostics diagnostics;
    std::set<std::pair<int, std::string>> reported;  // of a statement in a Repeat
    plan.visitDraws([&](const plan::PlannedDraw& planned, const scene::Draw& draw, const auto&) {
        std::optional<std::string> problem = elementsProblem(plan, planned);
        for (Diagnostic& each : membersProblems(plan, planned))
            if (reported.emplace(draw.place.line, each.text).second) diagnostics.push_back(std::move(each));
        if (problem && reported.emplace(draw.place.line, *problem).second)
            diagnostics.push_back(diagnose("memory-E13", std::move(*problem), draw.place));
    });
    return diagnostics;
}

Diagnostics DeviceScene::checkIndices(const plan::FramePlan& plan) {
    Diagnostics diagnostics;
    std::optional<std::set<scene::BufferIndex>> written;
    plan.visitDraws([&](const plan::PlannedDraw& planned, const scene::Draw& draw, const auto&) {
        const scene::BufferIndex index = draw.indices.buffer;
        if (!index || buffers_.layout(index) == nullptr) return;  // reported
        if (!written) written = writtenBuffers(plan);
        const bool isAsDeclared = !written->contains(index) && !buffers_.state(index).lasts;
        if (auto problem = indexProblem(plan, planned, isAsDeclared))
            diagnostics.push_back(diagnose("memory-E13", std::move(*problem), draw.place));
    });
    return diagnostics;
}

std::optional<std::string> DeviceScene::indexProblem(const plan::FramePlan& plan,
                                                     const plan::PlannedDraw& planned, bool isAsDeclared) {
    const scene::Draw& draw = plan.drawOf(planned);
    const plan::BufferLayout& layout = *buffers_.layout(draw.indices.buffer);
    const std::string& name = scene_.buffers[draw.indices.buffer].name;
    const std::optional<Indices> indices = indicesOf(draw);
    if (!indices)
        return fmt::format(
            "{}: indices are uint or int, one after another; {} lays out buffer '{}' otherwise", draw.word,
            layout.from, name);
    const std::vector<double>& numbers = scene_.shapes[draw.shape].numbers;
    const auto given =
        draw.drawsAllIndices || numbers.empty() ? std::uint64_t{0} : static_cast<std::uint64_t>(numbers[0]);
    if (given > layout.elements)
        return fmt::format("{}: {} indices are more than the {} of buffer '{}'", draw.word,
                           base::groupedText(given), base::groupedText(layout.elements), name);
    if (layout.elements == 0)
        return fmt::format("{}: buffer '{}' is empty, so it has no indices", draw.word, name);
    if (!isAsDeclared || !planned.inputs) return std::nullopt;
    std::optional<std::uint64_t> vertices;  // of the shortest buffer with attributes
    scene::BufferIndex shortest;
    for (const plan::InputSource& each : plan.inputs[planned.inputs].sources) {
        const std::optional<Elements> of = each.isPerInstance ? std::nullopt : elementsOf(plan, each);
        if (!of || (vertices && *vertices <= of->count)) continue;
        vertices = of->count;
        shortest = std::get<scene::BufferView>(each.from).buffer;
    }
    if (!vertices) return std::nullopt;
    const bool restarts = planned.submission.topology != geometry::Topology::patches;
    const std::uint64_t count = draw.drawsAllIndices || draw.verticesFrom ? layout.elements : given;
    const auto beyond = firstIndexFrom(draw.indices.buffer, count, *vertices, restarts);
    if (!beyond) return std::nullopt;
    return fmt::format("{}: element {} of '{}' is vertex {}, but '{}' has {} elements", draw.word,
                       base::groupedText(beyond->element), name, glib::numberText(beyond->vertex),
                       scene_.buffers[shortest].name, base::groupedText(*vertices));
}

std::optional<DeviceScene::IndexAt> DeviceScene::firstIndexFrom(scene::BufferIndex buffer,
                                                                std::uint64_t count, std::uint64_t limit,
                                                                bool restarts) {
    const scene::Buffer& declared = scene_.buffers[buffer];
    const std::size_t head = buffers_.layout(buffer)->pattern.head.size();
    // Values that the statement does not give are zero.
    std::vector<double> ofFile;
    std::span<const double> values;
    if (declared.file) {
        if (!checkedIndices_.emplace(buffer, count, limit).second) return std::nullopt;
        values = ofFile = buffers_.read({buffer}, head, count);
    } else {
        values = std::span(declared.values.numbers()).subspan(std::min(head, declared.values.size()));
    }
    for (std::size_t i = 0; i < values.size() && i < count; ++i) {
        const double vertex = values[i];
        const bool isRestart = restarts && (vertex == kRestartAt || vertex == kRestartOfInts);
        if (!isRestart && !(vertex >= 0 && vertex < static_cast<double>(limit))) return IndexAt{i, vertex};
    }
    return std::nullopt;
}

}  // namespace glibra::render
