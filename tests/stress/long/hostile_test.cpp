// A thousand hostile shots among a thousand good ones: the good ones' verdicts are those of a run without the
// hostile ones.

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace glibra {
namespace {

namespace fs = std::filesystem;

constexpr int kGood = 1'000;
constexpr int kHostile = 1'000;

class HostileShots : public testing::Test {
  protected:
    void SetUp() override {
        char name[] = "/tmp/glibra-hostile-XXXXXX";
        ASSERT_NE(::mkdtemp(name), nullptr);
        folder = name;
        write("a.vert", "#version 330 core\nvoid main() { gl_Position = vec4(aVertex.xy, 0., 1.); }\n");
        write("good.frag",
              "#version 330 core\nuniform float uShift;\nout vec4 f;\nvoid main() { f = "
              "vec4(fract(gl_FragCoord.xy "
              "/ 7. + uShift), fract(uShift), 1.); }\n");
        write("good.glib",
              "Vertex a.vert\nFragment good.frag\nProgram P uShift <0 0 2000>\nQuadXY 0 1 1 1\n");
        // What a stranger may send: each is a scene of its own.
        scene("syntax.glib", "#version 330 core\nout vec4 f;\nvoid main() { f = vec4(1. }\n");
        scene("error.glib", "#version 330 core\n#error \033]0;owned\007\nvoid main() {}\n");
        scene("include.glib", "#version 330 core\n#include \"/etc/passwd\"\n");
        std::string macros = "#version 330 core\n#define M0 1.\n";
        for (int i = 1; i < 26; ++i)
            macros += "#define M" + std::to_string(i) + " M" + std::to_string(i - 1) + " + M" +
                      std::to_string(i - 1) + "\n";
        scene("macros.glib", macros + "out vec4 f;\nvoid main() { f = vec4(M25); }\n");
        std::string sum = "#version 330 core\nout vec4 f;\nvoid main() { float a = 1.; f = vec4(a";
        for (int i = 0; i < 60'000; ++i) sum += "+a";
        scene("deep.glib", sum + "); }\n");
        scene("endless.glib",
              "#version 330 core\nuniform int uMany;\nout vec4 f;\nvoid main() { float s = 0.; for (int i = "
              "0; i < "
              "2000000000 && s >= 0.; i++) s += abs(sin(float(i + uMany))); f = vec4(s); }\n",
              " uMany 1");
        write("words.glib", std::string(3'000, '(') + "\nSpere 1\nPushMatrix\n\xff\xfe\x1b[2J\n");
        write("files.glib",
              "Texture 5 \"/etc/shadow\"\nObj \"../../../../etc/passwd\"\nVertex a.vert\nFragment "
              "\"/dev/zero\"\n"
              "Program P uUnit 5\nSphere\n");
        write("picture.glib",
              "Vertex a.vert\nFragment p.frag\nTexture 5 p.png\nProgram P uUnit 5\nQuadXY 0 1 1 1\n");
        write("p.frag",
              "#version 330 core\nuniform sampler2D uUnit;\nout vec4 f;\nvoid main() { f = texture(uUnit, "
              "gl_FragCoord.xy); }\n");
        write("p.png",
              std::string(
                  "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\x7f\xff\xff\xff\x7f\xff\xff\xff\x08\x06\0\0\0\0\0\0\0", 33));
        write("empty.glib", "");
    }
    void TearDown() override {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder / name, std::ios::binary) << text;
    }
    void scene(const std::string& name, const std::string& shader, const std::string& uniforms = {}) const {
        const std::string fragment = name + ".frag";
        write(fragment, shader);
        write(name, "Vertex a.vert\nFragment " + fragment + "\nProgram P" + uniforms + "\nQuadXY 0 1 1 1\n");
    }
    static std::string goodShot(int i) {
        return "[[shot]]\nname = \"g" + std::to_string(i) +
               "\"\nscript = \"good.glib\"\nset = { uShift = " + std::to_string(i) + ".25 }\n";
    }
    static std::string hostileShot(int i) {
        // Crashes and time-outs cost a process each, so they are fewer.
        static const std::vector<std::string> kCheap{"syntax", "error",   "include", "words",
                                                     "files",  "picture", "empty"};
        const std::string script = i % 100 == 7    ? "endless"
                                   : i % 50 == 11  ? "deep"
                                   : i % 100 == 31 ? "macros"
                                                   : kCheap[static_cast<std::size_t>(i) % kCheap.size()];
        return "[[shot]]\nname = \"h" + std::to_string(i) + "\"\nscript = \"" + script + ".glib\"\n" +
               (script == "endless"  ? "timeout = 1\nsize = [500, 400]\n"
                : script == "macros" ? "timeout = 1\n"
                                     : "timeout = 20\n");
    }
    int glibra(const std::string& arguments) const {
        const int status = std::system(  // NOLINT(cert-env33-c): a shell is what a user has
            ("cd '" + folder.string() + "' && '" GLIBRA_PROGRAM "' " + arguments + " >log 2>&1 </dev/null")
                .c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    /// The verdicts of a results folder by the names of their shots.
    std::map<std::string, std::string> verdicts(const std::string& results) const {
        std::map<std::string, std::string> found;
        std::ifstream file(folder / results / "results.jsonl");
        for (std::string line; std::getline(file, line);) {
            const nlohmann::json shot = nlohmann::json::parse(line);
            if (shot.contains("shot")) found[shot["shot"]] = shot["verdict"];
        }
        return found;
    }

    fs::path folder;
};

TEST_F(HostileShots, ChangeNoVerdictOfGoodOnes) {
    const std::string defaults = "goldens = \"golden\"\n[defaults]\nsize = [16, 12]\n";
    std::vector<std::string> shots;
    std::string good = defaults;
    for (int i = 0; i < kGood; ++i) {
        shots.push_back(goodShot(i));
        good += shots.back();
    }
    for (int i = 0; i < kHostile; ++i) shots.push_back(hostileShot(i));
    std::shuffle(shots.begin(), shots.end(), std::mt19937(11));
    std::string mixed = defaults;
    for (const std::string& each : shots) mixed += each;
    write("s.toml", good);
    ASSERT_EQ(glibra("test s.toml --update --results made"), 0);
    // Some goldens are wrong, so that there are several verdicts.
    for (int i = 0; i < kGood; i += 10) fs::remove(folder / "golden" / ("g" + std::to_string(i) + ".png"));
    for (int i = 5; i < kGood; i += 10)
        fs::copy_file(folder / "golden/g1.png", folder / "golden" / ("g" + std::to_string(i) + ".png"),
                      fs::copy_options::overwrite_existing);
    ASSERT_NE(glibra("test s.toml --results alone"), 0);
    const std::map<std::string, std::string> alone = verdicts("alone");
    ASSERT_EQ(alone.size(), std::size_t{kGood});
    EXPECT_GE(
        std::count_if(alone.begin(), alone.end(), [](const auto& each) { return each.second == "passed"; }),
        800);

    write("s.toml", mixed);
    for (const std::string option : {"", " --untrusted"}) {
        EXPECT_EQ(glibra("test s.toml --results among" + option), 3);
        const std::map<std::string, std::string> among = verdicts("among");
        EXPECT_EQ(among.size(), std::size_t{kGood + kHostile}) << option;
        for (const auto& [name, verdict] : alone) {
            ASSERT_TRUE(among.contains(name)) << name;
            EXPECT_EQ(among.at(name), verdict) << name << option;
        }
        for (const auto& [name, verdict] : among) {
            if (name[0] != 'h') continue;
            EXPECT_NE(verdict, "passed") << name << option;
        }
    }
}

}  // namespace
}  // namespace glibra
