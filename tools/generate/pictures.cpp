// Makes the pictures in textures/: `pictures FOLDER [NAME]...`, all of them when no name is given.
#include <cstdio>
#include <cstring>
#include <string>

#include "stages.h"

namespace generate {
namespace {

constexpr double kPi = 3.14159265358979323846;

// The colours of the planet by longitude and latitude: s = 0 is at -x, as on glibra's Sphere, and the bottom
// row is the south pole.
Picture planetMap(int width, int height) {
    Picture map{width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height))};
    const Stage stage = planetStage();
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double turn = 2 * kPi * (x + 0.5) / width, up = kPi * (0.5 - (y + 0.5) / height);
            const Vec3 c =
                stage.sky({-std::cos(turn) * std::cos(up), std::sin(up), std::sin(turn) * std::cos(up)});
            std::uint8_t* out = &map.rgb[static_cast<std::size_t>(3 * (y * width + x))];
            out[0] = displayByte(c.x);
            out[1] = displayByte(c.y);
            out[2] = displayByte(c.z);
        }
    return map;
}

// White noise, one random byte per pixel, the same in all three channels.
Picture randomMap(int size) {
    Picture map{size, size, {}};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            map.rgb.insert(map.rgb.end(), 3, static_cast<std::uint8_t>(hash(x, y, 0) >> 24));
    return map;
}

bool wanted(int argc, char** argv, const char* name) {
    for (int i = 2; i < argc; ++i)
        if (std::strcmp(argv[i], name) == 0) return true;
    return argc == 2;
}

}  // namespace
}  // namespace generate

int main(int argc, char** argv) {
    using namespace generate;
    if (argc < 2) {
        std::fputs("usage: pictures FOLDER [NAME]...\n", stderr);
        return 2;
    }
    const std::string folder = std::string(argv[1]) + "/";
    const auto save = [&](const char* name, const auto& make) {
        if (wanted(argc, argv, name)) writePng(make(), folder + name + ".png");
    };
    save("apples", [] { return photograph(applesStage(), {{0, 12, 0.4}, {0, 0, 0}, 32}, 384, 384); });
    save("cherries", [] {
        return photograph(cherriesStage(), {{0.3, 4.6, 6.2}, {0.1, 0.55, 0.1}, 36}, 400, 400);
    });
    save("sample1", [] { return photograph(toysStage(), {{0.4, 3.2, 7.2}, {0, 0.75, 0}, 38}, 400, 400); });
    save("sample2", [] { return photograph(lakeStage(), {{0.6, 1.5, 7.0}, {-0.3, 1.75, 0}, 52}, 400, 400); });
    save("village", [] {
        return photograph(villageStage(), {{0.4, 4.0, 11.5}, {0.1, 1.1, 0}, 44}, 400, 400);
    });
    const Camera stereo{{0.2, 2.0, 7.6}, {0, 1.75, 0.2}, 46};
    for (const double side : {-1.0, 1.0}) {
        Camera eye = stereo;
        eye.shift = side * 0.12;
        save(side < 0 ? "left" : "right", [&] { return photograph(roomStage(), eye, 400, 400); });
    }
    const char* faces[] = {"posx", "negx", "posy", "negy", "posz", "negz"};
    for (int f = 0; f < 6; ++f)
        save((std::string("courtyard_") + faces[f]).c_str(), [&] {
            return cubeFace(courtyardStage(), {0, 1.9, 0}, f, 360);
        });
    save("planet_map", [] { return planetMap(512, 256); });
    save("random", [] { return randomMap(256); });
    return 0;
}
