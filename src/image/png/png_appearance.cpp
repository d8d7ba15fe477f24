#include "image/png/png_appearance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "image/bytes.h"
#include "image/png/png_chunks.h"

namespace glibra::image {
namespace {

using Content = std::span<const std::byte>;

/// True if the numbers of 32 bits are these, up to rounding.
template <std::size_t Count>
bool holds(Content content, const std::array<std::uint32_t, Count>& numbers) {
    constexpr std::int64_t kRounding = 20;  // of 100,000
    if (content.size() != 4 * Count) return false;
    for (std::size_t i = 0; i < Count; ++i)
        if (std::abs(std::int64_t{big32(content, 4 * i)} - std::int64_t{numbers[i]}) > kRounding)
            return false;
    return true;
}

/// Gamma and primaries of sRGB (PNG specification, third edition, 11.3.2.5).
bool isGammaOfSrgb(Content content) {
    return holds<1>(content, {45455});
}
bool arePrimariesOfSrgb(Content content) {
    return holds<8>(content, {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000});
}
bool areSquare(Content content) {
    return content.size() == 9 && big32(content, 0) == big32(content, 4);
}
bool always(Content) {
    return true;
}

/// Chunks that change nothing, if their content is as it should be.
struct HarmlessRow {
    std::string_view type;
    bool (*isHarmless)(Content);
    bool isOnce = false;  ///< there is one of them, before the pixels
};
constexpr std::array kHarmless{
    HarmlessRow{"PLTE", always, true},  HarmlessRow{"tRNS", always, true},
    HarmlessRow{"tEXt", always},        HarmlessRow{"zTXt", always},
    HarmlessRow{"iTXt", always},        HarmlessRow{"tIME", always},
    HarmlessRow{"sBIT", always},        HarmlessRow{"sRGB", always},
    HarmlessRow{"gAMA", isGammaOfSrgb}, HarmlessRow{"cHRM", arePrimariesOfSrgb},
    HarmlessRow{"pHYs", areSquare},     HarmlessRow{"hIST", always},
};

/// What the others do.
using Meaning = std::pair<std::string_view, const char*>;
constexpr std::array kMeanings{
    Meaning{"acTL", "it is an animation"},
    Meaning{"fcTL", "it has frames of an animation"},
    Meaning{"fdAT", "it has frames of an animation"},
    Meaning{"iCCP", "it has a colour profile"},
    Meaning{"cICP", "it has another colour space"},
    Meaning{"gAMA", "it has another gamma than sRGB"},
    Meaning{"cHRM", "it has other primaries than sRGB"},
    Meaning{"mDCv", "it is meant for a screen of high dynamic range"},
    Meaning{"cLLi", "it is meant for a screen of high dynamic range"},
    Meaning{"eXIf", "it may say that it is to be turned"},
    Meaning{"bKGD", "it has a background colour"},
    Meaning{"pHYs", "its pixels are not square"},
};

}  // namespace

std::string shownOtherwise(std::span<const std::byte> file) {
    const auto chunks = pngChunks(file);
    if (!chunks)
        return "it is not one whole PNG picture: a checksum is wrong, its chunks are out of order, or "
               "something follows its end";
    std::vector<std::string_view> before;
    for (const PngChunk& each : chunks->others) {
        const auto* const row = std::ranges::find(kHarmless, each.type, &HarmlessRow::type);
        if (row == kHarmless.end() || !row->isHarmless(each.content)) {
            const auto* const known = std::ranges::find(kMeanings, each.type, &Meaning::first);
            return fmt::format("{} (chunk {})",
                               known == kMeanings.end() ? "it has data of an unknown meaning" : known->second,
                               each.type);
        }
        const bool isRepeated = std::ranges::find(before, each.type) != before.end();
        if (row->isOnce && (isRepeated || each.afterData))
            return fmt::format("it has a chunk {} too many or in the wrong place", each.type);
        before.push_back(each.type);
    }
    return {};
}

}  // namespace glibra::image
