#include "render/load/device_buffers.h"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>
#include <system_error>
#include <utility>

#include "base/text.h"
#include "image/file.h"
#include "plan/uniform_names.h"

namespace glibra::render {

BufferContent contentOf(const plan::BufferLayout& layout, const gpu::Buffer& buffer) {
    BufferContent content{layout, plan::tableOf(layout), std::vector<std::byte>(buffer.size())};
    buffer.read(0, content.bytes);
    return content;
}

namespace {

std::uint64_t sizeOfFile(const scene::FileReference& file) {
    if (file.content) return file.content->size();
    std::error_code failure;
    const std::uintmax_t bytes = file.path.empty() ? 0 : std::filesystem::file_size(file.path, failure);
    return failure ? 0 : bytes;
}

}  // namespace

Diagnostics DeviceBuffers::prepare(const plan::FramePlan& plan,
                                   std::span<const plan::FramePlan* const> others) {
    Diagnostics diagnostics;
    if (plan.buffers.empty()) return diagnostics;
    append(diagnostics, layouts_.add(scene_, plan, bytesLeft_, sizeOfFile, others));
    append(diagnostics, plan::reachProblems(scene_, plan, layouts_));
    for (const scene::BufferIndex each : plan.buffers)
        if (layouts_.find(each) != nullptr) append(diagnostics, make(each));
    return diagnostics;
}

static std::uint64_t declaredSize(const scene::Buffer& buffer) {
    return buffer.count ? *buffer.count : buffer.values.size();
}

bool DeviceBuffers::followSizes() {
    const auto hasOther = [&](const auto& each) {
        return each.second.declaredSize != declaredSize(scene_.buffers[each.first]);
    };
    bool isAny = false;
    for (auto each = made_.begin(); each != made_.end();) {
        if (!hasOther(*each)) {
            ++each;
            continue;
        }
        isAny = true;
        bytesLeft_ += each->second.charged;
        layouts_.forget(each->first);
        each = made_.erase(each);
    }
    return isAny;
}

Diagnostics DeviceBuffers::make(scene::BufferIndex index) {
    const scene::Buffer& buffer = scene_.buffers[index];
    const std::uint64_t bytes = std::max<std::uint64_t>(layouts_.find(index)->bytes, plan::kLeastBufferBytes);
    const auto known = made_.find(index);
    if (known != made_.end() && known->second.current.size() < bytes)
        if (Diagnostics failure = grow(known->second, bytes); hasError(failure)) return failure;
    if (known != made_.end() &&
        (states_[index].lasts || known->second.isGiven || known->second.values == buffer.values))
        return {};
    if (known != made_.end()) {
        known->second.declared.reset();
        Diagnostics problems = reset(index);
        if (!hasError(problems)) known->second.values = buffer.values;
        return problems;
    }
    const StageTimer timer(stats_, "upload");
    const std::uint64_t all = buffer.hasHistory ? 2 * bytes : bytes;
    if (all > bytesLeft_)
        return {diagnose("memory-E17",
                         fmt::format("buffer '{}' needs {}, but the buffers of a scene may have {} together, "
                                     "and {} are left",
                                     buffer.name, base::readableBytes(all), base::readableBytes(kMostBytes),
                                     base::readableBytes(bytesLeft_)),
                         buffer.place)};
    bytesLeft_ -= all;
    const Result<std::vector<std::byte>> content = declaredBytes(index);
    if (!content) return content.diagnostics;
    Result<gpu::Buffer> current = filled(bytes, *content);
    if (!current) return std::move(current.diagnostics);
    Made made{std::move(*current), {}, {}, false, buffer.values, declaredSize(buffer), all};
    if (buffer.hasHistory) {
        Result<gpu::Buffer> previous = filled(bytes, *content);
        if (!previous) return std::move(previous.diagnostics);
        made.previous = std::move(*previous);
    }
    made_.emplace(index, std::move(made));
    stats_.add("buffers", 1);
    stats_.add("bytes of buffers", all);
    return content.diagnostics;
}

Diagnostics DeviceBuffers::grow(Made& made, std::uint64_t bytes) {
    const auto lengthen = [&](gpu::Buffer& buffer) -> Diagnostics {
        Result<gpu::Buffer> longer = filled(bytes, {});
        if (!longer) return std::move(longer.diagnostics);
        longer->copyFrom(buffer, 0, 0, buffer.size());
        outgrown_.push_back(std::exchange(buffer, std::move(*longer)));
        return {};
    };
    if (!made.isGiven) made.declared.reset();
    Diagnostics diagnostics = lengthen(made.current);
    for (std::optional<gpu::Buffer>* each : {&made.previous, &made.declared})
        if (*each) append(diagnostics, lengthen(**each));
    return diagnostics;
}

Result<gpu::Buffer> DeviceBuffers::filled(std::size_t bytes, std::span<const std::byte> content) {
    Result<gpu::Buffer> buffer = gpu::Buffer::create(bytes, GL_DYNAMIC_COPY);
    if (!buffer) return buffer;
    if (content.size() < bytes) setZero(*buffer);
    buffer->update(0, content);
    return buffer;
}

Result<std::vector<std::byte>> DeviceBuffers::declaredBytes(scene::BufferIndex index) {
    const scene::Buffer& buffer = scene_.buffers[index];
    const plan::BufferLayout& layout = *layouts_.find(index);
    if (buffer.file) {
        const scene::FileReference& file = scene_.files[buffer.file];
        Diagnostics diagnostics = file.remarks;
        if (hasError(diagnostics)) return diagnostics;
        stats_.add("files read", 1);
        auto bytes = image::readFile(file.source(), {file.name, buffer.place}, layout.bytes);
        append(diagnostics, std::move(bytes.diagnostics));
        if (!bytes) return diagnostics;
        return {std::move(*bytes), std::move(diagnostics)};
    }
    Diagnostics problems = buffer.values.takeProblems();
    if (buffer.values.hasFailed()) return problems;
    const std::vector<double>& values = buffer.values.numbers();
    if (std::ranges::all_of(values, [](double each) { return each == 0; }))
        return {std::vector<std::byte>(), std::move(problems)};
    // The bytes up to the last value.
    const plan::MemoryNumber last = layout.pattern.at(values.size() - 1);
    const std::uint64_t used =
        std::min<std::uint64_t>(layout.bytes, last.offset + layout.pattern.stride + sizeOf(last.kind));
    std::vector<std::byte> content(used);
    writeNumbers(layout.pattern, 0, values, content);
    return {std::move(content), std::move(problems)};
}

const gpu::Buffer* DeviceBuffers::buffer(const scene::BufferView& view) const {
    const auto found = made_.find(view.buffer);
    if (found == made_.end()) return nullptr;
    if (!view.isPrevious) return &found->second.current;
    return found->second.previous ? &*found->second.previous : nullptr;
}

const plan::BufferLayout* DeviceBuffers::layout(scene::BufferIndex buffer) const {
    return made_.contains(buffer) ? layouts_.find(buffer) : nullptr;
}

std::vector<double> DeviceBuffers::read(const scene::BufferView& view, std::uint64_t first,
                                        std::uint64_t count) const {
    const gpu::Buffer* from = buffer(view);
    if (from == nullptr) return {};
    const plan::BufferLayout& layout = *layouts_.find(view.buffer);
    const std::uint64_t all = layout.pattern.numbers(layout.elements);
    count = std::min(count, all - std::min(first, all));
    if (count == 0) return {};
    std::uint64_t begin = from->size(), end = 0;
    for (std::uint64_t i = first; i < first + count; ++i) {
        const plan::MemoryNumber number = layout.pattern.at(i);
        begin = std::min(begin, number.offset);
        end = std::max(end, number.offset + sizeOf(number.kind));
    }
    std::vector<std::byte> bytes(end - begin);
    from->read(begin, bytes);
    std::vector<double> numbers(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        plan::MemoryNumber number = layout.pattern.at(first + i);
        number.offset -= begin;
        numbers[i] = plan::readNumber(number, bytes);
    }
    return numbers;
}

Diagnostics DeviceBuffers::reset(scene::BufferIndex index) {
    const auto found = made_.find(index);
    if (found == made_.end()) return {};
    Made& made = found->second;
    Diagnostics diagnostics;
    if (!made.declared) {
        const Result<std::vector<std::byte>> content = declaredBytes(index);
        append(diagnostics, content.diagnostics);
        if (!content) return diagnostics;
        if (content->empty()) {
            setZero(made.current);
            if (made.previous) setZero(*made.previous);
            return diagnostics;
        }
        Result<gpu::Buffer> declared = filled(made.current.size(), *content);
        append(diagnostics, std::move(declared.diagnostics));
        if (!declared) return diagnostics;
        made.declared = std::move(*declared);
    }
    made.current.copyFrom(*made.declared);
    if (made.previous) made.previous->copyFrom(*made.declared);
    return diagnostics;
}

Diagnostics DeviceBuffers::write(scene::BufferIndex index, std::size_t offset,
                                 std::span<const std::byte> bytes) {
    Made& made = made_.at(index);
    if (states_[index].isWritten && !made.declared) {
        const Result<std::vector<std::byte>> content = declaredBytes(index);
        if (!content) return content.diagnostics;
        Result<gpu::Buffer> declared = filled(made.current.size(), *content);
        if (!declared) return std::move(declared.diagnostics);
        made.declared = std::move(*declared);
    }
    made.isGiven = true;
    made.current.update(offset, bytes);
    for (std::optional<gpu::Buffer>* each : {&made.previous, &made.declared})
        if (*each) (*each)->update(offset, bytes);
    return {};
}

Diagnostics DeviceBuffers::giveWritten(DeviceBuffers& copy) const {
    Diagnostics problems;
    for (const auto& [index, made] : made_) {
        if (!made.isGiven || !copy.made_.contains(index)) continue;
        const gpu::Buffer& from = made.declared ? *made.declared : made.current;
        std::vector<std::byte> bytes(from.size());
        from.read(0, bytes);
        append(problems, copy.write(index, 0, bytes));
    }
    return problems;
}

Diagnostics DeviceBuffers::keepGiven(scene::BufferIndex index) {
    const auto found = made_.find(index);
    if (found == made_.end() || !found->second.isGiven || found->second.declared) return {};
    Made& made = found->second;
    Result<gpu::Buffer> kept = gpu::Buffer::create(made.current.size(), GL_DYNAMIC_COPY);
    if (!kept) return std::move(kept.diagnostics);
    kept->copyFrom(made.current);
    made.declared = std::move(*kept);
    return {};
}

void DeviceBuffers::takeOver(DeviceBuffers& previous, scene::BufferIndex buffer) {
    const auto found = previous.made_.find(buffer);
    const auto own = made_.find(buffer);
    if (found == previous.made_.end() || own == made_.end()) return;
    const std::uint64_t bytes = own->second.current.size();
    found->second.declaredSize = own->second.declaredSize;
    found->second.charged = own->second.charged;
    own->second = std::move(found->second);
    if (own->second.current.size() < bytes) grow(own->second, bytes);
    previous.made_.erase(found);
}

void DeviceBuffers::clear(scene::BufferIndex buffer) {
    if (const auto found = made_.find(buffer); found != made_.end()) setZero(found->second.current);
}

void DeviceBuffers::exchange(scene::BufferIndex buffer, bool keepsContent) {
    const auto found = made_.find(buffer);
    if (found == made_.end() || !found->second.previous) return;
    std::swap(found->second.current, *found->second.previous);
    if (!keepsContent) return;
    found->second.current.copyFrom(*found->second.previous);
    stats_.add("histories copied", 1);
    stats_.add("bytes copied", found->second.current.size());
}

// Buffers that samplers and images read as textures (language, 12.7).

void DeviceBuffers::bind(const plan::TextureUse& use, gpu::BindingTracker& bindings) {
    const gpu::Buffer* buffer = this->buffer(use.buffer);
    if (buffer == nullptr) return;
    const gpu::BufferTexture& texture =
        textures_[{use.buffer.buffer, use.buffer.isPrevious, use.bufferFormat}];
    // The buffer is attached anew each time, since those with history change their places.
    if (!use.isImage) return texture.bind(use.driverUnit, *buffer, use.bufferFormat);
    texture.bindImage(use.driverUnit, *buffer, use.bufferFormat, use.imageFormat.value_or(use.bufferFormat));
    bindings.forgetImages();
}

Diagnostics DeviceBuffers::checkTexels(const plan::FramePlan& plan) const {
    Diagnostics problems;
    std::set<scene::BufferIndex> reported;
    const auto most = static_cast<std::uint64_t>(context_.capabilities().maxBufferTexels);
    const auto check = [&](plan::PlannedProgramIndex program, const std::vector<plan::TextureUse>& uses) {
        for (const plan::TextureUse& each : uses) {
            const gpu::Buffer* buffer = each.buffer.buffer ? this->buffer(each.buffer) : nullptr;
            if (buffer == nullptr) continue;
            const std::uint64_t texels = buffer->size() / base::bytesPerTexel(each.bufferFormat);
            if (texels <= most || !reported.insert(each.buffer.buffer).second) continue;
            const scene::Buffer& declared = scene_.buffers[each.buffer.buffer];
            const base::ActiveUniform& uniform = at(plan.programs[program].interface->uniforms, each.uniform);
            problems.push_back(
                diagnose("memory-E17",
                         fmt::format("buffer '{}' has {} texels for {} '{}'; this driver allows {}",
                                     declared.name, base::groupedText(texels), uniform.type.word,
                                     uniform.name, base::groupedText(most)),
                         declared.place));
        }
    };
    plan.visitDraws(
        [&](const plan::PlannedDraw& each, const auto&...) { check(each.program, each.textures); });
    for (const plan::PlannedDispatch& each : plan.dispatches) check(each.program, each.textures);
    return problems;
}

}  // namespace glibra::render
