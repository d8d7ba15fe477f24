#include "render/check/object_content.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/suggest.h"
#include "base/text.h"

namespace glibra::render {
namespace {

/// The values of a level as doubles, its layers after one another.
template <class T>
std::vector<double> doublesOf(std::span<const std::byte> bytes) {
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return {values.begin(), values.end()};
}

/// The distance of neighbouring values of a normalised format; 0 for floats and integers.
double stepOf(base::TexelFormat format) {
    const base::TexelFormatRow& row = base::rowOf(format);
    if (row.bits == 0 || base::isInteger(format)) return 0;
    const double largest = std::exp2(row.bits) - 1;
    return row.kind == base::TexelClass::signedNormalized ? 2 / (largest - 1) : 1 / largest;
}

Result<Content> textureContent(Conductor& conductor, const scene::TextureView& view) {
    const scene::Texture& declared = conductor.scene.textures[view.texture];
    DeviceScene& device = conductor.device;
    const gpu::Texture* texture = device.textures().texture(view);
    const auto refuse = [&](const std::string& why) {
        return diagnose("check-E02", fmt::format("'{}' {}", declared.name, why), declared.place);
    };
    if (texture == nullptr) return refuse("was not drawn");
    if (texture->samples() > 1) return refuse("has several samples per texel and cannot be read");
    const int level = view.level.value_or(0);
    if (level >= texture->levels()) return refuse(fmt::format("has no level {}", level));
    if (level > 0)
        texture = device.textures().completed(view);  // its mipmaps may not have been needed so far
    if (view.layer && *view.layer >= texture->layers(level))
        return refuse(fmt::format("has no layer {}", *view.layer));
    Result<Content> content = contentOf(*texture, level, view.layer);
    if (!content) return content;
    content->name = declared.name;
    content->isCube = declared.target == scene::TextureTarget::cube;
    return content;
}

/// The columns of the matrix that a basic type is; else 1.
int matrixColumns(std::string_view type) {
    return type.size() == 4 && type.starts_with("mat") ? type.back() - '0' : 1;
}

Result<Content> bufferContent(Conductor& conductor, const scene::BufferView& view) {
    const scene::Buffer& declared = conductor.scene.buffers[view.buffer];
    const DeviceBuffers& buffers = conductor.device.buffers();
    const plan::BufferLayout* layout = buffers.layout(view.buffer);
    if (layout == nullptr || buffers.buffer(view) == nullptr)
        return diagnose("check-E02", fmt::format("'{}' is not used by anything that was run", declared.name),
                        declared.place);
    Content content;
    content.name = declared.name;
    content.isBuffer = true;
    // What a block has before its array is no element; a block without an array is one.
    const plan::MemoryPattern& pattern = layout->pattern;
    const bool hasArray = !pattern.element.empty();
    content.values =
        buffers.read(view, hasArray ? pattern.head.size() : 0, std::numeric_limits<std::uint64_t>::max());
    const auto& numbers = hasArray ? pattern.element : pattern.head;
    content.components = static_cast<int>(std::max<std::size_t>(1, numbers.size()));
    content.width = static_cast<int>(content.values.size() / static_cast<std::size_t>(content.components));
    for (const plan::MemoryNumber& each : numbers) content.kinds.push_back(each.kind);
    content.isOfDoubles =
        std::ranges::find(content.kinds, plan::NumberKind::doublePrecision) != content.kinds.end();
    if (layout->block) {
        plan::BufferTable table = plan::tableOf(*layout);
        content.members = hasArray ? std::move(table.columns) : std::move(table.head);
    } else {
        content.members = {{declared.name, 0, numbers.size(), matrixColumns(declared.type)}};
    }
    return content;
}

// ---- Parts of contents.

/// The components that letters name: "gb" of a texel are 1 and 2. Empty if one of them is missing.
std::vector<std::size_t> componentsNamed(std::string_view letters, std::size_t first, std::size_t count) {
    std::vector<std::size_t> picked;
    for (const std::string_view set : {"rgba", "xyzw", "stpq"}) {
        if (letters.find_first_not_of(set) != std::string_view::npos || letters.size() > 4) continue;
        for (const char each : letters) picked.push_back(set.find(each));
        break;
    }
    if (std::ranges::any_of(picked, [&](std::size_t each) { return each >= count; })) picked.clear();
    for (std::size_t& each : picked) each += first;
    return picked;
}

/// Finds the numbers of an element that a part names, and how they are members. Returns why there are none.
std::string pick(const Content& whole, const std::string& part, std::vector<std::size_t>& picked,
                 std::vector<plan::BufferColumn>& members) {
    if (!whole.isBuffer) {
        picked = componentsNamed(part, 0, static_cast<std::size_t>(whole.components));
        return !picked.empty()
                   ? std::string()
                   : fmt::format("'{}' has {}, not '{}'", whole.name,
                                 base::counted(static_cast<std::size_t>(whole.components), "component"),
                                 part);
    }
    const auto find = [&](std::string_view name) {
        return std::ranges::find_if(whole.members, [&](const auto& each) { return each.name == name; });
    };
    auto member = find(part);
    const std::size_t point = part.rfind('.');
    if (member != whole.members.end()) {
        for (std::size_t i = 0; i < member->count; ++i) picked.push_back(member->first + i);
        members = {{member->name, 0, member->count, member->matrixColumns}};
        return {};
    }
    const bool isLone = point == std::string::npos && whole.members.size() == 1;
    member = isLone ? whole.members.begin() : find(part.substr(0, point == std::string::npos ? 0 : point));
    if (member != whole.members.end() && member->matrixColumns == 1)
        picked = componentsNamed(isLone ? part : part.substr(point + 1), member->first, member->count);
    members = {{part, 0, picked.size(), 1}};
    if (!picked.empty()) return {};
    std::vector<std::string_view> names;
    for (const plan::BufferColumn& each : whole.members) names.push_back(each.name);
    std::string help = base::suggestion(part, names);
    if (help.empty()) help = fmt::format("; it has {}", fmt::join(names, ", "));
    return fmt::format("an element of '{}' has no member '{}'{}", whole.name, part, help);
}

/// The part of a content that is selected. `layer`: one of several. Returns why there is none.
std::string narrow(const Content& whole, std::optional<int> layer, const scene::Selection& selection,
                   Content& part) {
    if (layer && *layer >= whole.depth) return fmt::format("'{}' has no layer {}", whole.name, *layer);
    part.name = whole.name;
    part.step = whole.step;
    part.isCube = whole.isCube;
    part.isBuffer = whole.isBuffer;
    part.isOfDoubles = whole.isOfDoubles;
    part.members = whole.members;
    part.hasRows = whole.height * whole.depth > 1;
    part.width = whole.width;
    part.height = whole.height;
    part.depth = layer ? 1 : whole.depth;
    if (!selection.part.empty())
        if (std::string why = pick(whole, selection.part, part.picked, part.members); !why.empty())
            return why;
    const auto components = static_cast<std::size_t>(whole.components);
    std::vector<std::size_t> picked = part.picked;
    if (picked.empty())
        for (std::size_t i = 0; i < components; ++i) picked.push_back(i);
    part.components = static_cast<int>(picked.size());
    for (const std::size_t each : picked)
        if (!whole.kinds.empty()) part.kinds.push_back(whole.kinds[each]);
    if (!selection.area.empty()) {
        const auto& area = selection.area;
        const double width = whole.isBuffer ? area[1] - area[0] + 1 : area[2];
        const double height = whole.isBuffer ? 1 : area[3], bottom = whole.isBuffer ? 0 : area[1];
        if (!(area[0] >= 0 && bottom >= 0 && area[0] + width <= whole.width &&
              bottom + height <= whole.height))
            return whole.isBuffer
                       ? fmt::format("'{}' has {}", whole.name,
                                     base::counted(static_cast<std::size_t>(whole.width), "element"))
                       : fmt::format("'{}' has {} x {} texels", whole.name, whole.width, whole.height);
        part.left = static_cast<int>(area[0]);
        part.bottom = static_cast<int>(bottom);
        part.width = static_cast<int>(width);
        part.height = static_cast<int>(height);
    }
    part.values.reserve(part.size() * picked.size());
    for (int z = 0; z < part.depth; ++z)
        for (int y = 0; y < part.height; ++y) {
            const std::size_t row =
                (static_cast<std::size_t>(layer.value_or(z)) * static_cast<std::size_t>(whole.height) +
                 static_cast<std::size_t>(part.bottom + y)) *
                    static_cast<std::size_t>(whole.width) +
                static_cast<std::size_t>(part.left);
            for (std::size_t x = 0; x < static_cast<std::size_t>(part.width); ++x)
                for (const std::size_t each : picked)
                    part.values.push_back(whole.values[(row + x) * components + each]);
        }
    return {};
}

}  // namespace

Result<Content> contentOf(const gpu::Texture& texture, int level, std::optional<int> layer) {
    const gpu::TextureSize size = gpu::sizeOfLevel(texture.shape(), texture.size(), level);
    Content content;
    content.width = size.width;
    content.height = size.height;
    content.depth = texture.layers(level);
    const base::TexelFormatRow& row = base::rowOf(texture.format());
    content.components = base::hasDepth(texture.format()) ? 1 : row.components;
    content.step = stepOf(texture.format());
    const gpu::TexelType type = row.kind == base::TexelClass::integer           ? gpu::TexelType::i32
                                : row.kind == base::TexelClass::unsignedInteger ? gpu::TexelType::u32
                                                                                : gpu::TexelType::f32;
    const auto bytes = texture.read(level, content.components, type);
    if (!bytes) return bytes.diagnostics;
    std::span<const std::byte> wanted = *bytes;
    if (layer) {
        const std::size_t layerBytes = wanted.size() / static_cast<std::size_t>(content.depth);
        wanted = wanted.subspan(layerBytes * static_cast<std::size_t>(*layer), layerBytes);
        content.depth = 1;
    }
    content.values = type == gpu::TexelType::i32   ? doublesOf<std::int32_t>(wanted)
                     : type == gpu::TexelType::u32 ? doublesOf<std::uint32_t>(wanted)
                                                   : doublesOf<float>(wanted);
    return content;
}

Result<Content> contentOf(Conductor& conductor, const scene::ObjectView& object) {
    if (const auto* texture = std::get_if<scene::TextureView>(&object))
        return textureContent(conductor, *texture);
    return bufferContent(conductor, std::get<scene::BufferView>(object));
}

Result<std::shared_ptr<const Content>> Contents::wholeOf(const std::optional<scene::ObjectView>& object) {
    const auto known = std::ranges::find_if(read_, [&](const Whole& each) { return each.first == object; });
    if (known != read_.end()) return known->second;
    Result<Content> content = object ? contentOf(conductor_, *object) : window_();
    if (!content) return std::move(content.diagnostics);
    // Large objects are not all kept at once.
    constexpr std::size_t kMostKept = std::size_t{1} << 27U;  // doubles
    std::size_t kept = content->values.size();
    for (const Whole& each : read_) kept += each.second->values.size();
    if (kept > kMostKept) read_.clear();
    return read_.emplace_back(object, std::make_shared<const Content>(std::move(*content))).second;
}

std::shared_ptr<const Content> Contents::asDeclared(std::shared_ptr<const Content> whole,
                                                    const scene::ObjectView& object) const {
    const auto* buffer = std::get_if<scene::BufferView>(&object);
    if (buffer == nullptr) return whole;
    const scene::Buffer& declared = conductor_.scene.buffers[buffer->buffer];
    const auto pattern = plan::patternOf(declared.type, {});  // of a basic type
    const std::size_t size = pattern ? pattern->element.size() : 0;
    if (size == 0 || size == static_cast<std::size_t>(whole->components) || whole->values.size() % size != 0)
        return whole;
    Content other = *whole;
    other.kinds.assign(size, other.kinds.empty() ? plan::NumberKind::floating : other.kinds.front());
    other.components = static_cast<int>(size);
    other.width = static_cast<int>(other.values.size() / size);
    other.members = {{declared.name, 0, size, matrixColumns(declared.type)}};
    return std::make_shared<const Content>(std::move(other));
}

Result<std::shared_ptr<const Content>> Contents::selected(const scene::Selection& selection,
                                                          bool isAsDeclared) {
    std::optional<scene::ObjectView> object = selection.object;
    std::optional<int> layer;
    if (auto* texture = object ? std::get_if<scene::TextureView>(&*object) : nullptr) {
        layer = std::exchange(texture->layer, std::nullopt);
        texture->sampler = {};
    }
    auto whole = wholeOf(object);
    if (whole && isAsDeclared && object) whole = asDeclared(std::move(*whole), *object);
    if (!whole || (!layer && selection.part.empty() && selection.area.empty())) return whole;
    Content part;
    if (const std::string why = narrow(**whole, layer, selection, part); !why.empty())
        return diagnose("check-E02", why, {conductor_.scene.path, 1, 1});
    return std::make_shared<const Content>(std::move(part));
}

std::vector<double> sumsOf(const Content& content) {
    const auto count = static_cast<std::size_t>(content.components);
    std::vector<double> sums(count);
    for (std::size_t k = 0; k < count; ++k) {
        double total = 0, lost = 0;
        for (std::size_t i = k; i < content.values.size(); i += count) {
            const double value = content.values[i], next = total + value;
            lost += std::abs(total) >= std::abs(value) ? total - next + value : value - next + total;
            total = next;
        }
        sums[k] = std::isfinite(total) ? total + lost : total;
    }
    return sums;
}

scene::Measured Contents::measured(const scene::Measure& measure) {
    scene::Measured found;
    auto content = selected(measure.of, true);
    if (!content) {
        found.why = content.diagnostics.empty() ? "it cannot be read" : content.diagnostics.front().text;
        return found;
    }
    const Content& values = **content;
    const auto count = static_cast<std::size_t>(values.components);
    const int columns = values.members.size() == 1 ? values.members.front().matrixColumns : 1;
    const bool isSquare = columns > 1 && count == static_cast<std::size_t>(columns * columns);
    if (values.members.size() > 1 || (count > 4 && !isSquare)) {
        found.why = fmt::format("an element of '{}' has {}; name one of its members: {}.{}", values.name,
                                base::counted(count, "number"), values.name,
                                values.members.empty() ? "NAME" : values.members.front().name);
        return found;
    }
    if (values.size() == 0) {
        found.why = fmt::format("'{}' has no elements", values.name);
        return found;
    }
    found.type = isSquare ? expression::Type::matrix(static_cast<std::size_t>(columns))
                          : expression::Type::vector(count);
    if (measure.function == "sum" || measure.function == "mean") {
        found.components = sumsOf(values);
        if (measure.function == "mean")
            for (double& each : found.components) each /= static_cast<double>(values.size());
        return found;
    }
    const bool wantsLeast = measure.function == "least";
    found.components.assign(values.values.begin(),
                            values.values.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t i = 0; i < values.values.size(); ++i) {
        double& best = found.components[i % count];
        const double value = values.values[i];
        if (std::isnan(value) || (wantsLeast ? value < best : value > best)) best = value;
    }
    return found;
}

}  // namespace glibra::render
