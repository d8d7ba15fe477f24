// The language server without a process: the messages of a client and the answers to them.

#include "editor/language_server.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "../fuzz/random.h"
#include "editor/scene_places.h"
#include "example_scenes.h"
#include "server_test.h"

namespace glibra::test {
namespace {

using editor::LanguageServer;

TEST_F(ServerTest, ReportsMistakesOfASceneWhileItIsWritten) {
    begin();
    EXPECT_EQ(messages(open("a.glib", kScene), "a.glib"), "");
    EXPECT_EQ(
        messages(tell("textDocument/didChange",
                      {{"textDocument", {{"uri", uri("a.glib")}, {"version", 2}}},
                       {"contentChanges", json::array({{{"range",
                                                         {{"start", {{"line", 4}, {"character", 0}}},
                                                          {"end", {{"line", 4}, {"character", 3}}}}},
                                                        {"text", "\"\xc3\xa4\xf0\x9f\x98\x80\" Bxo"}}})}}),
                 "a.glib"),
        "glib-E01 4:0; ");
    EXPECT_EQ(messages(tell("textDocument/didChange",
                            {{"textDocument", {{"uri", uri("a.glib")}, {"version", 3}}},
                             {"contentChanges", json::array({{{"text", std::string(kScene)}}})}}),
                       "a.glib"),
              "");
}

TEST_F(ServerTest, ReportsMistakesOfUnsavedShadersInTheirOwnFiles) {
    begin();
    open("a.glib", kScene);
    const auto heard = open("flat.frag",
                            "#version 330\nuniform vec4 uTint;\nout vec4 fColor;\nin vec3 vNo;\n"
                            "void main() { fColor = uTint + vec4(vNo, 0); }\n");
    EXPECT_NE(messages(heard, "flat.frag").find("glsl-W11 3:8"), std::string::npos)
        << messages(heard, "flat.frag");
    const auto closed = tell("textDocument/didClose", {{"textDocument", {{"uri", uri("flat.frag")}}}});
    EXPECT_EQ(messages(closed, "flat.frag"), "") << "the saved text is right";
}

TEST_F(ServerTest, ReportsMissingIncludesAndErrorLinesAsDriversDo) {
    write("bad.glsl", "\n#error bad.glsl is bad\n");
    begin();
    open("a.glib", kScene);
    const std::string shader =
        "#version 330\n/* the line of a comment\n#error none\n*/\n#include \"nope.h\"\n#ifdef NOT\n#error "
        "none\n"
        "#else\n  # error of this \\\nshader\n#endif\n#include \"bad.glsl\"\nout vec4 c;\n"
        "void main() { c = vec4(1); }\n";
    const auto heard = open("flat.frag", shader);
    EXPECT_EQ(messages(heard, "flat.frag"), "glsl-E01 4:0; glsl-E01 8:2; ");
    EXPECT_EQ(messages(heard, "bad.glsl"), "glsl-E01 1:0; ");
    const auto hasText = [&](std::string_view text) {
        return std::ranges::any_of(
            heard, [&](const json& each) { return each.dump().find(text) != std::string::npos; });
    };
    EXPECT_TRUE(hasText("\"cannot find the included file 'nope.h'\""));
    EXPECT_TRUE(hasText("\"bad.glsl is bad\""));
    EXPECT_TRUE(hasText("in Program 'Flat'"));
}

TEST_F(ServerTest, TakesTheStageOfAnUnusedShaderFromItsSuffix) {
    begin();
    const std::string shader = "#version 330\nvoid main() { x }\n";
    const auto has = [&](const char* name, std::string_view begin, const char* word) {
        std::string text = shader;
        text.replace(text.find('x'), 1, begin);
        open(name, text);
        const json answer = ask("textDocument/completion", at(name, text, begin, begin.size()));
        return std::ranges::any_of(answer["items"], [&](const json& each) { return each["label"] == word; });
    };
    EXPECT_FALSE(has("y.frag", "Emit", "EmitVertex"));
    EXPECT_TRUE(has("y.geom", "Emit", "EmitVertex"));
    EXPECT_FALSE(has("y.vert", "gl_Frag", "gl_FragCoord"));
    EXPECT_FALSE(has("y.vert", "disc", "discard"));
    EXPECT_TRUE(has("y.frag", "disc", "discard"));
    EXPECT_TRUE(has("y.glsl", "disc", "discard")) << "any stage may include it";
}

TEST_F(ServerTest, FindsTheSceneOfAShader) {
    write("a.glib", kScene);
    begin();
    const auto heard =
        open("flat.frag", "#version 330\nin vec3 vNo;\nout vec4 c;\nvoid main() { c = vec4(vNo, 1); }\n");
    EXPECT_NE(messages(heard, "flat.frag").find(" 1:"), std::string::npos) << messages(heard, "flat.frag");
}

TEST_F(ServerTest, CompletesCommandsKeysNamesAndUniforms) {
    begin();
    const std::string scene = std::string(kScene) + "Sph\nProgram Flat uT\nTranslate (si\n";
    open("a.glib", scene);
    const auto labels = [](const json& answer) {
        std::string all;
        for (const json& each : answer["items"]) all += each["label"].get<std::string>() + " ";
        return all;
    };
    EXPECT_TRUE(labels(ask("textDocument/completion", at("a.glib", scene, "Sph", 3))).starts_with("Sphere "));
    EXPECT_NE(labels(ask("textDocument/completion", at("a.glib", scene, "uT\n", 2))).find("uTint"),
              std::string::npos);
    const std::string inside = labels(ask("textDocument/completion", at("a.glib", scene, "(si\n", 3)));
    EXPECT_NE(inside.find("size "), std::string::npos) << inside;
    EXPECT_NE(inside.find("sin "), std::string::npos) << inside;
    const std::string shader = "#version 330\nvoid main() { smoo }\n";
    open("flat.frag", shader);
    const json answer = ask("textDocument/completion", at("flat.frag", shader, "smoo", 4));
    EXPECT_TRUE(labels(answer).starts_with("smooth")) << labels(answer);
    EXPECT_EQ(answer["items"][0]["textEdit"]["range"]["start"]["character"], 14);
}

TEST_F(ServerTest, ExplainsTheWordUnderTheMouse) {
    begin();
    open("a.glib", kScene);
    const std::string command =
        ask("textDocument/hover", at("a.glib", kScene, "Box"))["contents"]["value"].get<std::string>();
    EXPECT_NE(command.find("Box"), std::string::npos) << command;
    const std::string shader = "#version 330\nuniform vec4 uTint;\nvoid main() { mix(uTint, uTint, .5); }\n";
    open("flat.frag", shader);
    const std::string function =
        ask("textDocument/hover", at("flat.frag", shader, "mix"))["contents"]["value"].get<std::string>();
    EXPECT_NE(function.find("T mix(T x, T y, T a)"), std::string::npos) << function;
    const std::string uniform =
        ask("textDocument/hover", at("flat.frag", shader, "uTint"))["contents"]["value"].get<std::string>();
    EXPECT_NE(uniform.find("uniform vec4 uTint"), std::string::npos) << uniform;
    EXPECT_NE(uniform.find("{1 0.5 0 1}"), std::string::npos) << uniform;
    EXPECT_TRUE(ask("textDocument/hover", at("a.glib", kScene, "<0")).is_null());
}

TEST_F(ServerTest, GoesToFilesAndDeclarations) {
    begin();
    open("a.glib", kScene);
    EXPECT_EQ(ask("textDocument/definition", at("a.glib", kScene, "flat.vert", 2))["uri"], uri("flat.vert"));
    const json variable = ask("textDocument/definition", at("a.glib", kScene, "size)"));
    EXPECT_EQ(variable["range"]["start"]["line"], 3);
    const json uniform = ask("textDocument/definition", at("a.glib", kScene, "uTint"));
    EXPECT_EQ(uniform["uri"], uri("flat.frag"));
    EXPECT_EQ(uniform["range"]["start"], json({{"line", 2}, {"character", 13}}));
    const std::string shader = textOf(folder_ / "flat.frag");
    open("flat.frag", shader);
    const json function = ask("textDocument/definition", at("flat.frag", shader, "shade(uT"));
    EXPECT_EQ(function["uri"], uri("shade.glsl"));
    EXPECT_EQ(function["range"]["start"], json({{"line", 1}, {"character", 5}}));
    EXPECT_EQ(ask("textDocument/definition", at("flat.frag", shader, "shade.glsl"))["uri"],
              uri("shade.glsl"));
    EXPECT_TRUE(ask("textDocument/definition", at("flat.frag", shader, "void")).is_null());
    EXPECT_EQ(ask("textDocument/documentLink", {{"textDocument", {{"uri", uri("a.glib")}}}}).size(), 2U);
}

TEST_F(ServerTest, ListsSymbolsAndColors) {
    begin();
    open("a.glib", kScene);
    const json document = {{"textDocument", {{"uri", uri("a.glib")}}}};
    std::string names;
    for (const json& each : ask("textDocument/documentSymbol", document))
        names += each["name"].get<std::string>() + " ";
    EXPECT_EQ(names, "Flat size ");
    const json colors = ask("textDocument/documentColor", document);
    ASSERT_EQ(colors.size(), 1U);
    EXPECT_EQ(colors[0]["color"]["green"], .5);
    const json shown = ask("textDocument/colorPresentation",
                           {{"textDocument", document["textDocument"]},
                            {"range", colors[0]["range"]},
                            {"color", {{"red", 0}, {"green", .25}, {"blue", 1}, {"alpha", 1}}}});
    EXPECT_EQ(shown[0]["label"], "{0 .25 1 1}");
}

TEST(ColorText, IsWrittenAsTheColorBefore) {
    EXPECT_EQ(editor::colorText({1, 1. / 3, 0, 1}, "{.5 .5 .5}"), "{1 .333 0}");
    EXPECT_EQ(editor::colorText({1, .5, 0, .5}, "{.5 .5 .5}"), "{1 .5 0 .5}");
    EXPECT_EQ(editor::colorText({2, -1, .1, 1}, ".5 .5 .5"), "1 0 .1");
}

TEST(ColorsOf, FindsColorsOfStatementsAndTags) {
    std::string found;
    const std::string scene =
        "Color .1 .2 .3\nBackground 1 0 0 .5\nProgram A uA {.5 .5 .5} uB [1 1 1] uC {2 0 0} uD {1 1}\n"
        "# {1 1 1}\nLet c {0 1 0}\nFragment inline\nvec3 a[3] = { 1, 1, 1 };\nEndFragment\n";
    for (const editor::WrittenColor& each : editor::colorsOf(scene))
        found += scene.substr(each.place.begin, each.place.end - each.place.begin) + "; ";
    EXPECT_EQ(found, ".1 .2 .3; 1 0 0 .5; {.5 .5 .5}; {0 1 0}; ");
}

TEST_F(ServerTest, FormatsByOneEdit) {
    begin();
    open("a.glib", "Sphere\nGroup\nbox\nEndGroup\nCone\n");
    const json edits = ask(
        "textDocument/formatting",
        {{"textDocument", {{"uri", uri("a.glib")}}}, {"options", {{"tabSize", 8}, {"insertSpaces", true}}}});
    ASSERT_EQ(edits.size(), 1U);
    EXPECT_EQ(edits[0]["newText"], "    Box\n");
    EXPECT_EQ(edits[0]["range"],
              json({{"start", {{"line", 2}, {"character", 0}}}, {"end", {{"line", 3}, {"character", 0}}}}));
}

TEST_F(ServerTest, RefusesWhatIsNoRequestInThisState) {
    const auto code = [&](const json& message) {
        const std::vector<json> heard = say(message);
        return heard.empty() || !heard[0].contains("error") ? 0 : heard[0]["error"]["code"].get<int>();
    };
    EXPECT_EQ(code({{"id", 1}, {"method", "textDocument/hover"}}), -32002);
    begin();
    EXPECT_EQ(code({{"id", 2}, {"method", "initialize"}}), -32600);
    EXPECT_EQ(code({{"id", "x"}, {"method", "textDocument/nothing"}}), -32601);
    EXPECT_EQ(code({{"method", "textDocument/nothing"}}), 0) << "unknown notifications are ignored";
    EXPECT_EQ(code({{"id", 3}, {"method", "textDocument/hover"}, {"params", {{"textDocument", 5}}}}), -32602);
    EXPECT_EQ(code({{"id", 3}, {"method", "textDocument/hover"}, {"params", nullptr}}), -32602);
    EXPECT_EQ(code(json::array({1})), -32600);
    EXPECT_EQ(code({{"id", 4}, {"result", nullptr}}), 0) << "an answer";
    EXPECT_EQ(code({{"id", 5}, {"method", "shutdown"}}), 0);
    EXPECT_EQ(code({{"id", 6}, {"method", "shutdown"}}), -32600);
    EXPECT_FALSE(server_.exitStatus());
    say({{"method", "exit"}});
    EXPECT_EQ(server_.exitStatus(), 0);
}

TEST_F(ServerTest, HasAnErrorAsStatusIfTheClientDoesNotShutDown) {
    say({{"method", "exit"}});
    EXPECT_EQ(server_.exitStatus(), 1);
}

TEST_F(ServerTest, CancelsRequestsThatWait) {
    begin();
    open("a.glib", kScene);
    json message = at("a.glib", kScene, "Box");
    server_.receive(json({{"id", 9}, {"method", "textDocument/hover"}, {"params", message}}).dump());
    server_.receive(json({{"method", "$/cancelRequest"}, {"params", {{"id", 9}}}}).dump());
    const std::vector<json> heard = hear();
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(heard[0]["error"]["code"], -32800);
}

TEST_F(ServerTest, ReadsBytesThatAreNoUtf8AndRefusesWhatIsNoJson) {
    begin();
    EXPECT_FALSE(server_.receive("{\"id\": 1"));
    EXPECT_FALSE(server_.receive(std::string(100'000, '[')));
    EXPECT_FALSE(server_.receive(""));
    std::string text =
        json({{"method", "textDocument/didOpen"},
              {"params", {{"textDocument", {{"uri", uri("b.glib")}, {"version", 1}, {"text", "Bxo @@\n"}}}}}})
            .dump();
    text.replace(text.find("@@"), 2, "\xff\xc3");
    EXPECT_TRUE(server_.receive(text));
    EXPECT_EQ(messages(hear(), "b.glib"), "glib-E01 0:0; ");
}

TEST_F(ServerTest, TakesHugeTexts) {
    begin();
    std::string large = "Sphere\n";
    while (large.size() < (5U << 20U)) large += large;
    EXPECT_EQ(messages(open("a.glib", large), "a.glib"), "glib-E15 0:0; ");
    EXPECT_TRUE(ask("textDocument/formatting", {{"textDocument", {{"uri", uri("a.glib")}}}}).empty());
    EXPECT_TRUE(ask("textDocument/hover", at("a.glib", "Sphere", "Sphere")).is_object());
}

TEST_F(ServerTest, SurvivesAnyMessage) {
    begin();
    open("a.glib", kScene);
    open("flat.frag", textOf(folder_ / "flat.frag"));
    fuzz::Random random(3);
    constexpr const char* kMethods[] = {"completion",         "hover",     "definition",    "documentSymbol",
                                        "documentColor",      "didChange", "documentLink",  "formatting",
                                        "colorPresentation",  "didOpen",   "didClose",      "didSave",
                                        "references",         "rename",    "prepareRename", "codeAction",
                                        "documentHighlight",  "inlayHint", "foldingRange",  "signatureHelp",
                                        "semanticTokens/full"};
    const auto value = [&](auto& self, int depth) -> json {
        switch (random.below(depth > 0 ? 8 : 5)) {
            case 0:
                return nullptr;
            case 1:
                return static_cast<long long>(random.next());
            case 2:
                return static_cast<int>(random.below(40)) - 3;
            case 3:
                return uri(random.oneIn(2) ? "a.glib" : "flat.frag");
            case 4:
                return "Bo\x01\n#\"(";
            case 5:
                return json::array({self(self, depth - 1), self(self, depth - 1)});
            default: {
                json object = json::object();
                for (const char* key :
                     {"textDocument", "uri", "text", "position", "line", "character", "range", "start", "end",
                      "contentChanges", "color", "version", "context", "diagnostics", "message", "newName"})
                    if (random.oneIn(3)) object[key] = self(self, depth - 1);
                return object;
            }
        }
    };
    for (int i = 0; i < 400; ++i) {
        json message = {{"method", std::string("textDocument/") + random.oneOf(kMethods)}};
        if (random.oneIn(2)) message["id"] = value(value, 1);
        json parameters = value(value, 3);
        if (parameters.is_object() && random.oneIn(2)) {
            parameters["textDocument"] = {{"uri", uri("a.glib")}};
            parameters["position"] = {{"line", random.below(9)}, {"character", random.below(90)}};
        }
        message["params"] = parameters;
        say(message);
    }
    EXPECT_TRUE(
        ask("textDocument/documentSymbol", {{"textDocument", {{"uri", uri("no")}}}}).contains("error"));
}

TEST_F(DrivenServerTest, ReportsMistakesOfGlslAtTheUsersLines) {
    const std::string right =
        "#version 330\nuniform vec4 uTint;\nout vec4 fColor;\nvoid main() {\n    float a = uTint.x;\n    "
        "fColor = "
        "vec4(a);\n}\n";
    const std::pair<std::string, std::string> mistakes[] = {
        {"uTint.x;", "uTint.x"}, {"vec4(a)", "vec4(b)"},      {"float a", "int a"},
        {";\n}\n", ";\n"},       {"vec4 uTint", "vec4 uTnt"}, {"void main", "this is no GLSL"}};
    begin();
    EXPECT_EQ(messages(open("a.glib", kScene), "a.glib"), "");
    EXPECT_EQ(messages(open("flat.frag", right), "flat.frag"), "none");
    for (const auto& [from, to] : mistakes) {
        std::string wrong = right;
        wrong.replace(wrong.find(from), from.size(), to);
        EXPECT_EQ(messages(open("flat.frag", wrong), "flat.frag").find("glsl-E01 "), 0U) << wrong;
        EXPECT_EQ(messages(open("flat.frag", right), "flat.frag"), "");
    }
    std::string renamed = right;
    for (std::size_t at = 0; (at = renamed.find("uTint", at)) != std::string::npos; at += 5)
        renamed.erase(at + 2, 1);
    EXPECT_EQ(messages(open("flat.frag", renamed), "a.glib").find("glib-W23 2:13"), 0U);
}

TEST_F(DrivenServerTest, ChecksAShaderThatNoSceneNamesByItself) {
    begin();
    const std::pair<const char*, std::string> shaders[] = {
        {"x.vert",
         "#version 330\nin vec3 aPlace;\nout vec3 vPlace;\nvoid main() { gl_Position = vec4(aPlace, 1.); "
         "vPlace = aPlace; }\n"},
        {"x.frag",
         "#version 330\nin vec3 vPlace;\nuniform float uA;\nout vec4 fColor;\nvoid main() { fColor = "
         "vec4(vPlace * uA, 1.); }\n"},
        {"old.frag", "varying vec3 vPlace;\nvoid main() { gl_FragColor = vec4(vPlace, 1.); }\n"},
        {"x.geom",
         "#version 330\nlayout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\nin vec3 "
         "vPlace[];\nvoid main() { gl_Position = vec4(vPlace[0], 1.); EmitVertex(); }\n"},
        {"x.tesc",
         "#version 410\nlayout(vertices = 3) out;\nvoid main() { gl_out[gl_InvocationID].gl_Position = "
         "gl_in[gl_InvocationID].gl_Position; gl_TessLevelOuter[0] = 1.; }\n"},
        {"x.tese",
         "#version 410\nlayout(triangles) in;\nvoid main() { gl_Position = gl_in[0].gl_Position; }\n"},
        {"x.comp",
         "#version 430\nlayout(local_size_x = 1) in;\nlayout(std430) buffer Sums { float sums[]; };\nvoid "
         "main() { sums[0] = 1.; }\n"}};
    for (const auto& [name, text] : shaders) {
        const std::string right = text.starts_with("#version") ? "" : "glsl-W01 0:0; ";
        EXPECT_EQ(messages(open(name, text), name), right) << name;
        std::string wrong = text;
        wrong.insert(wrong.rfind("; }"), " + nothing");
        EXPECT_EQ(messages(open(name, wrong), name).find("glsl-E01 "), right.size()) << name;
        EXPECT_NE(messages(open(name, "#if 1\n" + text), name), "") << name;
    }
}

TEST_F(ServerTest, GoesToTheDeclarationOfTheScope) {
    begin();
    const std::string shader =
        "#version 330\nuniform float b;\nstruct S { float a; float b; };\n"  // 1, 2
        "float f(float a) { float b = a; return b; }\n"                      // 3
        "float g(float b) { { float b = 1.; b += 1.; } return b; }\n"        // 4
        "out vec4 c;\nvoid main() {\n    S s = S(1., 2.);\n"                 // 5, 6, 7
        "    for (int b = 0; b < 3; ++b) c += vec4(f(s.b));\n"               // 8
        "    c += vec4(b /*global*/);\n}\n";                                 // 9
    open("y.frag", shader);
    const auto lineOf = [&](std::string_view word, std::size_t further = 0) {
        return ask("textDocument/definition", at("y.frag", shader, word, further))["range"]["start"];
    };
    EXPECT_EQ(lineOf("b; }\nfloat g"), json({{"line", 3}, {"character", 25}}));
    EXPECT_EQ(lineOf("b += 1."), json({{"line", 4}, {"character", 27}}));
    EXPECT_EQ(lineOf("b; }\nout"), json({{"line", 4}, {"character", 14}}));
    EXPECT_EQ(lineOf("b < 3"), json({{"line", 8}, {"character", 13}}));
    EXPECT_EQ(lineOf("s.b", 2), json({{"line", 2}, {"character", 26}}));
    EXPECT_EQ(lineOf("b /*global*/"), json({{"line", 1}, {"character", 14}}));
    EXPECT_EQ(lineOf("a; return"), json({{"line", 3}, {"character", 14}}));
}

TEST_F(ServerTest, QuotesNoExceptionInItsErrors) {
    begin();
    for (const json& parameters : {json::object(), json::array(), json(5), json{{"textDocument", 3}}})
        for (const char* method :
             {"textDocument/hover", "textDocument/definition", "textDocument/formatting"}) {
            const std::string answer = ask(method, parameters).dump();
            EXPECT_EQ(answer.find("exception"), std::string::npos) << answer;
            EXPECT_NE(answer.find(method), std::string::npos) << answer;
        }
}

TEST(SceneCheck, HasNothingToSayOfTheScenesOfTheProject) {
    const std::vector<fs::path> scenes = exampleScenes();
    for (std::size_t i = 0; i < scenes.size(); i += 4) {
        if (scenes[i].string().find("scenes/expectations") != std::string::npos) continue;
        for (const Diagnostic& each : editor::checkScene(scenes[i], {}, i % 40 == 0).diagnostics)
            EXPECT_EQ(each.severity, Severity::note) << toString(each);
    }
}

TEST(SceneCheck, EndsWithItsProcess) {
    const fs::path scene = fs::path(GLIBRA_SOURCE_DIR) / "glib/start/teapot.glib";
    RenderOptions options;
    options.texts[scene] =
        "Let a <0 1 2>\nBxo\nVertex glaze.vert\nFragment glaze.frag\nProgram Glaze uA 1\nTeapot\n";
    const editor::ContainedCheck contained = editor::checkContained(scene, options);
    const editor::SceneCheck here = editor::checkScene(scene, options);
    EXPECT_EQ(contained.failure, "");
    EXPECT_EQ(toString(contained.check.diagnostics), toString(here.diagnostics));
    EXPECT_EQ(contained.check.files, here.files);
    ASSERT_EQ(contained.check.names.programs.size(), 1U);
    EXPECT_EQ(contained.check.names.programs[0].stages.size(), 2U);
    EXPECT_EQ(contained.check.names.values.size(), here.names.values.size());
}

TEST(TextLines, CountsUnitsOfUtf16) {
    const std::string text = "a\xc3\xa4\xf0\x9f\x98\x80z\r\nb\rc\n\xff\xffx";
    const editor::TextLines lines(text);
    ASSERT_EQ(lines.count(), 4U);
    EXPECT_EQ(lines.position(text.find('z')), (editor::TextPosition{0, 4}));
    EXPECT_EQ(lines.byte({0, 4}), text.find('z'));
    EXPECT_EQ(lines.byte({0, 3}), text.find('\xf0')) << "inside of a pair";
    EXPECT_EQ(lines.byte({0, 99}), text.find('\r'));
    EXPECT_EQ(lines.byte({9, 0}), text.size());
    EXPECT_EQ(lines.position(text.find('x')), (editor::TextPosition{3, 2}));
    for (const char* each : {"a", "z", "b", "c", "x"}) {
        const std::size_t byte = text.find(each);
        EXPECT_EQ(lines.byte(lines.position(byte)), byte) << each;
    }
}

TEST(MessageReader, ReadsMessagesInPiecesOfAnySize) {
    const std::string bytes =
        editor::framed("{\"a\":1}") + "Content-Type: x\r\ncontent-length:2\r\n\r\n{}" + editor::framed("[]");
    for (std::size_t size = 1; size <= bytes.size(); ++size) {
        editor::MessageReader reader;
        std::string all;
        for (std::size_t at = 0; at < bytes.size(); at += size) {
            reader.add(std::string_view(bytes).substr(at, size));
            while (const auto message = reader.next()) all += *message + ";";
        }
        EXPECT_EQ(all, "{\"a\":1};{};[];") << size;
    }
}

TEST(MessageReader, FindsTheNextMessageAfterAWrongLength) {
    for (const char* wrong :
         {"Content-Length: 3\r\n\r\n{\"a\":1}", "Content-Length: 20\r\n\r\n{\"a\":1}",
          "Content-Length: x\r\n\r\n", "nonsense\r\n\r\n", "Content-Length: -1\r\n\r\n{}"}) {
        editor::MessageReader reader;
        std::string all;
        reader.add(wrong);
        for (int i = 0; i < 3; ++i) reader.add(editor::framed("{\"b\":2}"));
        while (const auto message = reader.next()) {
            if (json::parse(*message, nullptr, false).is_discarded())
                reader.refuse(*message);
            else
                all += *message;
        }
        EXPECT_NE(all.find("{\"b\":2}"), std::string::npos) << wrong;
        EXPECT_FALSE(reader.isLost()) << wrong;
    }
}

TEST(Uris, AreFilesAndBack) {
    const std::filesystem::path file = editor::fileOf("file:///a%20b/%C3%A4.glib");
    EXPECT_TRUE(file.generic_string().ends_with("/a b/\xc3\xa4.glib")) << file;
    EXPECT_TRUE(editor::uriOf(file).ends_with("/a%20b/%C3%A4.glib")) << editor::uriOf(file);
    EXPECT_EQ(editor::fileOf("file://localhost/a.glib"), editor::fileOf("file:///a.glib"));
    const bool hasShares = std::filesystem::path("//server").has_root_name();
    const std::filesystem::path shared = editor::fileOf("file://server/share/a%20b.glib");
    EXPECT_EQ(shared.generic_string(), hasShares ? "//server/share/a b.glib" : "/share/a b.glib");
    if (hasShares) {
        EXPECT_EQ(editor::uriOf(shared), "file://server/share/a%20b.glib");
        EXPECT_EQ(editor::fileOf("file://wsl%24/Debian/a.glib").generic_string(), "//wsl$/Debian/a.glib");
    }
}

TEST(MessageReader, IsLostAfterALengthThatNoMessageHas) {
    for (const char* length : {"67108865", "99999999999", "99999999999999999999999999"}) {
        editor::MessageReader reader;
        reader.add(editor::framed("{}") + "Content-Length: " + length + "\r\n\r\n" + editor::framed("[]"));
        EXPECT_EQ(reader.next(), "{}") << length;
        EXPECT_FALSE(reader.next()) << length;
        EXPECT_TRUE(reader.isLost()) << length;
        reader.add(editor::framed("[]"));
        EXPECT_FALSE(reader.next()) << length;
    }
}

}  // namespace
}  // namespace glibra::test
