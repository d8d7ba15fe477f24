#include "plan/buffers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "base/text.h"
#include "plan/memory_pattern.h"
#include "scene/textures.h"

namespace glibra::plan {
namespace {

/// How many numbers the built-in variables of shaders count to in a draw or dispatch; 0: not known.
struct Extent {
    std::array<std::uint64_t, 3> groups{};
    std::array<std::uint64_t, 3> invocations{};
    std::uint64_t groupSize = 0;
    std::uint64_t vertices = 0, instances = 0;
    const scene::ObjectView* over = nullptr;

    [[nodiscard]] std::uint64_t of(const std::string& number) const {
        if (number == "gl_GlobalInvocationID.x") return invocations[0];
        if (number == "gl_WorkGroupID.x") return groups[0];
        if (number == "gl_LocalInvocationIndex") return groupSize;
        if (number == "gl_VertexID") return vertices;
        return number == "gl_InstanceID" ? instances : 0;
    }
};

class ReachCheck {
  public:
    ReachCheck(const scene::Scene& scene, const FramePlan& plan, const BufferLayouts& layouts)
        : scene_(scene), plan_(plan), layouts_(layouts) {}

    Diagnostics run() && {
        for (const PlannedDispatch& each : plan_.dispatches) {
            const scene::Dispatch& dispatch = plan_.dispatchOf(each);
            const Extent extent = extentOf(dispatch, plan_.programs[each.program]);
            checkElements(plan_.programs[each.program], extent, "Dispatch", dispatch.place);
            checkAxes(each, extent, dispatch);
        }
        plan_.visitDraws([&](const PlannedDraw& planned, const scene::Draw& draw, const auto&) {
            checkElements(plan_.programs[planned.program], extentOf(draw), draw.word, draw.place);
        });
        return std::move(diagnostics_);
    }

  private:
    [[nodiscard]] Extent extentOf(const scene::Draw& draw) const {
        Extent extent;
        const scene::Shape& shape = scene_.shapes[draw.shape];
        if (shape.bare && !draw.verticesFrom && !draw.indices.buffer && !shape.numbers.empty())
            extent.vertices = static_cast<std::uint64_t>(std::max(0., shape.numbers.front()));
        if (!draw.instancesFrom && draw.instances > 0)
            extent.instances = static_cast<std::uint64_t>(draw.instances);
        return extent;
    }

