// A library that is loaded before those of glibra. Pictures in WebP are decoded for ever.

#include <unistd.h>

#include <cstddef>
#include <cstdint>

extern "C" std::uint8_t* WebPDecodeRGBAInto(const std::uint8_t* /*data*/, std::size_t /*size*/,
                                            std::uint8_t* /*to*/, std::size_t /*bytes*/, int /*stride*/) {
    for (;;) ::usleep(1000);
}
