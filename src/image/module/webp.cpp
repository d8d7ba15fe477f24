// WebP.

#include <webp/decode.h>
#include <webp/demux.h>
#include <webp/encode.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include "image/module/codec.h"

namespace glibra::module {
namespace {

struct DeleteDecoder {
    void operator()(WebPAnimDecoder* decoder) const { WebPAnimDecoderDelete(decoder); }
};

/// The first picture of an animation, on its canvas.
void readFirstFrame(const WebPData& file, void* pixels, size_t bytes) {
    WebPAnimDecoderOptions options;
    if (WebPAnimDecoderOptionsInit(&options) == 0) throw Failure{"another version of libwebp"};
    options.color_mode = MODE_RGBA;
    options.use_threads = 0;
    const std::unique_ptr<WebPAnimDecoder, DeleteDecoder> decoder(WebPAnimDecoderNew(&file, &options));
    uint8_t* frame = nullptr;
    int time = 0;
    if (!decoder || WebPAnimDecoderGetNext(decoder.get(), &frame, &time) == 0) throw Failure{"damaged"};
    std::memcpy(pixels, frame, bytes);
}

/// A number of 0..1 as a byte.
uint8_t byteOfFraction(double value) {
    return std::isnan(value) ? uint8_t{0}
                             : static_cast<uint8_t>(std::lround(std::clamp(value, 0., 1.) * 255));
}

uint8_t byteAt(const GlibraWriteRequest& request, size_t index) {
    if (request.type == kGlibraU8) return static_cast<const uint8_t*>(request.pixels)[index];
    if (request.type == kGlibraF32)
        return byteOfFraction(static_cast<double>(static_cast<const float*>(request.pixels)[index]));
    return byteOfFraction(static_cast<const uint16_t*>(request.pixels)[index] / 65535.);
}

class WebpPicture {
  public:
    WebpPicture() {
        if (WebPPictureInit(&picture) == 0) throw Failure{"another version of libwebp"};
        WebPMemoryWriterInit(&writer);
        picture.writer = WebPMemoryWrite;
        picture.custom_ptr = &writer;
        picture.use_argb = 1;
    }
    WebpPicture(const WebpPicture&) = delete;
    WebpPicture& operator=(const WebpPicture&) = delete;
    ~WebpPicture() {
        WebPPictureFree(&picture);
        WebPMemoryWriterClear(&writer);
    }

    WebPPicture picture{};
    WebPMemoryWriter writer{};
};

}  // namespace

void readWebp(const GlibraReadRequest& request) {
    const auto* const bytes = static_cast<const uint8_t*>(request.bytes);
    WebPBitstreamFeatures features;
    if (WebPGetFeatures(bytes, request.size, &features) != VP8_STATUS_OK) throw Failure{"damaged header"};
    const auto width = static_cast<size_t>(features.width), height = static_cast<size_t>(features.height);
    auto* const pixels = static_cast<uint8_t*>(allocate(request, width, height, kGlibraU8));
    const size_t size = 4 * width * height;
    if (features.has_animation != 0) return readFirstFrame({bytes, request.size}, pixels, size);
    if (WebPDecodeRGBAInto(bytes, request.size, pixels, size, 4 * features.width) == nullptr)
        throw Failure{"damaged pixels"};
}

void writeWebp(const GlibraWriteRequest& request) {
    constexpr int kEffort = 2;  // of 9; more takes several times as long for a few percent
    if (request.width > WEBP_MAX_DIMENSION || request.height > WEBP_MAX_DIMENSION)
        throw Failure{"WebP has at most " + std::to_string(WEBP_MAX_DIMENSION) + " pixels per side"};
    WebPConfig config;
    if (WebPConfigInit(&config) == 0 || WebPConfigLosslessPreset(&config, kEffort) == 0)
        throw Failure{"another version of libwebp"};
    config.exact = 1;  // colours of transparent pixels stay
    WebpPicture webp;
    webp.picture.width = request.width;
    webp.picture.height = request.height;
    if (WebPPictureAlloc(&webp.picture) == 0) throw std::bad_alloc();
    const auto components = static_cast<size_t>(request.components);
    size_t at = 0;
    for (int y = 0; y < request.height; ++y)
        for (int x = 0; x < request.width; ++x, at += components) {
            const auto component = [&](size_t c) -> uint32_t { return byteAt(request, at + c); };
            const uint32_t alpha = components == 4 ? component(3) : 255U;
            webp.picture.argb[y * webp.picture.argb_stride + x] =
                alpha << 24U | component(0) << 16U | component(1) << 8U | component(2);
        }
    if (WebPEncode(&config, &webp.picture) == 0)
        throw Failure{"libwebp reports error " + std::to_string(webp.picture.error_code)};
    writeFile(request.path, {webp.writer.mem, webp.writer.mem + webp.writer.size});
}

}  // namespace glibra::module
