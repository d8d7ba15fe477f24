// The bare programs for modern scenes, chosen by name.
// Use: glibra_bare SUBJECT OUT.png REPOSITORY [SIZE [STEPS]]

#define EGL_NO_X11
#include <EGL/egl.h>

#include <cstdlib>
#include <string_view>

#include "bare.h"
#include "context.h"

int main(int count, char** arguments) {
    constexpr struct {
        std::string_view name;
        void (*draw)(const bare::Arguments&);
    } kSubjects[] = {{"shadow-map", bare::shadowMap}, {"cubes", bare::cubes},       {"life", bare::life},
                     {"particles", bare::particles},  {"deferred", bare::deferred}, {"water", bare::water},
                     {"ray-tracer", bare::rayTracer}};
    if (count < 4 || count > 6) bare::fail("use: glibra_bare SUBJECT OUT.png REPOSITORY [SIZE [STEPS]]");
    const std::string root = arguments[3];
    const bare::Arguments given{arguments[2],
                                root + "/shaders/modern",
                                root + "/tests/bench/bare/fill.vert",
                                root + "/textures",
                                count > 4 ? std::atoi(arguments[4]) : 0,   // NOLINT(cert-err34-c)
                                count > 5 ? std::atoi(arguments[5]) : 0};  // NOLINT(cert-err34-c)
    for (const auto& each : kSubjects)
        if (each.name == arguments[1]) {
            bare::openContext();
            if (gladLoadGL(eglGetProcAddress) == 0) bare::fail("gladLoadGL");
            each.draw(given);
            return 0;
        }
    bare::fail("no such subject");
}
