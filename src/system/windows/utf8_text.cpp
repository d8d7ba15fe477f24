// The older C runtime of Windows has no locale with UTF-8, and libstdc++ makes paths of narrow text by its
// mbrtowc(). The one below takes UTF-8, as all narrow text of this program is. It is linked in its place
// because the build asks for the name before the C runtime is looked at.

#include <cstddef>
#include <cwchar>

namespace {

/// Bytes of the character that begins so; 0: none does.
std::size_t lengthOf(unsigned char first) {
    if (first < 0x80U) return 1;
    if (first >= 0xC2U && first < 0xE0U) return 2;
    if (first >= 0xE0U && first < 0xF0U) return 3;
    return first >= 0xF0U && first < 0xF5U ? 4 : 0;
}

/// The character of that many bytes; 0: there is none.
unsigned characterOf(const char* from, std::size_t length) {
    constexpr unsigned kFirstBits[] = {0, 0, 0x1F, 0x0F, 0x07};
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(from[at]); };
    unsigned code = byte(0) & kFirstBits[length];
    for (std::size_t at = 1; at < length; ++at) {
        if ((byte(at) & 0xC0U) != 0x80U) return 0;
        code = code << 6U | (byte(at) & 0x3FU);
    }
    const bool isOverlong = (length == 3 && code < 0x800U) || (length == 4 && code < 0x10000U);
    return isOverlong || code > 0x10FFFFU || (code >= 0xD800U && code < 0xE000U) ? 0 : code;
}

std::mbstate_t own{};  // for those who bring none

}  // namespace

/// A character beyond U+FFFF is two surrogates: the first one for three bytes, the second one, which the
/// state keeps, for the last byte. What is no UTF-8 is taken for Latin-1, as in old scenes, so that every
/// text is a path.
extern "C" std::size_t mbrtowc(wchar_t* to, const char* from, std::size_t count, std::mbstate_t* given) {
    std::mbstate_t& state = given != nullptr ? *given : own;
    const auto give = [&](unsigned code, std::size_t length) {
        if (to != nullptr) *to = static_cast<wchar_t>(code);
        return length;
    };
    if (from == nullptr || count == 0) {
        state = {};
        return from == nullptr ? 0 : static_cast<std::size_t>(-2);
    }
    if (state != 0) {
        const auto second = static_cast<unsigned>(state);
        state = {};
        return give(second, 1);
    }
    const auto first = static_cast<unsigned char>(*from);
    const std::size_t length = lengthOf(first);
    const unsigned code = length > 1 && length <= count ? characterOf(from, length) : 0;
    if (code == 0) return give(first, first == 0 ? 0 : 1);
    if (length < 4) return give(code, length);
    state = static_cast<std::mbstate_t>(0xDC00U + (code & 0x3FFU));
    return give(0xD7C0U + (code >> 10U), 3);
}

// The C runtime has these two beside it.

extern "C" std::size_t mbrlen(const char* from, std::size_t count, std::mbstate_t* given) {
    static std::mbstate_t state{};
    return mbrtowc(nullptr, from, count, given != nullptr ? given : &state);
}

extern "C" std::size_t mbsrtowcs(wchar_t* to, const char** from, std::size_t count, std::mbstate_t* given) {
    constexpr std::size_t kLongest = 4;
    const char* rest = *from;
    for (std::size_t done = 0; to == nullptr || done < count; ++done) {
        std::size_t left = 0;
        while (left < kLongest && rest[left] != '\0') ++left;
        const std::size_t taken = mbrtowc(to != nullptr ? to + done : nullptr, rest, left + 1, given);
        if (taken == 0) {
            if (to != nullptr) *from = nullptr;
            return done;
        }
        rest += taken;
        if (to != nullptr) *from = rest;
    }
    return count;
}
