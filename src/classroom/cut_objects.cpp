#include "classroom/cut_objects.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <utility>

namespace glibra::classroom {
namespace {

constexpr float kBackground = 6.0F / 255;

float component(const image::Image& image, const std::byte* at) {
    switch (image.type) {
        case image::Component::u8:
            return static_cast<float>(std::to_integer<int>(*at)) / 255;
        case image::Component::u16: {
            std::uint16_t value = 0;
            std::memcpy(&value, at, sizeof value);
            return static_cast<float>(value) / 65535;
        }
        case image::Component::f32:
            break;
    }
    float value = 0;
    std::memcpy(&value, at, sizeof value);
    return std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 0;
}

struct Box {
    int left, top, right = -1, bottom = -1;
};

/// The box around the pixels of objects.
Box boxOf(const Colors& colors, const std::vector<char>& isObject) {
    Box box{colors.width, colors.height};
    for (int y = 0; y < colors.height; ++y)
        for (int x = 0; x < colors.width; ++x) {
            if (isObject[colors.index(x, y)] == 0) continue;
            box.left = std::min(box.left, x);
            box.right = std::max(box.right, x);
            box.top = std::min(box.top, y);
            box.bottom = std::max(box.bottom, y);
        }
    return box;
}

/// Calls visit(x, y) for the pixels at the border; twice for those in the corners.
void visitBorder(const Colors& colors, const auto& visit) {
    for (int x = 0; x < colors.width; ++x) {
        visit(x, 0);
        visit(x, colors.height - 1);
    }
    for (int y = 0; y < colors.height; ++y) {
        visit(0, y);
        visit(colors.width - 1, y);
    }
}

/// Adds gaps between parts of an object: pixels between two of its pixels in the row and in the column that
/// are near to each other. A shader that discards its dots leaves such.
void closeGaps(const Colors& colors, std::vector<char>& isObject) {
    const Box box = boxOf(colors, isObject);
    const int nearby = std::max(box.right - box.left, box.bottom - box.top) * 3 / 10;
    std::vector<char> between(isObject.size(), 0);
    const auto scan = [&](int lines, int length, const auto& index) {
        for (int line = 0; line < lines; ++line) {
            int last = -1;
            for (int i = 0; i < length; ++i) {
                if (isObject[index(line, i)] == 0) continue;
                if (last >= 0 && i - last <= nearby)
                    for (int gap = last + 1; gap < i; ++gap) ++between[index(line, gap)];
                last = i;
            }
        }
    };
    scan(colors.height, colors.width, [&](int line, int i) { return colors.index(i, line); });
    scan(colors.width, colors.height, [&](int line, int i) { return colors.index(line, i); });
    for (std::size_t i = 0; i < isObject.size(); ++i)
        if (between[i] == 2) isObject[i] = 1;
}

/// 1 for each pixel that cannot be reached from the border over pixels of the background: a dot in the colour
/// of the background belongs to the object that is around it.
std::vector<char> objectPixels(const Colors& colors, const Color& background) {
    std::vector<char> isObject(colors.at.size(), 1);
    std::vector<std::pair<int, int>> open;
    const auto reach = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= colors.width || y >= colors.height) return;
        char& pixel = isObject[colors.index(x, y)];
        if (pixel == 0 || colorDistance(colors.pixel(x, y), background) > kBackground) return;
        pixel = 0;
        open.emplace_back(x, y);
    };
    visitBorder(colors, reach);
    while (!open.empty()) {
        const auto [x, y] = open.back();
        open.pop_back();
        reach(x + 1, y);
        reach(x - 1, y);
        reach(x, y + 1);
        reach(x, y - 1);
    }
    closeGaps(colors, isObject);
    return isObject;
}

/// The same in kSide pixels, by linear interpolation.
Scale enlarged(const Scale& from) {
    Scale made{kSide, {}, {}};
    const float step = static_cast<float>(from.side) / kSide;
    const auto last = static_cast<float>(from.side - 1);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const float u = std::clamp((static_cast<float>(x) + 0.5F) * step - 0.5F, 0.0F, last);
            const float v = std::clamp((static_cast<float>(y) + 0.5F) * step - 0.5F, 0.0F, last);
            const int left = std::min(static_cast<int>(u), from.side - 2);
            const int top = std::min(static_cast<int>(v), from.side - 2);
            const float a = u - static_cast<float>(left), b = v - static_cast<float>(top);
            Color sum{};
            float inside = 0;
            for (int i = 0; i < 4; ++i) {
                const std::size_t at = from.index(left + i % 2, top + i / 2);
                const float weight = (i % 2 == 1 ? a : 1 - a) * (i / 2 == 1 ? b : 1 - b);
                for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * from.colors[at][k];
                inside += weight * from.inside[at];
            }
            made.colors.push_back(sum);
            made.inside.push_back(inside);
        }
    return made;
}

}  // namespace

