#pragma once
// A language server without a process, in a folder with a scene and its shaders.

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "editor/language_server.h"

namespace glibra::test {

namespace fs = std::filesystem;
using nlohmann::json;

/// A folder with a scene and a shader.
class ServerTest : public testing::Test {
  protected:
    ServerTest()
        : folder_(fs::temp_directory_path() /
                  ("glibra-editor-" + std::to_string(::getpid()) + "-" +
                   testing::UnitTest::GetInstance()->current_test_info()->name())),
          server_({.version = "1", .check = [](const fs::path& scene, const RenderOptions& options) {
                       return editor::ContainedCheck{editor::checkScene(scene, options), {}};
                   }}) {
        fs::create_directories(folder_);
        write("flat.vert",
              "#version 330\nin vec4 aVertex;\nvoid main() { gl_Position = uModelViewProjectionMatrix * "
              "aVertex; }\n");
        write("flat.frag",
              "#version 330\n#include \"shade.glsl\"\nuniform vec4 uTint;\nout vec4 fColor;\n"
              "void main() { fColor = shade(uTint); }\n");
        write("shade.glsl", "// shades\nvec4 shade(vec4 tint) { return tint * .5; }\n");
    }
    ~ServerTest() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    void write(const char* name, std::string_view text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    [[nodiscard]] std::string uri(const char* name) const { return editor::uriOf(folder_ / name); }

    /// What the server says of the message, with all that it has to do.
    std::vector<json> say(const json& message) {
        server_.receive(message.dump());
        return hear();
    }
    std::vector<json> hear() {
        server_.answer();
        while (server_.hasWork()) server_.work();
        std::vector<json> heard;
        for (const std::string& each : server_.takeOutput()) heard.push_back(json::parse(each));
        return heard;
    }
    json ask(const char* method, const json& parameters) {
        for (const json& each :
             say({{"jsonrpc", "2.0"}, {"id", 7}, {"method", method}, {"params", parameters}}))
            if (each.contains("id")) return each.contains("result") ? each["result"] : each;
        return "no answer";
    }
    std::vector<json> tell(const char* method, const json& parameters) {
        return say({{"jsonrpc", "2.0"}, {"method", method}, {"params", parameters}});
    }
    void begin() { ask("initialize", {{"processId", nullptr}, {"capabilities", json::object()}}); }
    std::vector<json> open(const char* name, std::string_view text) {
        return tell(
            "textDocument/didOpen",
            {{"textDocument",
              {{"uri", uri(name)}, {"languageId", "x"}, {"version", 1}, {"text", std::string(text)}}}});
    }
    /// The parameters of a request at the first byte of a word in the text.
    [[nodiscard]] json at(const char* name, std::string_view text, std::string_view word,
                          std::size_t further = 0) const {
        const editor::TextLines lines(text);
        return {{"textDocument", {{"uri", uri(name)}}},
                {"position", editor::toJson(lines.position(text.find(word) + further))}};
    }
    /// "id line:unit" of the messages about a file, from what was heard.
    [[nodiscard]] std::string messages(const std::vector<json>& heard, const char* name) const {
        std::string text = "none";
        for (const json& each : heard) {
            if (each.value("method", "") != "textDocument/publishDiagnostics" ||
                each["params"]["uri"] != uri(name))
                continue;
            text.clear();
            for (const json& message : each["params"]["diagnostics"])
                text += message["code"].get<std::string>() + " " +
                        std::to_string(message["range"]["start"]["line"].get<int>()) + ":" +
                        std::to_string(message["range"]["start"]["character"].get<int>()) + "; ";
        }
        return text;
    }

    fs::path folder_;
    editor::LanguageServer server_;
};

inline constexpr std::string_view kScene =
    "Vertex flat.vert\nFragment flat.frag\nProgram Flat uTint {1 .5 0 1}\nLet size <0 1 2>\nBox (size)\n";

/// A server that asks a driver, as the program does.
class DrivenServerTest : public ServerTest {
  protected:
    DrivenServerTest() { server_ = editor::LanguageServer({.version = "1"}); }
};

}  // namespace glibra::test
