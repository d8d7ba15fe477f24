#pragma once
// OpenEXR files without compression, byte by byte ("OpenEXR File Layout").

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "support.h"

namespace glibra::image::testing {

struct ExrMaker {
    struct Window {
        int left, top, right, bottom;
        [[nodiscard]] int width() const { return right - left + 1; }
        [[nodiscard]] int height() const { return bottom - top + 1; }
    };
    enum class Type { whole, half, floating };
    struct Channel {
        std::string name;
        Type type = Type::floating;
    };

    Window data{0, 0, 1, 1};
    Window display{0, 0, 1, 1};
    std::vector<Channel> channels{{"B"}, {"G"}, {"R"}};  ///< in alphabetical order
    int tile = 0;                                        ///< side of the tiles; 0: lines
    bool decreasing = false;                             ///< the lines stand from the bottom up
    std::string partType{};                              ///< not empty: a file of several parts
    /// The value of a channel at a place of the data window. Halves hold whole numbers up to 2048.
    std::function<double(const std::string& channel, int x, int y)> value =
        [](const std::string& channel, int x, int y) { return channel.back() + 100 * x + 10 * y; };

    [[nodiscard]] std::vector<std::byte> file() const { return fileOf({*this}); }

    /// A file of several parts, or of one.
    static std::vector<std::byte> fileOf(const std::vector<ExrMaker>& parts) {
        const bool several = parts.size() > 1 || !parts[0].partType.empty();
        std::vector<std::byte> to;
        putLittle(to, 20000630, 4);
        putLittle(to, 2 | (several ? 0x1000U : 0) | (!several && parts[0].tile > 0 ? 0x200U : 0), 4);
        for (std::size_t i = 0; i < parts.size(); ++i) parts[i].putHeader(to, several, i);
        if (several) to.push_back({});
        std::vector<std::vector<std::byte>> chunks;
        std::vector<std::size_t> counts;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto own = parts[i].chunksOf(several ? static_cast<int>(i) : -1);
            counts.push_back(own.size());
            chunks.insert(chunks.end(), own.begin(), own.end());
        }
        std::size_t at = to.size() + 8 * chunks.size();
        for (const auto& each : chunks) {
            putLittle(to, static_cast<std::uint32_t>(at), 4);
            putLittle(to, 0, 4);
            at += each.size();
        }
        for (const auto& each : chunks) to.insert(to.end(), each.begin(), each.end());
        return to;
    }

  private:
    static void putText(std::vector<std::byte>& to, const std::string& text) {
        for (const char each : text) to.push_back(static_cast<std::byte>(each));
        to.push_back({});
    }
    static void putAttribute(std::vector<std::byte>& to, const std::string& name, const std::string& type,
                             const std::vector<std::byte>& value) {
        putText(to, name);
        putText(to, type);
        putLittle(to, static_cast<std::uint32_t>(value.size()), 4);
        to.insert(to.end(), value.begin(), value.end());
    }
    static std::vector<std::byte> numbers(const std::vector<int>& values) {
        std::vector<std::byte> bytes;
        for (const int each : values) putLittle(bytes, static_cast<std::uint32_t>(each), 4);
        return bytes;
    }
    static std::vector<std::byte> text(const std::string& word) {
        std::vector<std::byte> bytes;
        putText(bytes, word);
        bytes.pop_back();
        return bytes;
    }
    [[nodiscard]] int chunkCount() const {
        if (tile == 0) return data.height();
        return ((data.width() + tile - 1) / tile) * ((data.height() + tile - 1) / tile);
    }

    void putHeader(std::vector<std::byte>& to, bool several, std::size_t number) const {
        std::vector<std::byte> list;
        for (const Channel& each : channels) {
            putText(list, each.name);
            for (const int field : {static_cast<int>(each.type), 0, 1, 1})
                putLittle(list, static_cast<std::uint32_t>(field), 4);
        }
        list.push_back({});
        constexpr int kOne = 0x3f800000;
        putAttribute(to, "channels", "chlist", list);
        putAttribute(to, "compression", "compression", {std::byte{0}});
        putAttribute(to, "dataWindow", "box2i", numbers({data.left, data.top, data.right, data.bottom}));
        putAttribute(to, "displayWindow", "box2i",
                     numbers({display.left, display.top, display.right, display.bottom}));
        putAttribute(to, "lineOrder", "lineOrder", {std::byte{decreasing}});
        putAttribute(to, "pixelAspectRatio", "float", numbers({kOne}));
        putAttribute(to, "screenWindowCenter", "v2f", numbers({0, 0}));
        putAttribute(to, "screenWindowWidth", "float", numbers({kOne}));
        if (tile > 0) {
            auto tiles = numbers({tile, tile});
            tiles.push_back({});
            putAttribute(to, "tiles", "tiledesc", tiles);
        }
        if (several) {
            putAttribute(to, "name", "string", text("part" + std::to_string(number)));
            putAttribute(to, "type", "string",
                         text(!partType.empty() ? partType
                              : tile > 0        ? "tiledimage"
                                                : "scanlineimage"));
            putAttribute(to, "chunkCount", "int", numbers({chunkCount()}));
        }
        to.push_back({});
    }

    static void putValue(std::vector<std::byte>& to, Type type, double value) {
        if (type == Type::whole) return putLittle(to, static_cast<std::uint32_t>(value), 4);
        const auto number = static_cast<float>(value);
        std::uint32_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        if (type == Type::floating) return putLittle(to, bits, 4);
        const std::uint32_t half =
            number == 0 ? 0
                        : (((bits >> 23U & 255U) - 112) << 10U | (bits >> 13U & 1023U) | bits >> 31U << 15U);
        putLittle(to, half, 2);
    }

    /// Of one row or the row of a tile: channel by channel.
    void putRow(std::vector<std::byte>& to, int left, int right, int y) const {
        for (const Channel& each : channels)
            for (int x = left; x <= right; ++x) putValue(to, each.type, value(each.name, x, y));
    }

    [[nodiscard]] std::vector<std::vector<std::byte>> chunksOf(int part) const {
        std::vector<std::vector<std::byte>> chunks;
        const auto add = [&](const std::vector<int>& place, const std::vector<std::byte>& pixels) {
            std::vector<std::byte> chunk;
            if (part >= 0) putLittle(chunk, static_cast<std::uint32_t>(part), 4);
            for (const int each : place) putLittle(chunk, static_cast<std::uint32_t>(each), 4);
            putLittle(chunk, static_cast<std::uint32_t>(pixels.size()), 4);
            chunk.insert(chunk.end(), pixels.begin(), pixels.end());
            chunks.push_back(std::move(chunk));
        };
        if (tile == 0) {
            for (int y = data.top; y <= data.bottom; ++y) {
                std::vector<std::byte> pixels;
                putRow(pixels, data.left, data.right, y);
                add({y}, pixels);
            }
            return chunks;
        }
        for (int top = 0; top < data.height(); top += tile)
            for (int left = 0; left < data.width(); left += tile) {
                std::vector<std::byte> pixels;
                for (int y = top; y < std::min(top + tile, data.height()); ++y)
                    putRow(pixels, data.left + left, data.left + std::min(left + tile, data.width()) - 1,
                           data.top + y);
                add({left / tile, top / tile, 0, 0}, pixels);
            }
        return chunks;
    }
};

}  // namespace glibra::image::testing