Colors colorsOf(const image::Image& image) {
    Colors colors{image.width, image.height, {}};
    colors.at.reserve(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    const std::size_t bytes = image::bytesOf(image.type);
    for (int y = 0; y < image.height; ++y) {
        const std::byte* at = image.row(y).data();
        for (int x = 0; x < image.width; ++x, at += bytes * static_cast<std::size_t>(image.components)) {
            Color color{};
            for (std::size_t i = 0; i < 3; ++i)
                color[i] = component(image, at + (image.components < 3 ? 0 : i) * bytes);
            colors.at.push_back(color);
        }
    }
    return colors;
}

float colorDistance(const Color& a, const Color& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

Color backgroundOf(const Colors& colors) {
    std::map<std::array<int, 3>, std::pair<int, Color>> counts;
    visitBorder(colors, [&](int x, int y) {
        const Color& color = colors.pixel(x, y);
        std::array<int, 3> key{};
        for (std::size_t i = 0; i < 3; ++i) key[i] = static_cast<int>(color[i] * 63.5F);
        auto& [number, first] = counts[key];
        if (number++ == 0) first = color;
    });
    return std::ranges::max_element(
               counts, [](const auto& a, const auto& b) { return a.second.first < b.second.first; })
        ->second.second;
}

std::optional<Objects> findObjects(const Colors& colors) {
    if (colors.width < 2 || colors.height < 2) return std::nullopt;
    Objects found;
    found.background = backgroundOf(colors);
    found.isObject = objectPixels(colors, found.background);
    const Box box = boxOf(colors, found.isObject);
    if (box.right < box.left) return std::nullopt;
    found.left = box.left;
    found.top = box.top;
    found.right = box.right;
    found.bottom = box.bottom;
    return found;
}

Objects closer(const Colors& colors, const Objects& objects) {
    constexpr int kSteps = 8;
    const int side = std::max(objects.longerSide() / 2, 1);
    // A side that is shorter than the square stands in its middle.
    const auto placed = [&](int begin, int end, int step) {
        const int spare = end - begin + 1 - side;
        return begin + (spare > 0 ? spare * step / kSteps : spare / 2);
    };
    Objects best = objects;
    double most = -1;
    for (int i = 0; i <= kSteps; ++i)
        for (int k = 0; k <= kSteps; ++k) {
            const int left = placed(objects.left, objects.right, i);
            const int top = placed(objects.top, objects.bottom, k);
            double shown = 0;
            for (int y = std::max(top, 0); y < std::min(top + side, colors.height); ++y)
                for (int x = std::max(left, 0); x < std::min(left + side, colors.width); ++x)
                    shown += objects.isObject[colors.index(x, y)];
            shown -= 0.02 * side * side * std::hypot(i - kSteps / 2, k - kSteps / 2) / kSteps;
            if (shown <= most) continue;
            most = shown;
            best.left = left;
            best.top = top;
            best.right = left + side - 1;
            best.bottom = top + side - 1;
        }
    return best;
}

Scale cutOut(const Colors& colors, const Objects& objects, int detail) {
    const double width = objects.right - objects.left + 1, height = objects.bottom - objects.top + 1;
    const double step = std::max(width, height) / detail;
    const double x0 = objects.left + width / 2 - step * detail / 2;
    const double y0 = objects.top + height / 2 - step * detail / 2;
    Scale coarse{detail, {}, {}};
    for (int y = 0; y < detail; ++y)
        for (int x = 0; x < detail; ++x) {
            // The mean of the pixels whose centres are in the cell; of the nearest one if there is none.
            Color sum{};
            float inside = 0;
            int count = 0;
            const auto first = [](double from) { return static_cast<int>(std::ceil(from - 0.5)); };
            int beginX = first(x0 + x * step), endX = first(x0 + (x + 1) * step);
            int beginY = first(y0 + y * step), endY = first(y0 + (y + 1) * step);
            if (beginX == endX) endX = (beginX = static_cast<int>(std::floor(x0 + (x + 0.5) * step))) + 1;
            if (beginY == endY) endY = (beginY = static_cast<int>(std::floor(y0 + (y + 0.5) * step))) + 1;
            for (int v = std::max(beginY, 0); v < std::min(endY, colors.height); ++v)
                for (int u = std::max(beginX, 0); u < std::min(endX, colors.width); ++u) {
                    const Color& color = colors.pixel(u, v);
                    for (std::size_t i = 0; i < 3; ++i) sum[i] += color[i];
                    inside += objects.isObject[colors.index(u, v)];
                    ++count;
                }
            if (count > 0)
                for (float& each : sum) each /= static_cast<float>(count);
            coarse.colors.push_back(count > 0 ? sum : objects.background);
            coarse.inside.push_back(count > 0 ? inside / static_cast<float>(count) : 0);
        }
    return detail == kSide ? coarse : enlarged(coarse);
}

}  // namespace glibra::classroom
