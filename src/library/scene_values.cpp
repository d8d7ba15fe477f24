// The values of a loaded scene: what they are, what fits them, and how they are set.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glibra/scene.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "base/number.h"
#include "base/suggest.h"
#include "base/text.h"
#include "gpu/object/readback.h"
#include "library/renderer_state.h"
#include "plan/buffers.h"
#include "plan/overrides.h"
#include "render/consequences.h"
#include "render/load/device_buffers.h"
#include "render/load/device_textures.h"
#include "scene/textures.h"

namespace glibra {

namespace {

std::string typeOf(const render::Knob& knob) {
    if (!knob.words.empty()) return "choice";
    if (!knob.type.word.empty()) return knob.type.word;
    const std::size_t count = knob.initial.size();
    if (knob.type.base == plan::BaseType::boolean) return "bool";
    return count == 1 ? "float" : fmt::format("vec{}", count);
}

/// The numbers of the value's type in words, if the type has no such number; else empty.
std::string limitsBroken(const render::Knob& knob, double value) {
    const auto limits = [&](double least, double most) {
        return value >= least && value <= most ? std::string()
                                               : fmt::format("numbers from {:.0f} to {:.0f}", least, most);
    };
    if (!knob.words.empty()) return {};
    if (knob.type.base == plan::BaseType::integer)
        return limits(std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max());
    if (knob.type.base == plan::BaseType::unsignedInteger)
        return limits(0, std::numeric_limits<std::uint32_t>::max());
    if (knob.type.base == plan::BaseType::floating && std::isinf(base::toFloat(value)))
        return fmt::format("numbers up to {:.7g}, the largest of 32 bits", std::numeric_limits<float>::max());
    return {};
}

std::size_t elementsOf(const render::Knob& knob) {
    return knob.initial.size() / static_cast<std::size_t>(std::max(knob.type.components(), 1));
}

/// Takes the subscript away: "uColors[1]" becomes "uColors". Nothing if there is none.
std::optional<std::size_t> takeSubscript(std::string_view& name) {
    const std::size_t open = name.rfind('[');
    if (open == std::string_view::npos || !name.ends_with(']')) return std::nullopt;
    const std::string_view digits = name.substr(open + 1, name.size() - open - 2);
    std::size_t number = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (problem != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
    name = name.substr(0, open);
    return number;
}

/// What is wrong with these numbers for the value, or for one of so many parts of it; empty if nothing is.
std::string whyNot(const render::Knob& knob, std::string_view name, std::span<const double> values,
                   std::size_t parts) {
    const std::size_t wanted = knob.initial.size() / parts;
    if (values.size() != wanted)
        return fmt::format("'{}' takes {}, found {}", name, base::counted(wanted, "number"), values.size());
    for (const double each : values) {
        if (!std::isfinite(each)) return fmt::format("'{}': {} is not a finite number", knob.tag, each);
        if (!knob.words.empty() &&
            (each < 0 || each >= static_cast<double>(knob.words.size()) || each != std::floor(each)))
            return fmt::format("'{}': {} is not the number of a word, 0 to {}", knob.tag, each,
                               knob.words.size() - 1);
        if (knob.isInteger() && each != std::floor(each))
            return fmt::format("'{}' takes whole numbers, found {}", knob.tag, each);
        if (std::string limits = limitsBroken(knob, each); !limits.empty())
            return fmt::format("'{}' takes {}, found {}", knob.tag, limits, each);
        if (knob.type.base == plan::BaseType::boolean && each != 0 && each != 1)
            return fmt::format("'{}' is true (1) or false (0), found {}", knob.tag, each);
    }
    return {};
}

}  // namespace

/// With the values that have been set.
std::vector<render::Knob> Scene::State::knobs() const {
    std::vector<render::Knob> all = device.live->knobs();
    for (render::Knob& each : device.live->unsetKnobs()) all.push_back(std::move(each));
    for (const render::Knob& set : changed) {
        const auto same = std::ranges::find_if(all, [&](const render::Knob& each) {
            return each.tag == set.tag && each.program == set.program;
        });
        if (same == all.end()) {
            all.push_back(set);  // it is not unset any more
            continue;
        }
        same->current = set.current;
        same->initial = set.initial;  // a plan knows only the present value
    }
    std::ranges::stable_sort(all, {}, &render::Knob::program);
    return all;
}

std::vector<std::string> Scene::State::settings() const {
    std::vector<std::string> all;
    for (const render::Knob& each : changed)
        all.push_back(render::setArgument(device.live->scene(), each, device.live->knobs()));
    return all;
}

std::vector<Value> Scene::values() const {
    Result<std::vector<render::Knob>> knobs = State::guarded<std::vector<render::Knob>>(
        state_.get(), [&]() -> Result<std::vector<render::Knob>> { return state_->knobs(); });
    if (!knobs) return {};
    std::vector<Value> values;
    for (const render::Knob& knob : *knobs) {
        Value& to = values.emplace_back();
        to.name = knob.tag;
        if (knob.program) {
            const scene::Program& program = state_->device.live->scene().programs[knob.program];
            to.program = program.name;
            to.programLine = program.place.line;
        }
        to.type = typeOf(knob);
        to.value = knob.current;
        to.initial = knob.initial;
        to.hasRange = knob.form == glib::UniformForm::range;
        to.minimum = knob.minimum;
        to.maximum = knob.maximum;
        to.words = knob.words;
        to.place = knob.place;
    }
    return values;
}

Result<void> Scene::State::set(std::string_view name, std::span<const double> values, std::string_view text) {
    // A text is read as the command line reads it, which knows lines, programs, words and numbers.
    std::string_view tag = name;
    std::string program;
    if (const std::size_t colon = name.find(':'); colon != std::string_view::npos) {
        program = name.substr(0, colon);
        tag = name.substr(colon + 1);
    }
    const scene::Scene& scene = device.live->scene();
    std::vector<render::Knob> all = knobs();
    const auto isMeant = [&](const render::Knob& knob) {
        if (knob.tag == tag && program.empty()) return true;
        if (!knob.program) return false;
        const scene::Program& of = scene.programs[knob.program];
        if (knob.tag == tag && (of.name == program || std::to_string(of.place.line) == program)) return true;
        return program.empty() && tag == of.name + "." + knob.tag;
    };
    std::vector<render::Knob> meant;
    std::ranges::copy_if(all, std::back_inserter(meant), isMeant);
    std::optional<std::size_t> element;
    if (meant.empty()) element = takeSubscript(tag);
    if (element) {
        std::ranges::copy_if(all, std::back_inserter(meant), isMeant);
        std::erase_if(meant, [&](const render::Knob& each) { return *element >= elementsOf(each); });
    }
    if (meant.empty()) {
        std::vector<std::string_view> names;
        for (const render::Knob& each : all) names.push_back(each.tag);
        return diagnose("library-E02",
                        fmt::format("the scene has no value '{}'{}", name, base::suggestion(name, names)),
                        {path.generic_string(), 1, 1});
    }
    std::vector<double> read(values.begin(), values.end());
    if (values.empty()) {
        const auto& words = meant.front().words;
        if (const auto word = std::ranges::find(words, text); word != words.end()) {
            read = {static_cast<double>(word - words.begin())};
        } else {
            Result<plan::Override> parsed =
                plan::parseOverride(fmt::format("{}={}", meant.front().tag, text));
            if (!parsed || !parsed->word.empty())
                return diagnose("library-E03",
                                words.empty() ? fmt::format("'{}': expected numbers, found '{}'", tag, text)
                                              : fmt::format("'{}': expected one of {}, found '{}'", tag,
                                                            fmt::join(words, ", "), text),
                                {path.generic_string(), 1, 1});
            read = parsed->values;
        }
    }
    for (const render::Knob& each : meant)
        if (const std::string why = whyNot(each, name, read, element ? elementsOf(each) : 1); !why.empty())
            return diagnose("library-E03", why, each.place);
    for (render::Knob& each : meant) {
        if (!element) each.current = read;
        std::ranges::copy(
            read, each.current.begin() + static_cast<std::ptrdiff_t>(element.value_or(0) * read.size()));
        device.live->setValue(each);
        std::erase_if(changed, [&](const render::Knob& one) {
            return one.tag == each.tag && one.program == each.program;
        });
        changed.push_back(std::move(each));
    }
    return {};
}

Result<void> Scene::set(std::string_view name, double value) {
    return set(name, std::span<const double>(&value, 1));
}
Result<void> Scene::set(std::string_view name, int value) {
    return set(name, static_cast<double>(value));
}
Result<void> Scene::set(std::string_view name, bool value) {
    return set(name, value ? 1. : 0.);
}
Result<void> Scene::set(std::string_view name, std::initializer_list<double> values) {
    return set(name, std::span<const double>(values.begin(), values.size()));
}

Result<void> Scene::set(std::string_view name, std::span<const double> values) {
    if (values.empty()) return diagnose("library-E03", fmt::format("'{}': no numbers", name));
    return State::guarded<void>(state_.get(), [&] { return state_->set(name, values, {}); });
}

Result<void> Scene::set(std::string_view name, std::string_view text) {
    return State::guarded<void>(state_.get(), [&] { return state_->set(name, {}, text); });
}

// What a program writes into the textures and buffers of a loaded scene.

namespace {

using Column = BufferContent::Column;
using Shape = std::vector<std::size_t>;

std::string_view wordOf(gpu::TexelType type) {
    constexpr std::array<std::string_view, 7> kWords{"uint8", "uint16", "uint32", "int8",
                                                     "int16", "int32",  "float32"};
    return kWords.at(static_cast<std::size_t>(type));
}

std::string_view wordOf(const Column& column) {
    if (column.type == "float") return "float32";
    if (column.type == "double") return "float64";
    return column.type == "int" ? "int32" : "uint32";  // a bool has four bytes
}

std::size_t sizeOf(const Column& column) {
    return column.type == "double" ? sizeof(double) : sizeof(float);
}

/// "(64, 3)"
std::string shapeText(const Shape& shape) {
    return fmt::format("({}{})", fmt::join(shape, ", "), shape.size() == 1 ? "," : "");
}

/// "position (3 float32), age (float32)"
template <class Members, class Word>
std::string membersText(const Members& members, const Word& word) {
    std::string text;
    for (const auto& each : members)
        text += fmt::format("{}{} ({}{})", text.empty() ? "" : ", ", each.name,
                            each.count == 1 ? "" : fmt::format("{} ", each.count), word(each));
    return text;
}

/// What a program has given, for messages.
std::string foundText(const DataView& data) {
    const std::size_t count = data.bytes.size() / std::max<std::size_t>(1, data.record);
    std::string what = data.type;
    if (!data.fields.empty())
        what = "records of " + membersText(data.fields, [](const auto& each) { return each.type; });
    else if (what.empty())
        what = fmt::format("structures of {}", base::counted(data.record, "byte"));
    return data.shape.empty() ? fmt::format("{} x {}", count, what)
                              : fmt::format("{} of shape {}", what, shapeText(data.shape));
}

/// The sizes of the array that fills a texture, without the components.
Shape shapeOf(const gpu::Texture& texture) {
    const auto [width, height, depth] = texture.size();
    Shape shape;
    if (texture.shape() == gpu::TextureShape::texture3D || texture.layers() > 1 || isArray(texture.shape()))
        shape.push_back(static_cast<std::size_t>(texture.layers()));
    if (gpu::shapeOfLayer(texture.shape()) != gpu::TextureShape::texture1D)
        shape.push_back(static_cast<std::size_t>(height));
    shape.push_back(static_cast<std::size_t>(width));
    return shape;
}

/// The fields of records or numbers for these members, in their order; empty if they do not fit.
std::vector<DataView::Field> fieldsFor(const std::vector<Column>& columns, const DataView& data) {
    std::vector<DataView::Field> fields;
    std::size_t offset = 0;
    for (const Column& column : columns) {
        if (!data.fields.empty()) {
            const auto found = std::ranges::find(data.fields, column.name, &DataView::Field::name);
            if (found == data.fields.end() || found->type != wordOf(column) || found->count != column.count ||
                data.fields.size() != columns.size() ||
                found->offset + found->count * sizeOf(column) > data.record)
                return {};
            fields.push_back(*found);
        } else if (data.type == wordOf(column)) {
            fields.push_back({column.name, data.type, offset, column.count});
            offset += column.count * sizeOf(column);
        } else {
            return {};
        }
    }
    return fields;
}

/// The records as the device has them.
std::vector<std::byte> laidOut(const std::vector<Column>& columns, const std::vector<DataView::Field>& fields,
                               std::size_t record, std::size_t stride, std::span<const std::byte> from) {
    const std::size_t count = from.size() / record;
    std::vector<std::byte> to(count * stride);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const Column& column = columns[i];
        const std::size_t size = sizeOf(column);
        for (std::size_t element = 0; element < count; ++element) {
            const std::byte* source = from.data() + element * record + fields[i].offset;
            std::byte* target = to.data() + element * stride;
            if (column.stride == size) {
                std::memcpy(target + column.offset, source, size * column.count);
                continue;
            }
            for (const std::size_t offset : column.offsets) {
                std::memcpy(target + offset, source, size);
                source += size;
            }
        }
    }
    return to;
}

Diagnostic unusedHere(std::string_view kind, std::string_view name, const Place& place) {
    return diagnose(
        "library-E07",
        fmt::format("{} '{}' cannot be written: nothing that the picture needs uses it", kind, name), place);
}

}  // namespace

Result<void> Scene::State::writeTexture(const scene::TextureView& view, std::string_view name,
                                        const DataView& data) {
    const scene::Texture& declared = device.live->scene().textures[view.texture];
    const auto wrong = [&](const std::string& why) {
        return diagnose("library-E03", fmt::format("texture '{}' {}", declared.name, why), declared.place);
    };
    if (view.level || view.layer || view.isPrevious)
        return wrong(fmt::format("is written as a whole, not '{}'", name));
    const gpu::Texture* texture = device.live->texture(view.texture);
    if (texture == nullptr) return unusedHere("texture", name, declared.place);
    if (texture->samples() > 1) return wrong("has several samples for each texel, which are only drawn");
    if (data.first || data.isOfHead) return wrong("has neither elements nor a head");
    const base::TexelFormatRow& row = base::rowOf(texture->format());
    const gpu::TexelType type = render::numberTypeOf(row);
    const int components = hasDepth(row.format) ? 1 : row.components;
    const Shape plain = shapeOf(*texture);
    Shape whole = plain;
    whole.push_back(static_cast<std::size_t>(components));
    const std::size_t bytes =
        std::accumulate(whole.begin(), whole.end(), gpu::bytesOf(type), std::multiplies<>());
    const bool isTypeRight = data.type == wordOf(type) || (data.type.empty() && data.fields.empty());
    const bool isShapeRight =
        data.shape.empty() || data.shape == whole || (components == 1 && data.shape == plain);
    if (!isTypeRight || !isShapeRight || data.bytes.size() != bytes)
        return wrong(fmt::format("({}) takes {} of shape {}, found {}", row.name, wordOf(type),
                                 shapeText(components == 1 ? plain : whole), foundText(data)));
    Result<render::DeviceScene*> to = device.live->beginWrite(view.texture);
    if (!to) return std::move(to.diagnostics);
    // Volumes and cube maps have the rows of GL, all others those of pictures.
    const auto height = static_cast<std::size_t>(texture->size().height);
    const bool isTurned =
        height > 1 && !gpu::isCube(texture->shape()) && texture->shape() != gpu::TextureShape::texture3D;
    if (!isTurned) return (*to)->textures().write(view.texture, {data.bytes, components, type});
    std::vector<std::byte> rows(data.bytes.begin(), data.bytes.end());
    const std::size_t layer = plain.size() == 3 ? bytes / plain.front() : bytes;
    for (std::size_t at = 0; at < bytes; at += layer)
        gpu::flipRows(std::span(rows).subspan(at, layer), layer / height);
    return (*to)->textures().write(view.texture, {rows, components, type});
}

Result<void> Scene::State::writeBuffer(const scene::BufferView& view, std::string_view name,
                                       const DataView& data) {
    const scene::Buffer& declared = device.live->scene().buffers[view.buffer];
    const auto wrong = [&](const std::string& why) {
        return diagnose("library-E03", fmt::format("buffer '{}' {}", declared.name, why), declared.place);
    };
    if (view.isPrevious) return wrong(fmt::format("is written in both copies, not as '{}'", name));
    const plan::BufferLayout* layout = device.live->buffers().layout(view.buffer);
    if (layout == nullptr) return unusedHere("buffer", name, declared.place);
    const BufferContent content = describedContent(*layout, plan::tableOf(*layout));
    const bool isOfHead = data.isOfHead || content.stride == 0;
    if (isOfHead && (content.head.empty() || data.first)) return wrong("has no such members or elements");
    const std::vector<Column>& columns = isOfHead ? content.head : content.columns;
    const std::uint64_t elements = isOfHead ? 1 : content.elements;
    std::size_t numbers = 0, packed = 0, end = 0;
    for (const Column& each : columns) {
        numbers += each.count;
        packed += each.count * sizeOf(each);
        end = std::max(end, *std::ranges::max_element(each.offsets) + sizeOf(each));
    }
    const std::size_t stride = isOfHead ? end : content.stride;
    const bool isRaw = data.type.empty() && data.fields.empty();
    const std::size_t record = isRaw                 ? stride
                               : data.fields.empty() ? packed
                                                     : std::max<std::size_t>(1, data.record);
    const std::vector<DataView::Field> fields =
        isRaw ? std::vector<DataView::Field>() : fieldsFor(columns, data);
    const std::uint64_t count = data.bytes.size() / record, first = data.first.value_or(0);
    // The last size of an array of numbers is that of an element.
    Shape wanted{static_cast<std::size_t>(count)};
    if (!data.type.empty() && (numbers > 1 || data.shape.size() > 1)) wanted.push_back(numbers);
    const bool isShapeRight =
        data.shape.empty() || data.shape == wanted || (isOfHead && data.shape == Shape{numbers});
    const bool isTypeRight = isRaw ? data.record == stride || data.record == 1 : !fields.empty();
    if (!isShapeRight || !isTypeRight || data.bytes.size() != count * record || first > elements ||
        count > elements - first || (!data.first && count != elements))
        return wrong(fmt::format(
            "has {} of {}{}, found {}{}",
            isOfHead ? std::string("one record") : base::countedInGroups(elements, "element"),
            membersText(columns, [](const Column& each) { return wordOf(each); }),
            isRaw ? fmt::format(", in {}", base::counted(stride, "byte")) : std::string(), foundText(data),
            data.first ? fmt::format(" from element {} on", first) : std::string()));
    bool isAsOnDevice = isRaw || (record == stride && !isOfHead);
    for (std::size_t i = 0; i < fields.size(); ++i)
        isAsOnDevice = isAsOnDevice && fields[i].offset == columns[i].offset &&
                       (columns[i].count == 1 || columns[i].stride == sizeOf(columns[i]));
    const std::size_t at = isOfHead ? 0 : content.headBytes + static_cast<std::size_t>(first) * stride;
    Result<render::DeviceScene*> to = device.live->beginWrite(view.buffer);
    if (!to) return std::move(to.diagnostics);
    if (isAsOnDevice) return (*to)->buffers().write(view.buffer, at, data.bytes);
    return (*to)->buffers().write(view.buffer, at, laidOut(columns, fields, record, stride, data.bytes));
}

void Scene::State::applyStrict(Diagnostics& found) const {
    render::applyStrict(found, options.strict);
    const auto isUnwritten = [](const Diagnostic& each) {
        return each.id == "draw-W11" && !each.subject.empty();
    };
    std::erase_if(
        found, [&](const Diagnostic& each) { return isUnwritten(each) && written.contains(each.subject); });
    for (Diagnostic& each : found)
        if (isUnwritten(each)) each.severity = Severity::warning;
}

Result<void> Scene::State::write(std::string_view name, const DataView& data) {
    const Result<scene::ObjectView> object = scene::objectNamed(device.live->scene(), name);
    if (!object) return identified(object.diagnostics, "library-E02", path);
    const auto* texture = std::get_if<scene::TextureView>(&*object);
    Result<void> done = texture != nullptr ? writeTexture(*texture, name, data)
                                           : writeBuffer(std::get<scene::BufferView>(*object), name, data);
    if (done) written.emplace(name);
    return done;
}

Result<void> Scene::write(std::string_view name, const DataView& data) {
    return State::guarded<void>(state_.get(), [&] { return state_->write(name, data); });
}

}  // namespace glibra