    [[nodiscard]] Extent extentOf(const scene::Dispatch& dispatch, const PlannedProgram& program) const {
        Extent extent;
        const std::array<int, 3>& local = program.interface->facts.localSize;
        if (std::ranges::find(local, 0) != local.end()) return extent;
        extent.groupSize = 1;
        for (const int each : local) extent.groupSize *= static_cast<std::uint64_t>(each);
        if (const auto* counts = std::get_if<std::array<std::uint64_t, 3>>(&dispatch.groups))
            extent.groups = *counts;
        if (const auto* over = std::get_if<scene::Over>(&dispatch.groups)) {
            extent.over = std::get_if<scene::ObjectView>(&over->what);
            std::optional<std::array<std::uint64_t, 3>> size;
            if (extent.over != nullptr)
                size = sizeOf(*extent.over);
            else
                size = std::get<std::array<std::uint64_t, 3>>(over->what);
            for (std::size_t axis = 0; size && axis < 3; ++axis) {
                const auto side = static_cast<std::uint64_t>(local.at(axis));
                extent.groups.at(axis) = (size->at(axis) + side - 1) / side;
                // Those of the last group that are beyond the size are there for their group alone.
                extent.invocations.at(axis) = size->at(axis);
            }
            return extent;
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
            extent.invocations.at(axis) = extent.groups.at(axis) * static_cast<std::uint64_t>(local.at(axis));
        return extent;
    }

    [[nodiscard]] std::optional<std::array<std::uint64_t, 3>> sizeOf(const scene::ObjectView& object) const {
        if (const auto* buffer = std::get_if<scene::BufferView>(&object)) {
            const BufferLayout* layout = layouts_.find(buffer->buffer);
            if (layout == nullptr) return std::nullopt;
            return std::array<std::uint64_t, 3>{std::max<std::uint64_t>(1, layout->elements), 1, 1};
        }
        return sizeOf(std::get<scene::TextureView>(object));
    }

    [[nodiscard]] std::optional<std::array<std::uint64_t, 3>> sizeOf(const scene::TextureView& view) const {
        const scene::Texture& texture = scene_.textures[view.texture];
        const auto size = scene::sizeOfLevel(texture, view.level.value_or(0));
        if (!size) return std::nullopt;
        const bool isRow = texture.target == scene::TextureTarget::texture1DArray;
        const int layers = view.layer ? 1 : size->at(2);
        const std::array<int, 3> sides =
            isRow ? std::array{size->at(0), layers, 1} : std::array{size->at(0), size->at(1), layers};
        std::array<std::uint64_t, 3> result{};
        for (std::size_t i = 0; i < 3; ++i)
            result.at(i) = static_cast<std::uint64_t>(std::max(1, sides.at(i)));
        return result;
    }

    /// The storage block whose last member is that array, and its buffer.
    [[nodiscard]] const BlockUse* useOf(const PlannedProgram& program, const std::string& array) const {
        for (const BlockUse& use : program.blocks) {
            if (use.kind != BlockUse::Kind::storage) continue;
            const std::string& name = program.interface->storageBlocks.at(use.index).name;
            const glsl::MemoryBlock* block = program.interface->facts.memory.block(name, true);
            if (block != nullptr && !block->members.empty() && block->members.back().name == array)
                return &use;
        }
        return nullptr;
    }

    void checkElements(const PlannedProgram& program, const Extent& extent, const std::string& word,
                       const Place& place) {
        for (const glsl::TranslatedStage& stage : program.interface->facts.stages)
            for (const glsl::ElementSubscript& each : stage.subscripts) {
                const BlockUse* use = useOf(program, each.array);
                const BufferLayout* layout = use != nullptr ? layouts_.find(use->buffer.buffer) : nullptr;
                if (layout == nullptr || !layout->pattern.isRuntimeSized()) continue;
                // Those of another block may have more or fewer numbers.
                const auto own = patternOf(program.interface->storageBlocks.at(use->index));
                if (!own || !own->isRuntimeSized()) continue;
                const std::uint64_t numbers = layout->pattern.numbers(layout->elements);
                const std::uint64_t size = own->element.size();
                const std::uint64_t elements =
                    (numbers - std::min<std::uint64_t>(numbers, own->head.size())) / size;
                const std::uint64_t wanted =
                    each.number.empty() ? static_cast<std::uint64_t>(std::max(-1LL, each.constant) + 1)
                                        : extent.of(each.number);
                if (wanted <= elements) continue;
                const scene::Buffer& buffer = scene_.buffers[use->buffer.buffer];
                const auto type = patternOf(buffer.type, glsl::MemoryStructures());
                const std::uint64_t perDeclared = type ? type->element.size() : size;
                const std::string declared =
                    base::groupedText((wanted * size + perDeclared - 1) / perDeclared);
                const std::string subscript =
                    each.number.empty() ? std::to_string(each.constant) : each.number;
                const std::string way =
                    each.number.empty()
                        ? fmt::format("declare '{}' with {} elements or more", buffer.name, declared)
                    : word == "Dispatch"
                        ? fmt::format("write 'over {}', compare with {}.length(), or declare {} elements",
                                      buffer.name, each.array, declared)
                        : fmt::format("declare '{}' with {} elements", buffer.name, declared);
                report("memory-W05",
                       fmt::format(
                           "{}: {}[{}] (line {}) goes up to element {}, but buffer '{}' has {}; {}", word,
                           each.array, subscript, each.place.line, base::groupedText(wanted - 1), buffer.name,
                           base::countedInGroups(elements, size == perDeclared ? "element" : "such element"),
                           way),
                       place);
            }
    }

    void checkAxes(const PlannedDispatch& planned, const Extent& extent, const scene::Dispatch& dispatch) {
        const PlannedProgram& program = plan_.programs[planned.program];
        const glsl::TranslatedProgram& facts = program.interface->facts;
        constexpr const char* kAxes = "xyz";
        for (const TextureUse& use : planned.textures) {
            if (!use.isImage || !use.view.texture) continue;
            const std::string& uniform = at(program.interface->uniforms, use.uniform).name;
            const auto image = facts.memory.images.find(uniform);
            if (image == facts.memory.images.end() || image->second.isReadonly) continue;
            const auto size = sizeOf(use.view);
            if (!size) continue;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::uint64_t reached = extent.invocations.at(axis);
                if (!facts.invocationAxes.at(axis) || extent.groups.at(axis) != 1 || reached == 0 ||
                    reached >= size->at(axis) || !isWholeElsewhere(extent, *size, axis))
                    continue;
                const std::string& name = scene_.textures[use.view.texture].name;
                return report(
                    "memory-W06",
                    fmt::format("Dispatch: there is one group along {}, so only {} of the {} texels of "
                                "'{}' along {} are reached; write 'over {}' or the number of groups "
                                "along {}",
                                kAxes[axis], base::groupedText(reached), base::groupedText(size->at(axis)),
                                name, kAxes[axis], name, kAxes[axis]),
                    dispatch.place);
            }
        }
    }

