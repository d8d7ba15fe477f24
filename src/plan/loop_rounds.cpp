#include "plan/loop_rounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>

#include "base/text.h"
#include "plan/memory_pattern.h"
#include "scene/textures.h"

namespace glibra::plan {
namespace {

/// The uniform's value from the scene or the command line, or 0 without one. Nothing if the runtime supplies
/// the value or the shader initialises it.
std::optional<double> valueOf(const PlannedProgram& program, std::string_view name) {
    const std::vector<ActiveUniform>& uniforms = program.interface->uniforms;
    const auto found =
        std::ranges::find_if(uniforms, [&](const ActiveUniform& each) { return each.name == name; });
    if (found == uniforms.end()) return std::nullopt;
    const UniformIndex index(static_cast<std::size_t>(found - uniforms.begin()));
    std::optional<double> value;
    const auto declared = program.interface->facts.uniforms.find(std::string(name));
    if (declared == program.interface->facts.uniforms.end() || !declared->second.hasInitializer) value = 0;
    for (const UniformBinding& each : program.values) {
        if (each.uniform != index) continue;
        const auto* literal = std::get_if<Literal>(&each.value);
        if (literal == nullptr || literal->values.empty()) return std::nullopt;
        value = literal->values.front();
    }
    return value;
}

glsl::UniformValue valuesOf(const PlannedProgram& program, const Measure& measure) {
    return [&program, &measure](std::string_view name) -> std::optional<double> {
        if (const auto value = valueOf(program, name)) return value;
        return measure ? measure(name) : std::nullopt;
    };
}

}  // namespace

Diagnostics reportLostVertices(const PlannedProgram& program, const Measure& measure) {
    const glsl::TranslatedProgram& facts = program.interface->facts;
    const glsl::UniformValue value = valuesOf(program, measure);
    for (const glsl::TranslatedStage& stage : facts.stages) {
        if (stage.stage != glsl::Stage::geometry || facts.maxVertices == 0) continue;
        double emitted = stage.emits;
        for (const glsl::CountedLoop& each : stage.loops) emitted += glsl::emittedBy(each, value);
        constexpr double kMost = 1e9;
        if (emitted <= facts.maxVertices || emitted > kMost) continue;
        const auto count = static_cast<long long>(emitted);
        return {diagnose("glsl-W27",
                         fmt::format("max_vertices is {}, but the stage emits {} vertices, of which the last "
                                     "{} lost; write max_vertices = {}",
                                     facts.maxVertices, base::groupedText(count),
                                     count - facts.maxVertices == 1
                                         ? std::string("one is")
                                         : base::groupedText(count - facts.maxVertices) + " are",
                                     count),
                         facts.maxVerticesPlace)};
    }
    return {};
}

bool hasOpenLoops(const PlannedProgram& program, const Measure& measure) {
    const glsl::UniformValue value = valuesOf(program, measure);
    return std::ranges::any_of(program.interface->facts.stages, [&](const glsl::TranslatedStage& stage) {
        double all = 0;
        for (const glsl::CountedLoop& each : stage.loops) all += glsl::totalRounds(each, value);
        return !stage.uncounted.empty() || all > kRoundsOfAnyDriver ||
               std::ranges::any_of(stage.loops, [&](const auto& each) { return glsl::isOpen(each, value); });
    });
}

Diagnostics reportLongLoops(const PlannedProgram& program, const std::function<int()>& limit,
                            const Measure& measure) {
    Diagnostics diagnostics;
    const glsl::UniformValue value = valuesOf(program, measure);
    for (const glsl::TranslatedStage& stage : program.interface->facts.stages) {
        double all = 0;
        double most = 0;
        const glsl::CountedLoop* longest = nullptr;
        for (const glsl::CountedLoop& each : stage.loops) {
            const double rounds = glsl::totalRounds(each, value);
            all += rounds;
            if (rounds <= most) continue;
            most = rounds;
            longest = &each;
        }
        if (longest == nullptr || all <= kRoundsOfAnyDriver) continue;
        const int allowed = limit();
        if (allowed <= 0 || all <= allowed) continue;
        const char* what = most <= allowed                          ? "the loops of this stage run"
                           : glsl::roundsOf(*longest, value) < most ? "this loop and those in it run"
                                                                    : "this loop runs";
        diagnostics.push_back(diagnose(
            "draw-W08",
            fmt::format(
                "{} up to {} rounds, but the driver ends a shader's loops after {}; the picture may be "
                "wrong",
                what, base::groupedText(static_cast<long long>(most <= allowed ? all : most)),
                base::groupedText(allowed)),
            longest->place));
    }
    return diagnostics;
}

// Sizes and members of blocks whose values a scene shows before its programs run.

namespace {

/// "imageSize(uMap).x", "textureSize(uMap, 2).y"
struct SizeName {
    std::string_view object;
    int level = 0;
    std::size_t axis = 0;
};

std::optional<SizeName> sizeNameOf(std::string_view name) {
    const bool isImage = name.starts_with("imageSize(");
    if (!isImage && !name.starts_with("textureSize(")) return std::nullopt;
    const std::size_t open = name.find('('), close = name.find(')');
    if (close == std::string_view::npos || close + 2 >= name.size()) return std::nullopt;
    SizeName size;
    const std::string_view inside = name.substr(open + 1, close - open - 1);
    const std::size_t comma = inside.find(", ");
    size.object = inside.substr(0, comma);
    if (comma != std::string_view::npos)
        std::from_chars(inside.data() + comma + 2, inside.data() + inside.size(), size.level);
    size.axis = static_cast<std::size_t>(name[close + 2] - 'x');
    return size;
}

/// The part of a linked name after its last point.
std::string_view lastPart(std::string_view name) {
    const std::size_t point = name.rfind('.');
    return point == std::string_view::npos ? name : name.substr(point + 1);
}

class SceneMeasures {
  public:
    SceneMeasures(const scene::Scene& scene, const PlannedProgram& program, std::span<const UnitUse> units)
        : scene_(scene), program_(program), units_(units) {}

