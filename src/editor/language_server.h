#pragma once
// The language server: the texts that an editor has opened, the answers about them, and the messages of the
// client.

#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "editor/completion.h"
#include "editor/scene_check.h"
#include "editor/symbol.h"
#include "editor/text_range.h"

namespace glibra::editor {

// The texts that an editor has opened, with the names that it gives to their files.

struct TextPosition {
    std::size_t line = 0;
    std::size_t unit = 0;  ///< of UTF-16, in the line
    friend bool operator==(const TextPosition&, const TextPosition&) = default;
};

class TextLines {
  public:
    /// The text must outlive the object.
    explicit TextLines(std::string_view text);

    [[nodiscard]] std::size_t count() const { return begins_.size(); }
    /// Without its line end; empty beyond the last line.
    [[nodiscard]] TextRange line(std::size_t index) const;
    /// The place of a byte; the end of the text for bytes beyond it.
    [[nodiscard]] TextPosition position(std::size_t byte) const;
    /// The byte at a place; the end of its line, or of the text, for places beyond it.
    [[nodiscard]] std::size_t byte(TextPosition position) const;

  private:
    std::string_view text_;
    std::vector<std::size_t> begins_;
    std::vector<bool> isPlain_;  ///< for each line: all characters are one byte and one unit
};

/// The file of a URI: "file:///a%20b.glib" is /a b.glib, and where systems have shares,
/// "file://host/a/b.glib" is //host/a/b.glib. Another URI, as of a text without a name, is a file of the
/// current folder that need not exist.
std::filesystem::path fileOf(std::string_view uri);
std::string uriOf(const std::filesystem::path& file);

struct Document {
    std::string uri;
    std::filesystem::path file;
    std::string text;
    long long version = 0;
    CodeLanguage language = CodeLanguage::glib;
};

class Documents {
  public:
    /// The parameters of textDocument/didOpen, didChange and didClose (LSP 3.17). They throw json::exception
    /// if the parameters are not as they should be.
    const Document& open(const nlohmann::json& parameters);
    const Document* change(const nlohmann::json& parameters);
    void close(const std::string& uri);

    [[nodiscard]] const Document* find(const std::string& uri) const;
    [[nodiscard]] const Document* findFile(const std::filesystem::path& file) const;
    [[nodiscard]] const std::map<std::string, Document>& all() const { return documents_; }
    /// The text of a file as the editor has it, or else as it is saved; empty if it cannot be read.
    [[nodiscard]] std::string textOf(const std::filesystem::path& file) const;
    /// The URI of a file as the editor writes it.
    [[nodiscard]] std::string uriOf(const std::filesystem::path& file) const;

  private:
    std::map<std::string, Document> documents_;
};

TextPosition positionIn(const nlohmann::json& position);
nlohmann::json toJson(const TextPosition& position);
nlohmann::json toJson(const TextLines& lines, const TextRange& range);

// A server of the Language Server Protocol 3.17 for scenes and their shaders. It takes the messages of the
// client and returns the answers as texts; the caller reads and writes the streams.

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
    /// The document first, then the texts in which the symbol may mean the same: the shaders of the programs
    /// that it belongs to, what they include and what includes them, and their scenes. `files` are looked at
    /// besides those that are open, and those of checked scenes.
    [[nodiscard]] std::vector<SourceText> textsAround(const Document& document, const Symbol& symbol,
                                                      std::set<std::filesystem::path> files) const;
    struct SceneLinks;
    void addLinks(SceneLinks& links, const std::filesystem::path& scene, const Symbol& symbol) const;
    /// `isWide`: also in the files of the library around it, or of its own folder, that are not open.
    [[nodiscard]] Symbol symbolOf(const json& parameters, bool isWide = false) const;
    [[nodiscard]] json linkTo(const std::filesystem::path& file, std::string_view text,
                              const TextRange& place) const;
    /// True if the editor has opened the scene or a file of it.
    [[nodiscard]] bool isShown(const std::filesystem::path& scene, const SceneCheck& check) const;
    void changed(const Document& document);
    /// True for a file that the editor has opened as a shader.
    [[nodiscard]] bool isShader(const std::filesystem::path& file) const;
    [[nodiscard]] bool isInScene(const std::filesystem::path& shader) const;
    /// The scenes' folder of the library around a file, or else the folder of the file.
    static std::filesystem::path rootOf(const std::filesystem::path& file);
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

// The messages of a client of the language server: "Content-Length: N", an empty line, N bytes of JSON. A
// client may be cut off or wrong about the length; reading then goes on with the next header, unless the
// length is larger than any message.

class MessageReader {
  public:
    /// Bytes as they arrive, in pieces of any size.
    void add(std::string_view bytes) { bytes_ += bytes; }
    /// The next whole message; nothing until more bytes arrive.
    std::optional<std::string> next();
    /// The last message is no JSON. If a header stands in it, its length was wrong, and what begins with that
    /// header is read again.
    void refuse(std::string_view message);

    /// A header states more than kLargestMessage bytes. No further message is read: nobody knows where the
    /// next one begins.
    [[nodiscard]] bool isLost() const { return length_ && *length_ > kLargestMessage; }

    static constexpr std::size_t kLargestMessage = std::size_t{64} << 20U;

  private:
    std::string bytes_;
    std::optional<std::size_t> length_;  ///< of the message that `bytes_` begins with
};

/// The message with its header.
std::string framed(std::string_view message);

}  // namespace glibra::editor
