#pragma once
// A server of the Language Server Protocol 3.17 for scenes and their shaders. It takes the messages of the
// client and returns the answers as texts; the caller reads and writes the streams.

#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "editor/documents.h"
#include "editor/scene_check.h"
#include "editor/symbol.h"

namespace glibra::editor {

struct ServerOptions {
    std::vector<std::filesystem::path> libraryRoots{};
    std::string version{};
    /// Checks a scene, or a shader that none uses; the default is checkContained.
    std::function<ContainedCheck(const std::filesystem::path&, const RenderOptions&)> check{};
};

class LanguageServer {
  public:
    explicit LanguageServer(ServerOptions options);

    /// Takes a message of the client. Returns false, and answers with an error, if it is no
    /// JSON.
    bool receive(std::string_view message);
    /// Answers the messages that have been received, in their order.
    void answer();
    /// True if scenes have changed since they were checked.
    [[nodiscard]] bool hasWork() const { return !due_.empty(); }
    /// Checks one of them, and reports what is wrong with it and its shaders.
    void work();
    /// The same in two parts. What is returned by the first one may be called in another thread; the second
    /// one takes its result. Null if there is nothing to check.
    using Work = std::function<ContainedCheck()>;
    Work beginWork();
    void endWork(ContainedCheck checked);
    /// The answers and notifications made since the last call, a JSON text each.
    std::vector<std::string> takeOutput();
    /// The exit status, once the client has said `exit`: 0 after `shutdown`, otherwise 1.
    [[nodiscard]] std::optional<int> exitStatus() const { return exitStatus_; }
    /// The process of the client, if it has said which: the server ends with it.
    [[nodiscard]] std::optional<long long> clientProcess() const { return clientProcess_; }

  private:
    static constexpr std::size_t kMostTexts = 256;  // that are looked at for one answer
    using json = nlohmann::json;
    using Answer = json (LanguageServer::*)(const json& parameters);
    struct Method;
    static const Method* findMethod(std::string_view name);

    void send(const json& message);
    void fail(const json& id, int code, const std::string& text);
    void handle(const json& message);
    void request(const std::string& method, const json& id, const json& parameters);
    void notify(const std::string& method, const json& parameters);

    json initialize(const json& parameters);
    json shutDown(const json& parameters);
    json complete(const json& parameters);
    json hover(const json& parameters);
    json definition(const json& parameters);
    json symbols(const json& parameters);
    json colors(const json& parameters);
    json colorPresentations(const json& parameters);
    json format(const json& parameters);
    json links(const json& parameters);
    json references(const json& parameters);
    json highlights(const json& parameters);
    json prepareRename(const json& parameters);
    json rename(const json& parameters);
    json signatures(const json& parameters);
    json actions(const json& parameters);
    json folds(const json& parameters);
    json tokens(const json& parameters);
    json hints(const json& parameters);
    json findSymbols(const json& parameters);

    [[nodiscard]] const Document& documentOf(const json& parameters) const;
    [[nodiscard]] CodeContext contextOf(const Document& document) const;
    /// The file that a scene or shader names.
    [[nodiscard]] std::filesystem::path found(CodeLanguage language, const std::filesystem::path& from,
                                              const std::string& name) const;
    /// The files that it includes, and the same with what these include, and so on, and itself.
    [[nodiscard]] std::vector<std::filesystem::path> includesOf(const std::filesystem::path& file) const;
    [[nodiscard]] std::set<std::filesystem::path> withIncludes(const std::filesystem::path& file) const;
    /// The document first, then the texts in which a name of it may mean the same: the shaders of the
    /// programs that it belongs to, what they include, and their scenes.
    [[nodiscard]] std::vector<SourceText> textsAround(const Document& document,
                                                      const std::string& name) const;
    [[nodiscard]] Symbol symbolOf(const json& parameters) const;
    [[nodiscard]] json linkTo(const std::filesystem::path& file, std::string_view text,
                              const TextRange& place) const;
    /// True if the editor has opened the scene or a file of it.
    [[nodiscard]] bool isShown(const std::filesystem::path& scene, const SceneCheck& check) const;
    void changed(const Document& document);
    /// True for a file that the editor has opened as a shader.
    [[nodiscard]] bool isShader(const std::filesystem::path& file) const;
    [[nodiscard]] bool isInScene(const std::filesystem::path& shader) const;
    /// Scenes that are not open and use the shader: those of the folders of the library around it.
    void findScenesOf(const Document& shader);
    void report(const std::filesystem::path& scene, const SceneCheck& check);
    void publish(const std::set<std::filesystem::path>& files);
    void forget(const std::filesystem::path& scene);

    ServerOptions options_;
    Documents documents_;
    std::vector<json> waiting_;
    std::set<std::string> cancelled_;  ///< ids of requests, as JSON texts
    std::vector<std::string> output_;
    std::set<std::filesystem::path> due_;                 ///< scenes to check, and shaders that may have none
    std::map<std::filesystem::path, SceneCheck> checks_;  ///< of these
    std::set<std::filesystem::path> published_;           ///< files with messages
    std::filesystem::path working_;                       ///< what beginWork() has begun
    bool formatsByLanguage_ = false;  ///< the client can be told which files are formatted
    bool createsFiles_ = false;       ///< the client can create files
    bool isInitialized_ = false;
    bool isShutDown_ = false;
    std::optional<int> exitStatus_;
    std::optional<long long> clientProcess_;
};

/// The kinds of semantic tokens, as the client is told.
nlohmann::json tokenLegend();

}  // namespace glibra::editor
