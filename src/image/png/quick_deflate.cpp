#include "image/png/quick_deflate.h"

#include <new>

#if GLIBRA_HAS_ISAL
#include <isa-l/igzip_lib.h>
#else
#include <libdeflate.h>
#endif

namespace glibra::image {

#if GLIBRA_HAS_ISAL

struct QuickPacker::State {
    isal_zstream stream{};
    std::vector<std::uint8_t> work = std::vector<std::uint8_t>(ISAL_DEF_LVL1_DEFAULT);
    std::vector<std::uint8_t> piece = std::vector<std::uint8_t>(std::size_t{64} << 10);
    std::vector<std::byte> packed;

    /// Packs what the stream has been given, and moves it to `packed`.
    void run() {
        do {
            stream.next_out = piece.data();
            stream.avail_out = static_cast<std::uint32_t>(piece.size());
            if (isal_deflate(&stream) != COMP_OK) throw std::bad_alloc();
            const auto* begin = reinterpret_cast<const std::byte*>(piece.data());
            packed.insert(packed.end(), begin, begin + (piece.size() - stream.avail_out));
        } while (stream.avail_out == 0 || stream.avail_in > 0);
    }
};

QuickPacker::QuickPacker() : state_(std::make_unique<State>()) {
    isal_zstream& stream = state_->stream;
    isal_deflate_init(&stream);
    stream.level = 1;
    stream.level_buf = state_->work.data();
    stream.level_buf_size = static_cast<std::uint32_t>(state_->work.size());
    stream.gzip_flag = IGZIP_ZLIB;
}

QuickPacker::~QuickPacker() = default;

void QuickPacker::add(std::span<const std::uint8_t> bytes) {
    // The library only reads there, though its type does not say so.
    state_->stream.next_in = const_cast<std::uint8_t*>(bytes.data());  // NOLINT(*-const-cast)
    state_->stream.avail_in = static_cast<std::uint32_t>(bytes.size());
    state_->run();
}

std::vector<std::byte> QuickPacker::finish() {
    state_->stream.end_of_stream = 1;
    state_->run();
    return std::move(state_->packed);
}

#else

struct QuickPacker::State {
    std::vector<std::uint8_t> bytes;
};

QuickPacker::QuickPacker() : state_(std::make_unique<State>()) {}
QuickPacker::~QuickPacker() = default;

void QuickPacker::add(std::span<const std::uint8_t> bytes) {
    state_->bytes.insert(state_->bytes.end(), bytes.begin(), bytes.end());
}

std::vector<std::byte> QuickPacker::finish() {
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
        libdeflate_alloc_compressor(1), libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    const std::vector<std::uint8_t>& bytes = state_->bytes;
    std::vector<std::byte> packed(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()));
    packed.resize(
        libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
    return packed;
}

#endif

}  // namespace glibra::image
