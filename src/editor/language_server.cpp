#include "editor/language_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <system_error>
#include <utility>

#include "base/utf8.h"
#include "glib/text.h"
#include "suite/file/selection.h"

namespace glibra::editor {
namespace {

using nlohmann::json;

// Codes of errors (JSON-RPC 2.0 and LSP 3.17).
constexpr int kParseError = -32700, kInvalidRequest = -32600, kMethodNotFound = -32601,
              kInvalidParameters = -32602, kInternalError = -32603, kNotInitialized = -32002,
              kRequestCancelled = -32800;

/// How deep arrays and objects are nested.
std::size_t nestingOf(std::string_view text) {
    std::size_t depth = 0, most = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (c == '"') {
            for (++at; at < text.size() && text[at] != '"'; ++at)
                if (text[at] == '\\') ++at;
        } else if (c == '[' || c == '{') {
            most = std::max(most, ++depth);
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return most;
}

}  // namespace

struct LanguageServer::Method {
    std::string_view name;
    Answer answer;
};

const LanguageServer::Method* LanguageServer::findMethod(std::string_view name) {
    static constexpr std::array kMethods{
        Method{"initialize", &LanguageServer::initialize},
        Method{"shutdown", &LanguageServer::shutDown},
        Method{"textDocument/completion", &LanguageServer::complete},
        Method{"textDocument/hover", &LanguageServer::hover},
        Method{"textDocument/definition", &LanguageServer::definition},
        Method{"textDocument/declaration", &LanguageServer::definition},
        Method{"textDocument/documentSymbol", &LanguageServer::symbols},
        Method{"textDocument/documentColor", &LanguageServer::colors},
        Method{"textDocument/colorPresentation", &LanguageServer::colorPresentations},
        Method{"textDocument/documentLink", &LanguageServer::links},
        Method{"textDocument/formatting", &LanguageServer::format},
        Method{"textDocument/references", &LanguageServer::references},
        Method{"textDocument/documentHighlight", &LanguageServer::highlights},
        Method{"textDocument/prepareRename", &LanguageServer::prepareRename},
        Method{"textDocument/rename", &LanguageServer::rename},
        Method{"textDocument/signatureHelp", &LanguageServer::signatures},
        Method{"textDocument/codeAction", &LanguageServer::actions},
        Method{"textDocument/foldingRange", &LanguageServer::folds},
        Method{"textDocument/semanticTokens/full", &LanguageServer::tokens},
        Method{"textDocument/inlayHint", &LanguageServer::hints},
        Method{"workspace/symbol", &LanguageServer::findSymbols},
    };
    const auto* const found = std::ranges::find(kMethods, name, &Method::name);
    return found == kMethods.end() ? nullptr : found;
}

LanguageServer::LanguageServer(ServerOptions options) : options_(std::move(options)) {
    if (!options_.check) options_.check = checkContained;
}

void LanguageServer::send(const json& message) {
    output_.push_back(message.dump(-1, ' ', false, json::error_handler_t::replace));
}

void LanguageServer::fail(const json& id, int code, const std::string& text) {
    send({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", text}}}});
}

std::vector<std::string> LanguageServer::takeOutput() {
    return std::exchange(output_, {});
}

bool LanguageServer::receive(std::string_view message) {
    constexpr std::size_t kDeepest = 256;
    json read =
        nestingOf(message) > kDeepest ? json(json::value_t::discarded) : json::parse(message, nullptr, false);
    if (read.is_discarded() && !base::isUtf8(message))
        read = json::parse(base::onlyUtf8(message), nullptr, false);
    if (read.is_discarded()) {
        fail(nullptr, kParseError, "the message is no JSON");
        return false;
    }
    if (read.is_object() && read.value("method", json()) == "$/cancelRequest") {
        const json parameters = read.value("params", json());
        if (parameters.is_object() && parameters.contains("id"))
            cancelled_.insert(parameters.at("id").dump());
        return true;
    }
    waiting_.push_back(std::move(read));
    return true;
}

void LanguageServer::answer() {
    for (const json& each : std::exchange(waiting_, {}))
        if (!exitStatus_) handle(each);
    cancelled_.clear();
}

void LanguageServer::handle(const json& message) {
    const json id = message.is_object() ? message.value("id", json()) : json();
    const bool isRequest = message.is_object() && message.contains("id");
    if (!message.is_object() || !message.contains("method") || !message.at("method").is_string()) {
        // An answer to a request of the server would have no method; the server has no requests.
        const bool isAnswer = isRequest && (message.contains("result") || message.contains("error"));
        if (!isAnswer) fail(id, kInvalidRequest, "the message is no request");
        return;
    }
    const auto method = message.at("method").get<std::string>();
    const json parameters = message.value("params", json::object());
    try {
        if (isRequest)
            request(method, id, parameters);
        else
            notify(method, parameters);
    } catch (const json::exception&) {
        if (isRequest)
            fail(id, kInvalidParameters,
                 fmt::format("'{}' has other parameters than the protocol says", method));
    } catch (const std::invalid_argument& wrong) {
        if (isRequest) fail(id, kInvalidParameters, wrong.what());
    } catch (const std::exception&) {
        if (isRequest) fail(id, kInternalError, fmt::format("'{}' cannot be answered", method));
    }
}

void LanguageServer::request(const std::string& method, const json& id, const json& parameters) {
    const bool begins = method == "initialize";
    if (cancelled_.contains(id.dump())) return fail(id, kRequestCancelled, "the request is cancelled");
    if (isShutDown_) return fail(id, kInvalidRequest, "the server is shut down");
    if (!isInitialized_ && !begins) return fail(id, kNotInitialized, "the server is not initialized");
    if (isInitialized_ && begins) return fail(id, kInvalidRequest, "the server is initialized");
    const Method* known = findMethod(method);
    if (!known) return fail(id, kMethodNotFound, fmt::format("there is no method '{}'", method));
    json result = (this->*known->answer)(parameters);
    send({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
}

void LanguageServer::notify(const std::string& method, const json& parameters) {
    if (method == "exit") {
        exitStatus_ = isShutDown_ ? 0 : 1;
        return;
    }
    if (!isInitialized_ || isShutDown_) return;
    if (method == "initialized" && formatsByLanguage_) {
        // Some editors know no language of a file.
        const json scenes = json::array({{{"language", "glib"}}, {{"pattern", "**/*.glib"}}});
        send({{"jsonrpc", "2.0"},
              {"id", "formatting"},
              {"method", "client/registerCapability"},
              {"params",
               {{"registrations",
                 {{{"id", "formatting"},
                   {"method", "textDocument/formatting"},
                   {"registerOptions", {{"documentSelector", scenes}}}}}}}}});
    } else if (method == "textDocument/didOpen") {
        changed(documents_.open(parameters));
    } else if (method == "textDocument/didChange") {
        if (const Document* document = documents_.change(parameters)) changed(*document);
    } else if (method == "textDocument/didSave") {
        changed(documentOf(parameters));
    } else if (method == "textDocument/didClose") {
        const auto uri = parameters.at("textDocument").at("uri").get<std::string>();
        const Document* document = documents_.find(uri);
        if (!document) return;
        const std::filesystem::path file = document->file;
        documents_.close(uri);
        forget(file);
        for (const auto& [scene, check] : checks_)
            if (check.uses(file)) due_.insert(scene);
        // Scenes that were checked for the sake of a shader that is open no more.
        std::vector<std::filesystem::path> unused;
        for (const auto& [scene, check] : checks_)
            if (!isShown(scene, check)) unused.push_back(scene);
        for (const std::filesystem::path& each : unused) forget(each);
    } else if (method == "workspace/didChangeWatchedFiles") {
        for (const auto& [scene, check] : checks_) due_.insert(scene);
    }
}

json LanguageServer::initialize(const json& parameters) {
    isInitialized_ = true;
    if (const json process = parameters.is_object() ? parameters.value("processId", json()) : json();
        process.is_number_integer())
        clientProcess_ = process.get<long long>();
    const auto client = [&](const char* path) {
        const json::json_pointer at(std::string("/capabilities/") + path);
        return parameters.contains(at) ? parameters.at(at) : json();
    };
    const json operations = client("workspace/workspaceEdit/resourceOperations");
    createsFiles_ = operations.is_array() && std::ranges::find(operations, "create") != operations.end();
    formatsByLanguage_ = client("textDocument/formatting/dynamicRegistration") == true;
    json capabilities = {
        {"positionEncoding", "utf-16"},
        {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", {{"includeText", false}}}}},
        {"completionProvider", {{"triggerCharacters", {".", "#", "\"", "/", "<", " "}}}},
        {"signatureHelpProvider", {{"triggerCharacters", {"(", ","}}}},
        {"hoverProvider", true},
        {"definitionProvider", true},
        {"declarationProvider", true},
        {"referencesProvider", true},
        {"documentHighlightProvider", true},
        {"renameProvider", {{"prepareProvider", true}}},
        {"codeActionProvider", {{"codeActionKinds", {"quickfix", "refactor.rewrite"}}}},
        {"foldingRangeProvider", true},
        {"semanticTokensProvider", {{"legend", tokenLegend()}, {"full", true}}},
        {"inlayHintProvider", true},
        {"documentSymbolProvider", true},
        {"workspaceSymbolProvider", true},
        {"documentLinkProvider", json::object()},
        {"colorProvider", true},
        // Shaders are not formatted. Only clients that register can be told so.
        {"documentFormattingProvider", !formatsByLanguage_},
    };
    return {{"capabilities", std::move(capabilities)},
            {"serverInfo", {{"name", "glibra"}, {"version", options_.version}}}};
}

json LanguageServer::shutDown(const json&) {
    isShutDown_ = true;
    due_.clear();
    return nullptr;
}

// ---- Checks

bool LanguageServer::isShown(const std::filesystem::path& scene, const SceneCheck& check) const {
    const auto isOpen = [&](const std::filesystem::path& file) {
        return documents_.findFile(file) != nullptr;
    };
    return isOpen(scene) || std::ranges::any_of(check.files, isOpen);
}

void LanguageServer::changed(const Document& document) {
    if (document.language == CodeLanguage::glib) due_.insert(document.file);
    bool isUsed = document.language == CodeLanguage::glib;
    for (const auto& [scene, check] : checks_) {
        if (!check.uses(document.file)) continue;
        due_.insert(scene);
        isUsed = isUsed || scene != document.file;
    }
    if (isUsed) return;
    findScenesOf(document);
    if (stageOfFile(document.file)) due_.insert(document.file);
}

bool LanguageServer::isShader(const std::filesystem::path& file) const {
    const Document* const document = documents_.findFile(file);
    return document != nullptr && document->language == CodeLanguage::glsl;
}

bool LanguageServer::isInScene(const std::filesystem::path& shader) const {
    return std::ranges::any_of(
        checks_, [&](const auto& each) { return each.first != shader && each.second.uses(shader); });
}

std::filesystem::path LanguageServer::rootOf(const std::filesystem::path& file) {
    std::error_code failure;
    for (std::filesystem::path above = file.parent_path(); above != above.root_path();
         above = above.parent_path())
        if (std::filesystem::is_directory(above / "glib", failure)) return above / "glib";
    return file.parent_path();
}

void LanguageServer::findScenesOf(const Document& shader) {
    constexpr std::size_t kMostScenes = 3;
    // Open scenes may begin to use it.
    for (const auto& [uri, each] : documents_.all())
        if (each.language == CodeLanguage::glib) due_.insert(each.file);
    const std::filesystem::path root = rootOf(shader.file);
    if (root == root.root_path()) return;
    const Result<std::vector<std::filesystem::path>> scenes = suite::scenesBelow(root);
    if (!scenes) return;
    const std::string name = shader.file.filename().generic_string();
    std::size_t count = 0;
    for (const std::filesystem::path& each : *scenes) {
        if (count >= kMostScenes) return;
        if (documents_.findFile(each) || documents_.textOf(each).find(name) == std::string::npos) continue;
        due_.insert(each);
        ++count;
    }
}

LanguageServer::Work LanguageServer::beginWork() {
    while (!due_.empty()) {
        // A shader is checked by itself if none of the scenes turns out to use it.
        const auto next = std::ranges::find_if_not(due_, [this](const auto& each) { return isShader(each); });
        working_ = next != due_.end() ? *next : *due_.begin();
        due_.erase(working_);
        if (isShader(working_) && isInScene(working_)) {
            forget(working_);
            continue;
        }
        RenderOptions options;
        options.libraryRoots = options_.libraryRoots;
        for (const auto& [uri, each] : documents_.all()) options.texts[each.file] = each.text;
        return [check = options_.check, file = working_, options] { return check(file, options); };
    }
    return {};
}

void LanguageServer::endWork(ContainedCheck checked) {
    const std::filesystem::path scene = std::exchange(working_, {});
    // The text has changed meanwhile, so its lines are others.
    if (due_.contains(scene) || isShutDown_) return;
    if (!checked.failure.empty()) {
        // Its last messages and names are better than none.
        if (const auto last = checks_.find(scene); last != checks_.end()) checked.check = last->second;
        send({{"jsonrpc", "2.0"},
              {"method", "window/logMessage"},
              {"params",
               {{"type", 2}, {"message", fmt::format("{}: {}", scene.generic_string(), checked.failure)}}}});
    }
    report(scene, checked.check);
}

void LanguageServer::work() {
    if (const Work check = beginWork()) endWork(check());
}

void LanguageServer::report(const std::filesystem::path& scene, const SceneCheck& check) {
    std::set<std::filesystem::path> files;
    if (const auto last = checks_.find(scene); last != checks_.end())
        for (const Diagnostic& each : last->second.diagnostics) files.insert(each.place.file);
    // A scene that only mentions the name of an open shader is not shown.
    if (!isShown(scene, check)) {
        checks_.erase(scene);
    } else {
        for (const Diagnostic& each : check.diagnostics) files.insert(each.place.file);
        if (documents_.findFile(scene)) files.insert(scene);
        checks_[scene] = check;
    }
    publish(files);
    for (const std::filesystem::path& each : check.files)
        if (each != scene && isShader(each)) forget(each);
}

void LanguageServer::forget(const std::filesystem::path& scene) {
    due_.erase(scene);
    const auto last = checks_.find(scene);
    if (last == checks_.end()) return;
    std::set<std::filesystem::path> files;
    for (const Diagnostic& each : last->second.diagnostics) files.insert(each.place.file);
    checks_.erase(last);
    publish(files);
}

void LanguageServer::publish(const std::set<std::filesystem::path>& files) {
    for (const std::filesystem::path& file : files) {
        if (file.empty()) continue;
        const std::string text = documents_.textOf(file);
        const TextLines lines(text);
        json messages = json::array();
        std::set<std::string> seen;
        for (const auto& [scene, check] : checks_)
            for (const Diagnostic& each : check.diagnostics) {
                if (std::filesystem::path(each.place.file) != file || !seen.insert(toString(each)).second)
                    continue;
                const TextRange line = lines.line(static_cast<std::size_t>(std::max(each.place.line, 1)) - 1);
                const std::size_t begin = std::min(
                    line.begin + static_cast<std::size_t>(std::max(each.place.column, 1)) - 1, line.end);
                TextRange place = wordAt(text, begin);
                place.begin = begin;
                if (place.end <= begin) place.end = std::min(begin + 1, line.end);
                constexpr std::array kSeverities{3, 2, 1};  // note, warning, error
                json message = {{"range", toJson(lines, place)},
                                {"severity", kSeverities[static_cast<std::size_t>(each.severity)]},
                                {"source", "glibra"},
                                {"message", each.text}};
                if (!each.id.empty()) message["code"] = each.id;
                messages.push_back(std::move(message));
            }
        if (messages.empty() && !published_.contains(file) && !documents_.findFile(file)) continue;
        if (messages.empty())
            published_.erase(file);
        else
            published_.insert(file);
        json parameters = {{"uri", documents_.uriOf(file)}, {"diagnostics", std::move(messages)}};
        if (const Document* open = documents_.findFile(file)) parameters["version"] = open->version;
        send({{"jsonrpc", "2.0"}, {"method", "textDocument/publishDiagnostics"}, {"params", parameters}});
    }
}

namespace {

constexpr std::string_view kLength = "content-length:";
constexpr std::size_t kLongestHeader = 4096;

/// The length that a header states; nothing without one.
std::optional<std::size_t> lengthIn(std::string_view header) {
    const std::size_t at = glib::lower(header).rfind(kLength);
    if (at == std::string::npos) return std::nullopt;
    header.remove_prefix(at + kLength.size());
    header.remove_prefix(std::min(header.find_first_not_of(" \t"), header.size()));
    std::size_t length = 0;
    const auto [end, problem] = std::from_chars(header.data(), header.data() + header.size(), length);
    if (problem == std::errc::result_out_of_range) return std::numeric_limits<std::size_t>::max();
    return problem == std::errc() ? std::optional(length) : std::nullopt;
}

}  // namespace

std::optional<std::string> MessageReader::next() {
    for (;;) {
        if (length_) {
            if (isLost() || bytes_.size() < *length_) return std::nullopt;
            std::string message = bytes_.substr(0, *length_);
            bytes_.erase(0, *length_);
            length_.reset();
            return message;
        }
        std::size_t end = bytes_.find("\r\n\r\n");
        std::size_t after = end + 4;
        if (const std::size_t bare = bytes_.find("\n\n"); bare < end) {
            end = bare;
            after = bare + 2;
        }
        if (end == std::string::npos) {
            // No header is that long. Its beginning may be at the end.
            if (bytes_.size() > 2 * kLongestHeader) bytes_.erase(0, bytes_.size() - kLongestHeader);
            return std::nullopt;
        }
        length_ = lengthIn(std::string_view(bytes_).substr(0, end));
        bytes_.erase(0, after);
    }
}

void MessageReader::refuse(std::string_view message) {
    const std::size_t at = glib::lower(message).find(kLength);
    if (at == std::string::npos) return;
    std::string again(message.substr(at));
    again += bytes_;
    // The bytes that follow were taken for the header of the next message.
    bytes_ = std::move(again);
    length_.reset();
}

std::string framed(std::string_view message) {
    return "Content-Length: " + std::to_string(message.size()) + "\r\n\r\n" + std::string(message);
}

}  // namespace glibra::editor
