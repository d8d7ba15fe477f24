#pragma once
// Values as bytes, for the pipe between two processes. A structure names its members once, for writing and
// for reading, in its own namespace:
//
//     void eachMember(auto& packed, base::Is<Score> auto& of) { packed(of.flip, of.structure, of.effect); }
//
// Members are numbers, texts, paths, such structures, and pairs, lists, arrays, maps and optional values of
// them. Those of an enumeration, and numbers from 0 on, are named with the last value that is right:
// `packed.upTo(Severity::error, of.severity)`. What is read may come from a process that a scene has taken
// over.

#include <glibra/diagnostic.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <ranges>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/device_lost.h"
#include "base/utf8.h"

namespace glibra::base {

/// Type is Of, const or not.
template <class Type, class Of>
concept Is = std::same_as<std::remove_const_t<Type>, Of>;

/// `utf8`: each byte of a text that is no UTF-8 becomes U+FFFD.
enum class PackedText { asItIs, utf8 };

class Packer {
  public:
    explicit Packer(PackedText texts) : texts_(texts) {}
    void operator()(const auto&... values) { (write(values), ...); }
    void upTo(auto /*last*/, const auto& value) { write(static_cast<std::uint32_t>(value)); }
    [[nodiscard]] std::string take() { return std::move(bytes_); }

  private:
    template <class Value>
    void write(const Value& value) {
        if constexpr (std::is_arithmetic_v<Value>) {
            std::array<char, sizeof value> bytes{};
            std::memcpy(bytes.data(), &value, sizeof value);
            bytes_.append(bytes.data(), bytes.size());
        } else {
            eachMember(*this, value);
        }
    }
    void write(const std::string& text) {
        if (texts_ == PackedText::utf8 && !isUtf8(text)) return write(onlyUtf8(text));
        write(std::uint64_t{text.size()});
        bytes_ += text;
    }
    void write(const std::filesystem::path& path) { write(path.generic_string()); }
    template <class First, class Second>
    void write(const std::pair<First, Second>& pair) {
        (*this)(pair.first, pair.second);
    }
    template <class Value>
    void write(const std::optional<Value>& value) {
        write(value.has_value());
        if (value) write(*value);
    }
    template <class Value, std::size_t kCount>
    void write(const std::array<Value, kCount>& all) {
        for (const Value& each : all) write(each);
    }
    void write(const std::ranges::range auto& all) {
        write(std::uint64_t{all.size()});
        for (const auto& each : all) write(each);
    }

    PackedText texts_;
    std::string bytes_;
};

class Unpacker {
  public:
    explicit Unpacker(std::string_view bytes) : rest_(bytes) {}
    void operator()(auto&... values) { (read(values), ...); }
    template <class Value>
    void upTo(Value last, Value& value) {
        std::uint32_t number = 0;
        read(number);
        isWrong_ = isWrong_ || number > static_cast<std::uint32_t>(last);
        if (!isWrong_) value = static_cast<Value>(number);
    }
    /// False if the bytes are none that a Packer has written for these values.
    [[nodiscard]] bool isWhole() const { return !isWrong_ && rest_.empty(); }

  private:
    template <class Value>
    void read(Value& value) {
        if constexpr (std::same_as<Value, bool>) {
            std::uint8_t byte = 0;
            read(byte);
            value = byte != 0;
        } else if constexpr (std::is_arithmetic_v<Value>) {
            const std::string_view bytes = take(sizeof value);
            if (!isWrong_) std::memcpy(&value, bytes.data(), sizeof value);
        } else {
            eachMember(*this, value);
        }
    }
    void read(std::string& text) { text = take(count()); }
    void read(std::filesystem::path& path) {
        std::string text;
        read(text);
        path = text;
    }
    template <class First, class Second>
    void read(std::pair<First, Second>& pair) {
        (*this)(pair.first, pair.second);
    }
    template <class Value>
    void read(std::optional<Value>& value) {
        bool isGiven = false;
        read(isGiven);
        value.reset();
        if (isGiven) read(value.emplace());
    }
    template <class Value, std::size_t kCount>
    void read(std::array<Value, kCount>& all) {
        for (Value& each : all) read(each);
    }
    template <class Value>
    void read(std::vector<Value>& list) {
        list.clear();
        readAll<Value>([&](Value each) { list.push_back(std::move(each)); });
    }
    template <class Key, class Value>
    void read(std::map<Key, Value>& map) {
        map.clear();
        readAll<std::pair<Key, Value>>([&](std::pair<Key, Value> each) { map.insert(std::move(each)); });
    }
    template <class Value>
    void readAll(const auto& take) {
        for (std::size_t left = count(); left > 0 && !isWrong_; --left) {
            Value each{};
            read(each);
            if (!isWrong_) take(std::move(each));
        }
    }
    /// Of bytes, or of values, which have one byte at least.
    std::size_t count() {
        std::uint64_t value = 0;
        read(value);
        isWrong_ = isWrong_ || value > rest_.size();
        return isWrong_ ? 0 : static_cast<std::size_t>(value);
    }
    std::string_view take(std::size_t size) {
        isWrong_ = isWrong_ || size > rest_.size();
        if (isWrong_) return {};
        const std::string_view bytes = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return bytes;
    }

    std::string_view rest_;
    bool isWrong_ = false;
};

template <class Value>
std::string packed(const Value& value, PackedText texts = PackedText::asItIs) {
    Packer packer(texts);
    packer(value);
    return packer.take();
}
/// What packed() has written; nothing if it is something else.
template <class Value>
std::optional<Value> unpacked(std::string_view bytes) {
    std::optional<Value> value(std::in_place);
    Unpacker unpacker(bytes);  // NOLINT(misc-const-correctness): members differ by Value
    unpacker(*value);
    if (!unpacker.isWhole()) value.reset();
    return value;
}

void eachMember(auto& packed, Is<DeviceLost> auto& of) {
    packed.upTo(ResetCause::unknown, of.cause);
    packed(of.place, of.lastLine);
}

}  // namespace glibra::base

namespace glibra {

void eachMember(auto& packed, base::Is<Place> auto& of) {
    packed(of.file, of.line, of.column);
}
void eachMember(auto& packed, base::Is<Diagnostic> auto& of) {
    packed.upTo(Severity::error, of.severity);
    packed(of.id, of.text, of.place, of.subject, of.suggestion);
}

}  // namespace glibra
