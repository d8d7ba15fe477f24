// glib/modern/mirror_ball.glib: a compute shader traces a ray per pixel in a surrounding of six pictures.

#include <spng.h>

#include <fstream>
#include <iterator>

#include "bare.h"

namespace bare {
namespace {

std::vector<std::uint8_t> readPng(const std::string& path, int& side) {
    std::ifstream file(path, std::ios::binary);
    const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    spng_ctx* context = spng_ctx_new(0);
    spng_set_png_buffer(context, bytes.data(), bytes.size());
    spng_ihdr header{};
    std::size_t size = 0;
    if (spng_get_ihdr(context, &header) != 0 || spng_decoded_image_size(context, SPNG_FMT_RGBA8, &size) != 0)
        fail("cannot read " + path);
    side = static_cast<int>(header.width);
    std::vector<std::uint8_t> pixels(size);
    if (spng_decode_image(context, pixels.data(), size, SPNG_FMT_RGBA8, 0) != 0) fail("cannot read " + path);
    spng_ctx_free(context);
    return pixels;
}

void readCourt(const std::string& folder) {
    GLuint court = 0;
    glGenTextures(1, &court);
    glBindTexture(GL_TEXTURE_CUBE_MAP, court);
    const char* faces[6] = {"posx", "negx", "posy", "negy", "posz", "negz"};
    for (unsigned face = 0; face < 6; ++face) {
        int side = 0;
        const std::vector<std::uint8_t> pixels = readPng(folder + "/courtyard_" + faces[face] + ".png", side);
        if (face == 0) glTexStorage2D(GL_TEXTURE_CUBE_MAP, 1, GL_RGBA8, side, side);
        glTexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, 0, 0, side, side, GL_RGBA, GL_UNSIGNED_BYTE,
                        pixels.data());
    }
    glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
}

}  // namespace

void rayTracer(const Arguments& arguments) {
    constexpr int kSide = 640;
    const GLuint trace = link(arguments.shaders, {"mirror_ball.comp"});
    const GLuint show = link(arguments.shaders, {arguments.fill.c_str(), "picture.frag"});
    readCourt(arguments.textures);
    set(trace, "uMirror", .9F);
    set(trace, "uOffset", .001F);
    set(trace, "uLight", glm::dvec3(-4, 5, 6));
    set(trace, "uEye", glm::dvec3(0, .4, 5));
    set(trace, "uBox", translation({-1.9, -1.1, -.6}) * rotation(25, {0, 1, 0}) * rotation(12, {0, 0, 1}));
    const GLuint picture = texture2D(GL_RGBA8, kSide, kSide, GL_LINEAR);
    glBindImageTexture(0, picture, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    glUseProgram(trace);
    glDispatchCompute(kSide / 8, kSide / 8, 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
    const Window window(kSide, kSide);
    window.begin({0, 0, 0});
    glUseProgram(show);
    fill();
    window.write(arguments.file);
}

}  // namespace bare