    /// True if another axis is reached as far as the image goes, so that the axis is probably forgotten.
    static bool isWholeElsewhere(const Extent& extent, const std::array<std::uint64_t, 3>& size,
                                 std::size_t except) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (axis != except && extent.invocations.at(axis) >= size.at(axis) && size.at(axis) > 1)
                return true;
        return false;
    }

    void report(const char* id, std::string text, const Place& place) {
        const bool isKnown = std::ranges::any_of(
            diagnostics_, [&](const Diagnostic& each) { return each.id == id && each.place == place; });
        if (!isKnown) diagnostics_.push_back(diagnose(id, std::move(text), place));
    }

    const scene::Scene& scene_;
    const FramePlan& plan_;
    const BufferLayouts& layouts_;
    Diagnostics diagnostics_;
};

/// The number of a buffer that begins at this byte; nothing if none does.
std::optional<MemoryNumber> numberAtByte(const BufferLayout& layout, std::uint64_t offset) {
    // Numbers have at least four bytes, and those of later elements lie after those of earlier ones.
    std::uint64_t first = 0, last = std::min(offset / 4 + 1, layout.pattern.numbers(layout.elements));
    while (first < last) {
        const std::uint64_t middle = first + (last - first) / 2;
        if (layout.pattern.at(middle).offset < offset)
            first = middle + 1;
        else
            last = middle;
    }
    if (first >= layout.pattern.numbers(layout.elements)) return std::nullopt;
    const MemoryNumber found = layout.pattern.at(first);
    return found.offset == offset ? std::optional(found) : std::nullopt;
}

/// Checks that a buffer has that many counts there. Nothing if it does, or has no layout.
std::optional<Diagnostic> countsProblem(const scene::Scene& scene, const scene::CountFrom& from,
                                        const BufferLayout* layout, std::uint64_t counts,
                                        const std::string& word, const Place& place) {
    if (layout == nullptr) return std::nullopt;
    const std::string& name = scene.buffers[from.buffer.buffer].name;
    const std::uint64_t bytes = (from.word + counts) * sizeof(std::uint32_t);
    const std::string where = from.word == 0 ? "" : fmt::format(" from word {} on", from.word);
    if (layout->bytes < bytes)
        return diagnose(
            "memory-E12",
            fmt::format("{}: buffer '{}' has {}, but {}{} need{} {}", word, name,
                        base::countedInGroups(layout->bytes, "byte"), base::countedInGroups(counts, "count"),
                        where, counts == 1 ? "s" : "", bytes),
            place);
    for (std::uint64_t i = 0; i < counts; ++i) {
        const auto number = numberAtByte(*layout, (from.word + i) * sizeof(std::uint32_t));
        if (number && (number->kind == NumberKind::unsignedInteger || number->kind == NumberKind::integer))
            continue;
        const std::string lack =
            from.word == 0
                ? fmt::format("does not begin with {} of type uint", base::countedInGroups(counts, "number"))
                : fmt::format("has no {} of type uint{}", counts == 1 ? "number" : "numbers", where);
        return diagnose("memory-E12",
                        fmt::format("{}: buffer '{}' {} ({} decides)", word, name, lack, layout->from),
                        place);
    }
    return std::nullopt;
}

/// memory-E12 for draws and dispatches whose counts their buffers do not hold.
Diagnostics countsProblems(const scene::Scene& scene, const FramePlan& plan, const BufferLayouts& layouts) {
    Diagnostics problems;
    const auto check = [&](const scene::CountFrom& from, std::uint64_t counts, const std::string& word,
                           const Place& place) {
        if (!from) return;
        if (auto problem = countsProblem(scene, from, layouts.find(from.buffer.buffer), counts, word, place))
            problems.push_back(*std::move(problem));
    };
    for (const PlannedDispatch& each : plan.dispatches) {
        const scene::Dispatch& dispatch = plan.dispatchOf(each);
        if (const auto* groups = std::get_if<scene::GroupsFrom>(&dispatch.groups))
            check(groups->first, 3, "Dispatch", dispatch.place);
    }
    plan.visitDraws([&](const auto&, const scene::Draw& draw, const auto&) {
        check(draw.verticesFrom, 1, "Vertices", draw.place);
        check(draw.instancesFrom, 1, "Instances", draw.place);
    });
    return problems;
}

}  // namespace

Diagnostics reachProblems(const scene::Scene& scene, const FramePlan& plan, const BufferLayouts& layouts) {
    Diagnostics problems = countsProblems(scene, plan, layouts);
    append(problems, ReachCheck(scene, plan, layouts).run());
    return problems;
}

}  // namespace glibra::plan
