// What the language server proposes: corrections of messages, sliders, files.

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "server_test.h"

namespace glibra::test {
namespace {

class CorrectionTest : public DrivenServerTest {
  protected:
    void beginAsEditor() {
        ask("initialize", {{"capabilities",
                            {{"workspace", {{"workspaceEdit", {{"resourceOperations", {"create"}}}}}},
                             {"textDocument", {{"formatting", {{"dynamicRegistration", true}}}}}}}});
    }
    /// "Title: new text; " of the corrections of all messages about the text.
    std::string corrections(const char* name, const std::string& text) {
        std::string all;
        for (const json& told : open(name, text)) {
            if (told.value("method", "") != "textDocument/publishDiagnostics" ||
                told["params"]["uri"] != uri(name))
                continue;
            for (const json& message : told["params"]["diagnostics"]) {
                const json parameters = {{"textDocument", {{"uri", uri(name)}}},
                                         {"range", message["range"]},
                                         {"context", {{"diagnostics", json::array({message})}}}};
                for (const json& each : ask("textDocument/codeAction", parameters)) {
                    all += each["title"].get<std::string>();
                    if (each["edit"].contains("changes")) {
                        const json& edit = each["edit"]["changes"][uri(name)][0];
                        all += ":" + edit["newText"].get<std::string>() + "@" +
                               edit["range"]["start"]["line"].dump() + "," +
                               edit["range"]["start"]["character"].dump();
                    }
                    all += "; ";
                }
            }
        }
        return all;
    }
};

TEST_F(CorrectionTest, CorrectsWhatAMessageNames) {
    beginAsEditor();
    EXPECT_EQ(corrections("a.glib", std::string(kScene) + "Spere\n"),
              "Change 'Spere' to 'Sphere':Sphere@5,0; ");
    open("a.glib", kScene);
    const std::string shader = "#version 330\nuniform vec4 uTint;\nout vec4 c;\nvoid main() {\n    c = ";
    EXPECT_EQ(corrections("flat.frag", shader + "normalise(uTint);\n}\n"),
              "Change 'normalise' to 'normalize':normalize@4,8; ");
    EXPECT_EQ(corrections("flat.frag", shader + "abs(uTint)\n}\n"), "Add ';':;@4,18; ");
}

TEST_F(CorrectionTest, AddsSlidersAndCreatesShaders) {
    write("shade.glsl", "vec4 shade(vec4 tint) { return tint * uDim; }\n");
    write("flat.frag",
          "#version 330\nuniform float uDim;\n#include \"shade.glsl\"\nuniform vec4 uTint;\nout vec4 c;\n"
          "void main() { c = shade(uTint); }\n");
    beginAsEditor();
    EXPECT_EQ(corrections("a.glib", std::string(kScene)), "Add a slider for 'uDim': uDim <0 .5 1>@2,29; ");
    EXPECT_EQ(corrections("a.glib",
                          "Vertex nope.vert\nFragment flat.frag\nProgram A uDim 1 uTint {1 1 1 1}\nBox\n"),
              "Create nope.vert; ");
    const json number = at(
        "a.glib", "Vertex nope.vert\nFragment flat.frag\nProgram A uDim 1 uTint {1 1 1 1}\nBox\n", "1 uTint");
    const json made = ask("textDocument/codeAction",
                          {{"textDocument", number["textDocument"]},
                           {"range", {{"start", number["position"]}, {"end", number["position"]}}},
                           {"context", {{"diagnostics", json::array()}}}});
    ASSERT_EQ(made.size(), 1U) << made.dump();
    EXPECT_EQ(made[0]["edit"]["changes"][uri("a.glib")][0]["newText"], "<0 1 2>");
}

TEST_F(CorrectionTest, MakesASliderThatKeepsItsValueWhereARangeMayStand) {
    write("flat.frag",
          "#version 330\nconst int TAPS = 2;\nuniform sampler2D uMap;\nuniform bool uB;\nuniform float uK;\n"
          "uniform vec2 uV;\nuniform uint uU;\nuniform vec4 uTint;\nout vec4 c;\nvoid main() { c = uTint * "
          "uK + "
          "texture(uMap, uV) + float(uB) + float(uU) + float(TAPS); }\n");
    beginAsEditor();
    const std::string text =
        "Vertex flat.vert\nFragment flat.frag\nProgram A const TAPS 3 const int BITS 4 uMap 6 "
        "uB 1 uV 2 uU 5 uK 16777217 uX .1234567891\nLet size -123456789\nBox (size)\n";
    open("a.glib", text);
    const auto slider = [&](const char* number) {
        const json place = at("a.glib", text, number);
        const json made = ask("textDocument/codeAction",
                              {{"textDocument", place["textDocument"]},
                               {"range", {{"start", place["position"]}, {"end", place["position"]}}},
                               {"context", {{"diagnostics", json::array()}}}});
        return made.empty() ? "" : made[0]["edit"]["changes"][uri("a.glib")][0]["newText"].get<std::string>();
    };
    EXPECT_EQ(slider("5 uK"), "<0 5 10>");
    EXPECT_EQ(slider("16777217"), "<0 16777217 33554434>");
    EXPECT_EQ(slider(".1234567891"), "<0 .1234567891 0.2469135782>");
    EXPECT_EQ(slider("-123456789"), "<-246913578 -123456789 0>");
    for (const char* each : {"3 const", "4 uMap", "6 uB", "1 uV", "2 uU"})
        EXPECT_EQ(slider(each), "") << each;
}

TEST_F(CorrectionTest, CreatesShadersOfTheStageThatTheCommandSays) {
    beginAsEditor();
    const std::string text = "Vertex x.frag\nFragment flat.frag\nProgram A uTint {1 1 1 1}\nBox\n";
    for (const json& told : open("a.glib", text))
        for (const json& message : told.value("params", json()).value("diagnostics", json::array())) {
            const json made =
                ask("textDocument/codeAction", {{"textDocument", {{"uri", uri("a.glib")}}},
                                                {"range", message["range"]},
                                                {"context", {{"diagnostics", json::array({message})}}}});
            if (message["code"] == "file-E01") {
                EXPECT_NE(made.dump().find("gl_Position"), std::string::npos) << made.dump();
            }
        }
    EXPECT_EQ(corrections("a.glib", text), "Create x.frag; ");
}

TEST_F(CorrectionTest, ProposesAfterABlankOnlyWhatFollowsAFewStatements) {
    beginAsEditor();
    const auto count = [&](const std::string& text) {
        open("a.glib", text);
        json parameters = at("a.glib", text, "\n");
        parameters["context"] = {{"triggerKind", 2}, {"triggerCharacter", " "}};
        return ask("textDocument/completion", parameters)["items"].size();
    };
    EXPECT_EQ(count("Vertex \n"), 2U) << "flat.vert and shade.glsl";
    EXPECT_GT(count("Texture2D wide 64 64 \n"), 20U);
    EXPECT_EQ(count("Sphere \n"), 0U);
    EXPECT_EQ(count("Use \n"), 0U);
}

TEST_F(CorrectionTest, RegistersTheFormattingOfScenesAlone) {
    beginAsEditor();
    const std::vector<json> told = tell("initialized", json::object());
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told[0]["method"], "client/registerCapability");
    const json& of = told[0]["params"]["registrations"][0]["registerOptions"]["documentSelector"];
    EXPECT_EQ(of[0]["language"], "glib");
    EXPECT_EQ(of[1]["pattern"], "**/*.glib") << "for an editor that knows no language of the file";
    EXPECT_TRUE(say({{"id", "formatting"}, {"result", nullptr}}).empty()) << "the answer of the client";
}

TEST_F(CorrectionTest, ShowsEveryMistakeOfAStudentAtItsLine) {
    beginAsEditor();
    const std::string right =
        "#version 330\nuniform vec4 uTint;\nout vec4 c;\nfloat half2(float a) { return a * .5; }\n"  // 0 .. 3
        "void main() {\n    vec3 n = normalize(uTint.xyz);\n    c = vec4(n * half2(1.), 1.);\n}\n";  // 4 .. 7
    open("a.glib", kScene);
    struct Mistake {
        const char *from, *to;
        int line;
    };
    const Mistake mistakes[] = {{"xyz);", "xyz)", 5},
                                {"n * half2", "m * half2", 6},
                                {"vec3 n", "vec2 n", 5},
                                {"}\nvoid", "\nvoid", 4},
                                {"1.);\n}\n", "1.);\n", 6},
                                {"normalize", "normalise", 5},
                                {"half2(1.)", "half2(1., 2.)", 6},
                                {"uTint.xyz", "uTint.xyk", 5},
                                {"    vec3 n", "    uTint = c;\n    vec3 n", 5},
                                {"return a * .5;", "", 3},
                                {"uniform vec4", "#include \"nope.glsl\"\nuniform vec4", 1},
                                {"    vec3 n", "    float input = 1.;\n    vec3 n", 5},
                                {"    vec3 n", "    int i = 1.5;\n    vec3 n", 5},
                                {"    vec3 n", "    float n;\n    vec3 n", 6},
                                {"void main", "void mian", 0}};
    // In the file of a scene, and by itself.
    for (const char* name : {"flat.frag", "alone.frag"})
        for (const Mistake& each : mistakes) {
            EXPECT_EQ(messages(open(name, right), name).find(':'), std::string::npos) << name;
            std::string wrong = right;
            wrong.replace(wrong.find(each.from), std::string_view(each.from).size(), each.to);
            const std::string told = messages(open(name, wrong), name);
            EXPECT_NE(told.find(" " + std::to_string(each.line) + ":"), std::string::npos)
                << name << " " << each.to << " " << told;
        }
}

TEST_F(CorrectionTest, AsksTheFrontEndWhereThereIsNoDriver) {
    if (std::system("command -v glslangValidator > /dev/null") != 0) GTEST_SKIP() << "it is not installed";
    write("a.glib", kScene);
    EXPECT_TRUE(editor::checkScene(folder_ / "a.glib", {}, true).diagnostics.empty());
    const std::string shader = "#version 330\nuniform vec4 uTint;\nout vec4 c;\nvoid main() {\n";
    for (const char* line :
         {"c = uTint", "c = uTnt;", "vec2 a = uTint;", "c = abs(uTint, 1);", "uTint = c;", "c = uTint;\n"}) {
        write("flat.frag", shader + line + (std::string_view(line).ends_with("\n") ? "" : "\n}\n"));
        for (const char* file : {"a.glib", "flat.frag"}) {
            const editor::SceneCheck check = editor::checkScene(folder_ / file, {}, true);
            ASSERT_FALSE(check.diagnostics.empty()) << line;
            EXPECT_EQ(check.diagnostics[0].id, "glsl-E01");
            EXPECT_TRUE(check.diagnostics[0].place.file.ends_with("flat.frag"));
            EXPECT_NEAR(check.diagnostics[0].place.line, 5.5, 1) << toString(check.diagnostics);
            for (const char* each : {"terminated", "'main'"})
                EXPECT_EQ(toString(check.diagnostics).find(each), std::string::npos) << line;
        }
    }
    write("flat.frag", "#version 330\nuniform vec4 uTint;\nout vec4 c;\nvoid Main() { c = uTint; }\n");
    EXPECT_EQ(editor::checkScene(folder_ / "flat.frag", {}, true).diagnostics.size(), 1U) << "no main";
}

TEST_F(CorrectionTest, WaitsForNoCheck) {
    beginAsEditor();
    const auto tellOpen = [&](const std::string& text) {
        server_.receive(
            json({{"method", "textDocument/didOpen"},
                  {"params", {{"textDocument", {{"uri", uri("a.glib")}, {"version", 1}, {"text", text}}}}}})
                .dump());
        server_.answer();
    };
    tellOpen("Spere\n");
    const editor::LanguageServer::Work check = server_.beginWork();
    ASSERT_TRUE(check);
    EXPECT_FALSE(server_.hasWork());
    tellOpen("Sphere\n");
    EXPECT_TRUE(ask("textDocument/hover", at("a.glib", "Sphere", "Sphere")).is_object());
    server_.endWork(check());
    for (const json& each : hear())
        EXPECT_NE(each.dump().find("\"diagnostics\":[]"), std::string::npos) << each.dump();
}

}  // namespace
}  // namespace glibra::test
