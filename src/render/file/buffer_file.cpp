#include "render/file/buffer_file.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

#include "base/text.h"
#include "glib/text.h"

namespace glibra::render {
namespace {

using plan::BufferField;
using plan::MemoryNumber;
using plan::NumberKind;

/// The numbers of a record, by field.
class Records {
  public:
    explicit Records(const BufferContent& content)
        : content_(content), count_(content.layout.pattern.element.empty() ? 1 : content.layout.elements) {}

    [[nodiscard]] std::uint64_t count() const { return count_; }
    /// The number as it lies in memory; of the record, where it is not part of the head.
    [[nodiscard]] std::span<const std::byte> bytesOf(const BufferField& field, MemoryNumber number,
                                                     std::uint64_t record) const {
        const plan::MemoryPattern& pattern = content_.layout.pattern;
        const std::uint64_t from = field.isOfElement ? pattern.elementsAt + record * pattern.stride : 0;
        return std::span(content_.bytes).subspan(from + number.offset, sizeOf(number.kind));
    }

  private:
    const BufferContent& content_;
    std::uint64_t count_;
};

template <class T>
T as(std::span<const std::byte> bytes) {
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

void addText(fmt::memory_buffer& text, NumberKind kind, std::span<const std::byte> bytes) {
    const auto add = [&](auto value) { fmt::format_to(std::back_inserter(text), "{}", value); };
    switch (kind) {
        case NumberKind::floating:
            return add(as<float>(bytes));
        case NumberKind::doublePrecision:
            return add(as<double>(bytes));
        case NumberKind::integer:
            return add(as<std::int32_t>(bytes));
        case NumberKind::unsignedInteger:
            return add(as<std::uint32_t>(bytes));
        case NumberKind::boolean:
            return add(as<std::uint32_t>(bytes) != 0 ? 1 : 0);
    }
}

std::string csvOf(const std::vector<BufferField>& fields, const Records& records) {
    fmt::memory_buffer text;
    const auto end = std::back_inserter(text);
    bool isFirst = true;
    for (const BufferField& each : fields)
        for (std::size_t i = 0; i < each.numbers.size(); ++i) {
            constexpr std::string_view kNames = "xyzw";
            const std::size_t count = each.numbers.size();
            const std::string part = count == 1               ? ""
                                     : count <= kNames.size() ? fmt::format(".{}", kNames[i])
                                                              : fmt::format("[{}]", i);
            fmt::format_to(end, "{}{}", isFirst ? "" : ",", base::csvField(each.name + part));
            isFirst = false;
        }
    text.push_back('\n');
    for (std::uint64_t record = 0; record < records.count(); ++record) {
        isFirst = true;
        for (const BufferField& each : fields)
            for (const MemoryNumber& number : each.numbers) {
                if (!isFirst) text.push_back(',');
                isFirst = false;
                addText(text, number.kind, records.bytesOf(each, number, record));
            }
        text.push_back('\n');
    }
    return fmt::to_string(text);
}

/// NumPy's name of a type of this machine, which is little-endian or not.
std::string numpyType(NumberKind kind) {
    const std::uint16_t one = 1;
    const char order = as<std::uint8_t>(std::as_bytes(std::span(&one, 1))) == 1 ? '<' : '>';
    switch (kind) {
        case NumberKind::floating:
            return fmt::format("{}f4", order);
        case NumberKind::doublePrecision:
            return fmt::format("{}f8", order);
        case NumberKind::integer:
            return fmt::format("{}i4", order);
        case NumberKind::unsignedInteger:
            return fmt::format("{}u4", order);
        case NumberKind::boolean:
            break;
    }
    return "|b1";
}

std::string npyOf(const std::vector<BufferField>& fields, const Records& records) {
    std::string types;
    for (const BufferField& each : fields) {
        std::string name;
        for (const char c : each.name) name += c == '\'' || c == '\\' ? std::string{'\\', c} : std::string{c};
        const std::string shape = each.numbers.size() > 1 ? fmt::format(", ({},)", each.numbers.size()) : "";
        types += fmt::format("('{}', '{}'{}), ", name, numpyType(each.numbers.front().kind), shape);
    }
    std::string header =
        fmt::format("{{'descr': [{}], 'fortran_order': False, 'shape': ({},), }}", types, records.count());
    // The data begins at a multiple of 64 bytes; the header ends with a line end.
    const bool isLong = header.size() + 65 > 0xffff;
    const std::size_t before = isLong ? 12 : 10;
    header.append(63 - (before + header.size()) % 64, ' ');
    header += '\n';
    std::string file = "\x93NUMPY";
    file += isLong ? '\2' : '\1';
    file += '\0';
    for (std::size_t i = 0; i < before - 8; ++i) file += static_cast<char>(header.size() >> 8 * i & 0xffU);
    file += header;
    for (std::uint64_t record = 0; record < records.count(); ++record)
        for (const BufferField& each : fields)
            for (const MemoryNumber& number : each.numbers) {
                const std::span<const std::byte> bytes = records.bytesOf(each, number, record);
                if (number.kind == NumberKind::boolean)
                    file += as<std::uint32_t>(bytes) != 0 ? '\1' : '\0';
                else
                    file.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
            }
    return file;
}

std::string suffixOf(const std::filesystem::path& file) {
    return glib::lower(file.extension().generic_string());
}

}  // namespace

bool isTableFile(const std::filesystem::path& file) {
    const std::string suffix = suffixOf(file);
    return suffix == ".csv" || suffix == ".npy";
}

Diagnostics writeBuffer(const BufferContent& content, const std::filesystem::path& file,
                        image::NamedBy named) {
    if (!isTableFile(file)) return {image::cannotWrite(file, "buffers are written as .csv or .npy")};
    const std::vector<BufferField> fields = plan::fieldsOf(content.table, content.layout.pattern);
    const Records records(content);
    const std::string text = suffixOf(file) == ".csv" ? csvOf(fields, records) : npyOf(fields, records);
    return image::writeFileAtomically(file, std::as_bytes(std::span(text)), named);
}

}  // namespace glibra::render
