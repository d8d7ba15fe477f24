#include "image/text.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace glibra::image {
namespace {

constexpr int kGlyphRows = 14;  // of a character, from its second row on; the others are empty
constexpr int kHalfRows = 7;    // in each of the two numbers
constexpr int kFirst = 0x20, kLast = 0x7e;

/// The printable characters of ASCII: a byte per row, the left pixel in its highest bit, the upper row in the
/// highest byte. Drawn from DejaVu Sans Mono at 13 pixels per em.
using Glyph = std::array<std::uint64_t, 2>;
constexpr std::array<Glyph, kLast - kFirst + 1> kGlyphs{{
    {0x00000000000000, 0x00000000000000},  // blank
    {0x00001010101010, 0x10001010000000},  // !
    {0x00002828282800, 0x00000000000000},  // "
    {0x001212167f2424, 0xfe284848000000},  // #
    {0x0000083e494838, 0x0e09493e080800},  // $
    {0x0000609090621c, 0x66090906000000},  // %
    {0x00001c20203049, 0x4d45623d000000},  // &
    {0x00001010101000, 0x00000000000000},  // '
    {0x0c080810101010, 0x10100808040000},  // (
    {0x30101008080808, 0x08081010300000},  // )
    {0x000008493e1c6b, 0x08000000000000},  // *
    {0x000000101010fe, 0x10101000000000},  // +
    {0x00000000000000, 0x00001818102000},  // ,
    {0x00000000000000, 0x38000000000000},  // -
    {0x00000000000000, 0x00001818000000},  // .
    {0x00000204040808, 0x18101020204000},  // /
    {0x00001c22414149, 0x4141221c000000},  // 0
    {0x00003808080808, 0x0808083e000000},  // 1
    {0x00003e43010102, 0x0c18207f000000},  // 2
    {0x00003e4101031c, 0x0301433e000000},  // 3
    {0x0000060a1a1222, 0x427f0202000000},  // 4
    {0x00007e40407c03, 0x0101433c000000},  // 5
    {0x00001e21405e63, 0x4141231e000000},  // 6
    {0x00007f02020404, 0x08181020000000},  // 7
    {0x00003e4141413e, 0x6341613e000000},  // 8
    {0x00003c62414163, 0x3d01423c000000},  // 9
    {0x00000000181800, 0x00001818000000},  // :
    {0x00000000181800, 0x00001818102000},  // ;
    {0x00000000010e70, 0x700e0100000000},  // <
    {0x00000000007f00, 0x007f0000000000},  // =
    {0x00000000403807, 0x07384000000000},  // >
    {0x00003844040810, 0x10001010000000},  // ?
    {0x00001e33214749, 0x49494720301e00},  // @
    {0x00000814141422, 0x223e6341000000},  // A
    {0x00007e4141417e, 0x4141417e000000},  // B
    {0x00001e21404040, 0x4040211e000000},  // C
    {0x00007c42414141, 0x4141427c000000},  // D
    {0x00007f4040407f, 0x4040407f000000},  // E
    {0x00007f4040407f, 0x40404040000000},  // F
    {0x00001e21404043, 0x4141211e000000},  // G
    {0x0000414141417f, 0x41414141000000},  // H
    {0x00007c10101010, 0x1010107c000000},  // I
    {0x00001c04040404, 0x04044438000000},  // J
    {0x00004244485070, 0x48444442000000},  // K
    {0x00004040404040, 0x4040407f000000},  // L
    {0x00006363555555, 0x49414141000000},  // M
    {0x00006161515149, 0x45454343000000},  // N
    {0x00001c22414141, 0x4141221c000000},  // O
    {0x00007e43414143, 0x7e404040000000},  // P
    {0x00001c22414141, 0x4141231e060200},  // Q
    {0x00007e4341417e, 0x42414140000000},  // R
    {0x00003e6140603e, 0x030143be000000},  // S
    {0x0000fe10101010, 0x10101010000000},  // T
    {0x00004141414141, 0x4141413e000000},  // U
    {0x00004163222222, 0x14141408000000},  // V
    {0x00008181815a5a, 0x5a666666000000},  // W
    {0x00006322141c08, 0x14362241000000},  // X
    {0x00008244282810, 0x10101010000000},  // Y
    {0x00007f03060408, 0x1030607f000000},  // Z
    {0x1c101010101010, 0x101010101c0000},  // [
    {0x00004020201010, 0x18080804040200},  // backslash
    {0x38080808080808, 0x08080808380000},  // ]
    {0x0000102844c600, 0x00000000000000},  // ^
    {0x00000000000000, 0x000000000000ff},  // _
    {0x00100800000000, 0x00000000000000},  // `
    {0x000000001c2202, 0x3e42463a000000},  // a
    {0x404040407c6642, 0x4242667c000000},  // b
    {0x000000001c2240, 0x4040221c000000},  // c
    {0x020202023e6642, 0x4242663e000000},  // d
    {0x000000003c6642, 0x7e40623c000000},  // e
    {0x0c1010107c1010, 0x10101010000000},  // f
    {0x000000003e6642, 0x4242663a02221c},  // g
    {0x404040405c6242, 0x42424242000000},  // h
    {0x10000000701010, 0x1010107c000000},  // i
    {0x08000000380808, 0x08080808080870},  // j
    {0x40404040444850, 0x70484442000000},  // k
    {0x70101010101010, 0x1010100e000000},  // l
    {0x000000007f4949, 0x49494949000000},  // m
    {0x000000005c6242, 0x42424242000000},  // n
    {0x000000003c6642, 0x4242663c000000},  // o
    {0x000000007c6642, 0x4242667c404040},  // p
    {0x000000003e6642, 0x4242663a020202},  // q
    {0x000000003c3220, 0x20202020000000},  // r
    {0x000000003c4240, 0x3c02423c000000},  // s
    {0x000010107e1010, 0x1010100e000000},  // t
    {0x00000000424242, 0x4242463a000000},  // u
    {0x00000000426624, 0x243c1818000000},  // v
    {0x0000000081815a, 0x5a5a2424000000},  // w
    {0x00000000662418, 0x18182466000000},  // x
    {0x00000000422224, 0x24141808081030},  // y
    {0x000000007e0204, 0x1820407e000000},  // z
    {0x1c101010106010, 0x101010100c0000},  // {
    {0x10101010101010, 0x10101010101000},  // |
    {0x70101010100c10, 0x10101010600000},  // }
    {0x00000000000039, 0x46000000000000},  // ~
}};

bool isSet(const Glyph& glyph, int x, int y) {
    if (x < 0 || y < 0 || x >= kCharacterWidth || y >= kGlyphRows) return false;
    const std::uint64_t half = glyph.at(y < kHalfRows ? 0 : 1);
    const int row = kHalfRows - 1 - y % kHalfRows;
    return (half >> (8 * row + kCharacterWidth - 1 - x) & 1) != 0;
}

/// White or black, and opaque.
void set(Image& picture, int x, int y, bool isWhite) {
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
    const std::size_t size = picture.type == Component::u8 ? 1 : picture.type == Component::u16 ? 2 : 4;
    std::byte* const pixel =
        picture.data.data() + static_cast<std::size_t>(y) * picture.rowBytes() +
        static_cast<std::size_t>(x) * size * static_cast<std::size_t>(picture.components);
    for (int i = 0; i < picture.components; ++i) {
        const bool isFull = isWhite || i == 3;
        std::byte* const component = pixel + size * static_cast<std::size_t>(i);
        const float value = isFull ? 1 : 0;
        if (picture.type == Component::f32)
            std::memcpy(component, &value, sizeof value);
        else
            std::memset(component, isFull ? 0xff : 0, size);
    }
}

const Glyph& glyphOf(char character) {
    const int code = static_cast<unsigned char>(character);
    return kGlyphs.at(static_cast<std::size_t>((code < kFirst || code > kLast ? '?' : code) - kFirst));
}

}  // namespace

void drawText(Image& picture, int left, int top, std::string_view text, int scale) {
    // The outline of a letter must not cover the letter before it, so outlines come first.
    for (const bool isWhite : {false, true}) {
        int x = left;
        for (const char character : text) {
            // The bytes of a character beyond ASCII that follow its first one show nothing.
            if ((static_cast<unsigned char>(character) & 0xc0U) == 0x80U) continue;
            const Glyph& glyph = glyphOf(character);
            for (int row = -1; row <= kGlyphRows; ++row)
                for (int column = -1; column <= kCharacterWidth; ++column) {
                    bool isDrawn = isSet(glyph, column, row);
                    if (!isWhite)
                        for (int i = 0; i < 9 && !isDrawn; ++i)
                            isDrawn = isSet(glyph, column - 1 + i % 3, row - 1 + i / 3);
                    for (int i = 0; isDrawn && i < scale * scale; ++i)
                        set(picture, x + column * scale + i % scale, top + (row + 1) * scale + i / scale,
                            isWhite);
                }
            x += kCharacterWidth * scale;
        }
    }
}

}  // namespace glibra::image