    [[nodiscard]] std::optional<double> of(std::string_view name) const {
        if (const auto size = sizeNameOf(name)) return sizeOf(*size);
        constexpr std::string_view kLength = ".length()";
        if (name.ends_with(kLength)) return lengthOf(lastPart(name.substr(0, name.size() - kLength.size())));
        return memberOf(lastPart(name));
    }

  private:
    [[nodiscard]] std::optional<double> sizeOf(const SizeName& name) const {
        for (const UnitUse& each : units_) {
            if (at(program_.interface->uniforms, each.binding.uniform).name != name.object) continue;
            if (!each.binding.bound) return sizeOnUnit(each.binding, name);
            if (each.binding.bound->buffer.buffer) return elementsOf(each.binding.bound->buffer.buffer, {});
            const scene::TextureView& view = each.binding.bound->view;
            if (!view.texture) return std::nullopt;
            return sideOf(scene_.textures[view.texture], view.level.value_or(0) + name.level, name.axis);
        }
        return std::nullopt;
    }

    /// The size of the only texture that the scene ever has on the unit.
    [[nodiscard]] std::optional<double> sizeOnUnit(const SamplerBinding& binding,
                                                   const SizeName& name) const {
        const scene::Texture* found = nullptr;
        for (const scene::Texture& each : scene_.textures) {
            if (!each.name.empty() || each.unit != binding.unit) continue;
            if (found != nullptr) return std::nullopt;
            found = &each;
        }
        return found != nullptr ? sideOf(*found, name.level, name.axis) : std::nullopt;
    }

    [[nodiscard]] static std::optional<double> sideOf(const scene::Texture& texture, int level,
                                                      std::size_t axis) {
        const auto size = scene::sizeOfLevel(texture, level);
        if (!size) return std::nullopt;
        const auto count = texture.target == scene::TextureTarget::texture1DArray
                               ? std::array<int, 3>{size->at(0), size->at(2), 1}
                               : *size;
        return count.at(std::min<std::size_t>(axis, 2));
    }

    /// The elements of a buffer after the numbers of `head`.
    [[nodiscard]] std::optional<double> elementsOf(scene::BufferIndex index,
                                                   const MemoryPattern& pattern) const {
        const scene::Buffer& buffer = scene_.buffers[index];
        if (buffer.file) return std::nullopt;
        if (buffer.count) return static_cast<double>(*buffer.count);
        const double numbers = static_cast<double>(buffer.values.size());
        const double each = static_cast<double>(std::max<std::size_t>(1, pattern.element.size()));
        return std::max(0., (numbers - static_cast<double>(pattern.head.size())) / each);
    }

    [[nodiscard]] std::optional<double> lengthOf(std::string_view member) const {
        for (const BlockUse& use : program_.blocks) {
            if (use.kind != BlockUse::Kind::storage) continue;
            const base::StorageBlock& block = program_.interface->storageBlocks.at(use.index);
            for (const base::StorageMember& each : block.members) {
                const std::string_view name = each.name;
                const std::string_view array = name.substr(0, name.find('['));
                if (lastPart(array) != member) continue;
                if (each.arraySize > 1 && each.outerSize == 1) return each.arraySize;
                const auto pattern = patternOf(block);
                if (pattern && pattern->isRuntimeSized()) return elementsOf(use.buffer.buffer, *pattern);
            }
        }
        return std::nullopt;
    }

    /// What the scene writes into a number of a buffer before any shader does.
    [[nodiscard]] std::optional<double> memberOf(std::string_view member) const {
        for (const BlockUse& use : program_.blocks) {
            std::optional<MemoryPattern> pattern;
            std::optional<int> offset;
            if (use.kind == BlockUse::Kind::storage) {
                const base::StorageBlock& block = program_.interface->storageBlocks.at(use.index);
                for (const base::StorageMember& each : block.members)
                    if (lastPart(each.name) == member && each.arraySize == 1) offset = each.offset;
                if (offset) pattern = patternOf(block);
            } else if (use.kind == BlockUse::Kind::uniform) {
                for (const ActiveUniform& each : program_.interface->uniforms)
                    if (each.block == static_cast<int>(use.index) && lastPart(each.name) == member &&
                        !each.isArray)
                        offset = each.offset;
                if (offset) pattern = patternOf(*program_.interface, use.index);
            }
            if (pattern) return numberAt(scene_.buffers[use.buffer.buffer], *pattern, *offset);
        }
        return std::nullopt;
    }

    [[nodiscard]] static std::optional<double> numberAt(const scene::Buffer& buffer,
                                                        const MemoryPattern& pattern, int offset) {
        if (buffer.file) return std::nullopt;
        for (std::size_t i = 0; i < pattern.head.size(); ++i)
            if (pattern.head[i].offset == static_cast<std::uint64_t>(offset))
                return i < buffer.values.size() ? buffer.values.numbers()[i] : 0;
        return std::nullopt;
    }

    const scene::Scene& scene_;
    const PlannedProgram& program_;
    std::span<const UnitUse> units_;
};

}  // namespace

Measure measureOf(const scene::Scene& scene, const PlannedProgram& program, std::span<const UnitUse> units) {
    return [measures = SceneMeasures(scene, program, units)](std::string_view name) {
        return measures.of(name);
    };
}

}  // namespace glibra::plan
