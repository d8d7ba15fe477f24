// The check of an exercise: each one that is shipped fails it as it is handed out, and passes it with its
// solution; other right solutions pass it, typical wrong ones do not.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "program.h"
#include "suite/file/sweep.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = GLIBRA_SOURCE_DIR;

std::vector<fs::path> allExercises() {
    std::vector<fs::path> found;
    for (const auto& each : fs::recursive_directory_iterator(kProject / "glib/exercises"))
        if (each.path().extension() == ".glib") found.push_back(each.path());
    return found;
}

std::size_t occurrencesOf(const std::string& text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// A library whose scenes beside those of a topic find what these find.
class Desk {
  public:
    Desk() {
        for (const char* each : {"shaders", "textures", "scenes"})
            fs::create_directory_symlink(kProject / each, folder_ / each);
    }
    /// A submission of the exercise "gl07/spotlight": the solution, with texts of the scene or of the shader
    /// replaced. Returns the scene.
    fs::path hand(const std::string& exercise, const std::string& shader = {},
                  const std::vector<std::pair<std::string, std::string>>& changes = {}) {
        const fs::path file = kProject / "glib/exercises" / (exercise + ".toml");
        const auto read = suite::readExercise(file);
        EXPECT_TRUE(read) << exercise;
        if (!read) return {};
        const fs::path topic = read->solution.parent_path();
        const fs::path there = folder_ / ("glib/" + topic.filename().string());
        if (!fs::exists(there)) {
            fs::create_directories(there);
            for (const auto& each : fs::directory_iterator(topic))
                if (each.is_directory() || each.path().extension() != ".glib")
                    fs::create_symlink(each.path(), there / each.path().filename());
        }
        std::string name = exercise;
        name.replace(name.find('/'), 1, "_");
        while (fs::exists(there / (name + ".glib"))) name += "_";
        std::string scene = readFile(read->solution), stage;
        if (!shader.empty()) stage = readFile(kProject / "shaders" / topic.filename() / shader);
        for (const auto& [from, to] : changes) {
            std::string& text = stage.find(from) != std::string::npos ? stage : scene;
            EXPECT_NE(text.find(from), std::string::npos) << exercise << ": " << from;
            if (const std::size_t at = text.find(from); at != std::string::npos)
                text.replace(at, from.size(), to);
        }
        if (!shader.empty()) {
            // Its includes are found in the library, as those of a shader beside the scene are.
            for (std::size_t at = 0; (at = stage.find("#include \"", at)) != std::string::npos;) {
                at += std::string_view("#include \"").size();
                stage.insert(at, topic.filename().string() + "/");
            }
            const std::string own = name + shader.substr(shader.find('.'));
            folder_.write("glib/" + topic.filename().string() + "/" + own, stage);
            scene.replace(scene.find(shader), shader.size(), own);
        }
        folder_.write("glib/" + topic.filename().string() + "/" + name + ".glib", scene);
        std::string text = readFile(file);
        const std::size_t line = text.find("solution = ");
        text.replace(line, text.find('\n', line) - line, "solution = \"" + read->solution.string() + "\"");
        folder_.write("glib/" + topic.filename().string() + "/" + name + ".toml", text);
        return there / (name + ".glib");
    }
    [[nodiscard]] Finished check(const std::vector<fs::path>& scenes) const {
        std::string command = "check --run --size 160x120";
        for (const fs::path& each : scenes) command += " '" + each.string() + "'";
        return glibra(folder_.path(), command);
    }

  private:
    Folder folder_;
};

TEST(Exercises, AreNotSolvedAsTheyAreHandedOut) {
    const std::vector<fs::path> all = allExercises();
    ASSERT_GE(all.size(), 100U);
    const Finished run = Desk().check(all);
    EXPECT_EQ(run.status, 1) << run.err;
    for (const fs::path& each : all)
        EXPECT_TRUE(contains(run.err, each.string() + ":1:1: error: the exercise is not solved yet: "))
            << each;
    EXPECT_EQ(occurrencesOf(run.err, "[check-E04]"), all.size()) << run.err;
    EXPECT_EQ(occurrencesOf(run.err, "error: "), all.size()) << "one message each";
}

TEST(Exercises, AreSolvedByTheirSolutions) {
#if GLIBRA_SANITIZED
    GTEST_SKIP() << "a thousand pictures";
#endif
    Desk desk;
    std::vector<fs::path> all;
    for (const fs::path& each : allExercises())
        all.push_back(desk.hand(each.parent_path().filename().string() + "/" + each.stem().string()));
    const Finished run = desk.check(all);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(occurrencesOf(run.err, "[check-N03]"), all.size()) << run.err;
}

TEST(Exercises, AreSolvedInOtherWays) {
    Desk desk;
    const Finished run = desk.check({
        desk.hand("gl04/camera_axes", "",
                  {{"Let view (rotation*translate(-place.x, -place.y, -place.z))",
                    "Let view (mat4(U.x, V.x, N.x, 0,  U.y, V.y, N.y, 0,  U.z, V.z, N.z, 0, "
                    "-dot(place, U), -dot(place, V), -dot(place, N), 1))"}}),
        desk.hand("gs08/round_bumps", "round_bumps.frag",
                  {{"dot(reflect(-toLight, normal), toEye)",
                    "dot(2. * dot(toLight, normal) * normal - toLight, toEye)"}}),
        desk.hand("gs12/colored_silhouettes", "silhouette_colors.geom",
                  {{"float((uint(gl_PrimitiveIDIn) * 2654435769u) >> 8) / 16777216.",
                    "fract(.6180340 * float(gl_PrimitiveIDIn))"}}),
        desk.hand("gl10/height_map", "mesa_heights.frag",
                  {{"float mesa = max(q.x, q.y) < .28 ? .9 : 0.;", "float mesa = q.x < .1 ? .7 : 0.;"}}),
    });
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(occurrencesOf(run.err, "[check-N03]"), 4U) << run.err;
}

TEST(Exercises, AreNotSolvedByWhatIsWrong) {
    Desk desk;
    const std::vector<fs::path> wrong{
        desk.hand("gl04/camera_axes", "",
                  {{"Let view (rotation*translate(-place.x, -place.y, -place.z))",
                    "Let view (transpose(rotation)*translate(-place.x, -place.y, -place.z))"}}),
        desk.hand("gs08/round_bumps", "round_bumps.frag", {{"normalize(vNormal)", "vNormal"}}),
        desk.hand("gs08/round_bumps", "round_bumps.frag", {{"normalize(-vPosition)", "vec3(0., 0., 1.)"}}),
        desk.hand("gs08/contours", "contours.frag", {{"1.6", "1."}}),
        desk.hand("gl10/height_map", "mesa_heights.frag",
                  {{"float mesa = max(q.x, q.y) < .28 ? .9 : 0.;", "float mesa = 0.;"}}),
    };
    const Finished run = desk.check(wrong);
    EXPECT_EQ(run.status, 1) << run.err;
    for (const fs::path& each : wrong)
        EXPECT_TRUE(contains(run.err, each.string() + ":1:1: error: the exercise is not solved yet"))
            << each << "\n"
            << run.err;
}

}  // namespace
}  // namespace glibra::test
