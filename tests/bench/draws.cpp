// What a draw of a loaded scene costs: 1,000 draws with changed values through the C++ library beside the
// same frames drawn and read back by bare GL calls (bare_frame.h), in turns. Prints rows of a table in
// Markdown. Use: glibra_draws REPOSITORY [DRAWS [SCENE]]   the table, or one row of it
//      glibra_draws --loop REPOSITORY [DRAWS]    seconds per draw of the teapot by the library alone,
//      by the clock and of all processors together
//      glibra_draws --growth [DRAWS]    the memory of the process while a small scene is drawn 100,000 times

#include <EGL/egl.h>
#include <glibra/glibra.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bare/context.h"
#include "bare_frame.h"

namespace {

constexpr int kWidth = 320, kHeight = 240;
constexpr int kDrawsInTurn = 20;

constexpr const char* kWaves =
    "WindowSize 320 240\nBackground .1 .12 .15\nPerspective 40\nLookAt 0 3 5  0 0 0  0 1 0\n"
    "Vertex waves.vert\nFragment waves.frag\nProgram Waves uHeight <0 .2 .5> uLength <.1 .7 2>\n"
    "QuadXZ 0 3 100 100\n";
const std::map<std::string, std::string> kWaveFiles{
    {"waves.vert",
     "#version 330\nin vec4 aVertex; uniform mat4 uModelViewProjectionMatrix; uniform float uHeight, "
     "uLength;\n"
     "out float vSlope;\nvoid main() {\n    float phase = 6.2832 * length(aVertex.xz) / uLength;\n"
     "    vSlope = cos(phase);\n"
     "    gl_Position = uModelViewProjectionMatrix * (aVertex + vec4(0, uHeight * sin(phase), 0, 0));\n}\n"},
    {"waves.frag",
     "#version 330\nin float vSlope; out vec4 color;\n"
     "void main() { color = vec4(mix(vec3(.05, .15, .3), vec3(.6, .8, .9), .5 + .5 * vSlope), 1); }\n"}};

struct Subject {
    const char* name;
    const char* path;  ///< below the repository; null: the waves
    const char* value;
    double least, most;
};
constexpr Subject kSubjects[] = {
    {"waves, 100 x 100 cells", nullptr, "uHeight", 0, .5},
    {"teapot", "glib/start/teapot.glib", "uShininess", 1, 200},
    {"reflect_refract", "glib/texture/reflect_refract.glib", "uMix", 0, 1},
    {"marble", "glib/noise/marble.glib", "uNoiseMag", 0, 4},
};

[[noreturn]] void fail(const std::string& what) {
    std::fprintf(stderr, "draws: %s\n", what.c_str());
    std::exit(1);
}

template <class T>
T taken(glibra::Result<T> result) {
    if (!result) fail(result.message());
    return std::move(*result);
}

glibra::Scene loaded(glibra::Renderer& renderer, const Subject& subject, const std::string& root) {
    if (subject.path == nullptr) return taken(renderer.loadText(kWaves, "waves.glib", kWaveFiles));
    return taken(renderer.load(root + "/" + subject.path));
}

/// Seconds by a clock.
double seconds(clockid_t clock) {
    timespec time{};
    clock_gettime(clock, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Seconds per draw of each turn, by the clock and of all processors together.
struct Times {
    std::vector<double> clock, processors;

    /// Lets `draw` draw one picture to begin with, then a turn that counts.
    void turn(int first, const std::function<void(int)>& draw) {
        draw(first);
        const double clockBegin = seconds(CLOCK_MONOTONIC),
                     processorBegin = seconds(CLOCK_PROCESS_CPUTIME_ID);
        for (int i = 0; i < kDrawsInTurn; ++i) draw(first + i);
        clock.push_back((seconds(CLOCK_MONOTONIC) - clockBegin) / kDrawsInTurn);
        processors.push_back((seconds(CLOCK_PROCESS_CPUTIME_ID) - processorBegin) / kDrawsInTurn);
    }
};

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double medianRatio(const std::vector<double>& ours, const std::vector<double>& others) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < ours.size(); ++i) ratios.push_back(ours[i] / others[i]);
    return median(std::move(ratios));
}

/// The largest difference of a component between a picture and pixels of a bare frame.
int difference(const glibra::Picture& picture, const std::vector<std::byte>& bare) {
    int most = 0;
    for (std::size_t y = 0; y < kHeight; ++y)
        for (std::size_t x = 0; x < kWidth; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                most = std::max(
                    most, std::abs(std::to_integer<int>(picture.data[3 * (y * kWidth + x) + c]) -
                                   std::to_integer<int>(bare[4 * ((kHeight - 1 - y) * kWidth + x) + c])));
    return most;
}

void measure(const Subject& subject, const std::string& root, int draws) {
    // The bare program's context, in which glibra makes what both draw.
    bare::openContext();
    const EGLContext shared = eglGetCurrentContext();
    const EGLDisplay display = eglGetCurrentDisplay();
    if (gladLoadGL(eglGetProcAddress) == 0) fail("gladLoadGL");
    const auto use = [&] { eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, shared); };
    glibra::Renderer guest = taken(glibra::Renderer::open(glibra::CurrentContext{bench::notingLoader}));
    glibra::Scene adopted = loaded(guest, subject, root);
    // The table of functions is that of the renderer that was opened last, without the notes.
    const auto valueOf = [&](int i) {
        return subject.least + (subject.most - subject.least) * (i % 100) / 99.;
    };
    const auto drawn = [&](glibra::Scene& scene, int i) {
        if (auto set = scene.set(subject.value, valueOf(i)); !set) fail(set.message());
        return taken(scene.draw({.width = kWidth, .height = kHeight}));
    };
    for (int i = 0; i < 3; ++i) drawn(adopted, i);
    bench::BareFrame::begin();
    drawn(adopted, 3);
    bench::BareFrame frame = bench::BareFrame::end();

    glibra::Renderer own = taken(glibra::Renderer::open());
    glibra::Scene scene = loaded(own, subject, root);
    std::vector<std::byte> pixels(std::size_t{4} * kWidth * kHeight);
    Times ofScene, ofAdopted, ofBare;
    const auto bareTurn = [&](int first) {
        use();
        frame.prepare(subject.value, kWidth, kHeight);
        if (!frame.hasValue()) fail(std::string("no uniform ") + subject.value);
        ofBare.turn(first, [&](int i) { frame.draw(static_cast<float>(valueOf(i)), pixels); });
    };
    for (int done = 0; done < draws; done += kDrawsInTurn) {
        const bool isFirst = done / kDrawsInTurn % 2 == 0;  // the order changes from turn to turn
        if (isFirst) bareTurn(done);
        ofScene.turn(done, [&](int i) { drawn(scene, i); });
        if (!isFirst) bareTurn(done);
        use();
        ofAdopted.turn(done, [&](int i) { drawn(adopted, i); });
    }
    use();
    frame.prepare(subject.value, kWidth, kHeight);
    for (const int i : {0, 17, 99}) {
        frame.draw(static_cast<float>(valueOf(i)), pixels);
        if (const int most = difference(drawn(scene, i), pixels); most > 1)
            fail(std::string(subject.name) + ": the pictures differ by " + std::to_string(most));
        use();
        frame.prepare(subject.value, kWidth, kHeight);
    }
    std::printf("| %s | %.2f ms | %.2f ms | %.3f | %.3f | %.3f |\n", subject.name,
                1e3 * median(ofScene.clock), 1e3 * median(ofBare.clock),
                medianRatio(ofScene.clock, ofBare.clock), medianRatio(ofScene.processors, ofBare.processors),
                medianRatio(ofAdopted.clock, ofBare.clock));
    std::fflush(stdout);
}

long residentKilobytes() {
    std::ifstream status("/proc/self/statm");
    long all = 0, pages = 0;
    status >> all >> pages;
    return 4 * pages;
}

void measureGrowth(int draws) {
    glibra::Renderer renderer = taken(glibra::Renderer::open());
    glibra::Scene scene = loaded(renderer, kSubjects[0], "");
    for (int i = 0; i <= draws; ++i) {
        if (!scene.set("uHeight", i % 100 / 200.)) fail("no value");
        taken(scene.draw({.width = 8, .height = 6}));
        if (i == draws / 100 || i == draws / 2 || i == draws)
            std::printf("after %d draws: %ld kB\n", i, residentKilobytes());
    }
}

void measureLoop(const std::string& root, int draws) {
    const Subject& teapot = kSubjects[1];
    glibra::Renderer renderer = taken(glibra::Renderer::open());
    glibra::Scene scene = loaded(renderer, teapot, root);
    double clockBegin = 0, processorBegin = 0;
    for (int i = -20; i < draws; ++i) {
        if (i == 0) clockBegin = seconds(CLOCK_MONOTONIC), processorBegin = seconds(CLOCK_PROCESS_CPUTIME_ID);
        if (!scene.set(teapot.value, 1. + (i + 100) % 100)) fail("no value");
        taken(scene.draw({.width = kWidth, .height = kHeight}));
    }
    std::printf("%.9f %.9f\n", (seconds(CLOCK_MONOTONIC) - clockBegin) / draws,
                (seconds(CLOCK_PROCESS_CPUTIME_ID) - processorBegin) / draws);
}

}  // namespace

int main(int count, char** arguments) {
    const std::string_view first = count > 1 ? arguments[1] : "";
    const int drawsAt = first == "--loop" ? 3 : 2;
    if (count < drawsAt || count > drawsAt + 2)
        fail("use: glibra_draws [--loop] REPOSITORY [DRAWS [SCENE]], or glibra_draws --growth [DRAWS]");
    const int draws = count > drawsAt       ? std::atoi(arguments[drawsAt])  // NOLINT(cert-err34-c)
                      : first == "--growth" ? 100'000
                                            : 1000;
    if (first == "--growth") return measureGrowth(draws), 0;
    if (first == "--loop") return measureLoop(arguments[2], draws), 0;
    std::puts(
        "| scene | a draw by the library | by bare GL calls | ratio | of processor time | in the caller's "
        "context |");
    std::puts("|---|---|---|---|---|---|");
    for (const Subject& each : kSubjects)
        if (count < 4 || std::string_view(each.name).starts_with(arguments[3]))
            measure(each, arguments[1], draws);
    return 0;
}
