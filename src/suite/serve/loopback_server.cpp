#include "suite/serve/loopback_server.h"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <charconv>
#include <chrono>
#include <exception>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>

#include "base/text.h"
#include "image/module_loader.h"
#include "suite/module/abi.h"
#include "system/places.h"

namespace glibra::suite {

/// The functions of the module. A member of LoopbackServer::State, so it has a name outside of this file.
struct ServerModule {
    GlibraServerOpen open = nullptr;
    GlibraServerDo run = nullptr, stop = nullptr, close = nullptr;
};

namespace {

namespace fs = std::filesystem;

std::string_view viewOf(GlibraText text) {
    return {text.data, text.size};
}
GlibraText plainOf(std::string_view text) {
    return {text.data(), text.size()};
}

Result<ServerModule> loadServerModule(const std::vector<fs::path>& folders) {
    std::string why;
    const system::Library library = image::openModule(
        folders, "glibra_server", "glibraServerVersion", kGlibraServerVersion,
        {"glibraServerOpen", "glibraServerRun", "glibraServerStop", "glibraServerClose"}, why);
    if (!library) return diagnose("suite-E28", "cannot serve a page: the module that speaks HTTP " + why);
    return ServerModule{
        library.find<GlibraServerOpen>("glibraServerOpen"), library.find<GlibraServerDo>("glibraServerRun"),
        library.find<GlibraServerDo>("glibraServerStop"), library.find<GlibraServerDo>("glibraServerClose")};
}

/// 128 random bits as 32 hexadecimal digits, or nothing.
std::optional<std::string> randomToken() {
    std::array<std::byte, 16> bytes{};
    if (!system::fillWithRandom(bytes)) return std::nullopt;
    std::string token;
    for (const std::byte each : bytes) token += fmt::format("{:02x}", std::to_integer<unsigned>(each));
    return token;
}

/// Takes as long for every text of the right length, so that no digit can be found by measuring.
bool sameToken(std::string_view token, std::string_view given) {
    if (token.size() != given.size()) return false;
    unsigned difference = 0;
    for (std::size_t i = 0; i < token.size(); ++i)
        difference |= static_cast<unsigned char>(token[i]) ^ static_cast<unsigned char>(given[i]);
    return difference == 0;
}

/// All values of a header.
std::vector<std::string_view> headersOf(const GlibraRequest& request, std::string_view name) {
    std::vector<std::string_view> values;
    for (std::size_t i = 0; i < request.headerCount; ++i)
        if (base::sameWord(viewOf(request.headers[i].name), name))
            values.push_back(viewOf(request.headers[i].value));
    return values;
}

WebReply refusal(int status, std::string why) {
    return {status, "text/plain; charset=utf-8", "glibra: " + std::move(why) + "\n"};
}

void sendReply(const WebReply& reply, void* target, GlibraSendReply send) {
    constexpr std::array<std::array<std::string_view, 2>, 6> kHeaders{{
        {"Cache-Control", "no-store"},
        {"X-Content-Type-Options", "nosniff"},
        {"Referrer-Policy", "same-origin"},  // the address holds the token
        {"Cross-Origin-Resource-Policy", "same-origin"},
        {"Cross-Origin-Opener-Policy", "same-origin"},
        {"Content-Security-Policy",
         "default-src 'none'; script-src 'self' 'unsafe-inline'; style-src 'self' 'unsafe-inline'; "
         "img-src 'self' data: blob:; connect-src 'self'; base-uri 'none'; form-action 'none'; "
         "frame-ancestors 'none'"},
    }};
    std::array<GlibraNamedText, kHeaders.size()> headers{};
    for (std::size_t i = 0; i < headers.size(); ++i)
        headers[i] = {plainOf(kHeaders[i][0]), plainOf(kHeaders[i][1])};
    send(target, reply.status, plainOf(reply.type), headers.data(), headers.size(), plainOf(reply.body));
}

}  // namespace

struct LoopbackServer::State {
    using Handlers = std::map<std::string, Handler, std::less<>>;

    ServerModule module;
    void* server = nullptr;
    int port = 0;
    std::string token;
    std::size_t largestBody = 0;
    Handlers gets, posts;
    std::mutex handling;

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (server != nullptr) module.close(server);
    }

    [[nodiscard]] std::string host() const { return fmt::format("127.0.0.1:{}", port); }

    [[nodiscard]] const Handler* handlerOf(const GlibraRequest& request) const {
        const std::string_view name = viewOf(request.path).substr(token.size() + 2);
        const Handlers& handlers = viewOf(request.method) == "POST" ? posts : gets;
        const auto found = handlers.find(name);
        return found == handlers.end() ? nullptr : &found->second;
    }

    [[nodiscard]] std::optional<WebReply> refusalOfSender(const GlibraRequest& request) const {
        const auto hosts = headersOf(request, "Host");
        if (hosts.size() != 1 || hosts[0] != host())
            return refusal(403, "this server answers to " + host() + " only");
        for (const std::string_view origin : headersOf(request, "Origin"))
            if (origin != "http://" + host()) return refusal(403, "another site sent this request");
        for (const std::string_view site : headersOf(request, "Sec-Fetch-Site"))
            if (site != "same-origin" && site != "none")
                return refusal(403, "another site sent this request");
        const std::string_view path = viewOf(request.path);
        const bool hasToken = path.size() >= token.size() + 2 && path.front() == '/' &&
                              path[token.size() + 1] == '/' && sameToken(token, path.substr(1, token.size()));
        if (!hasToken) return refusal(403, "the address lacks the token that glibra printed");
        return std::nullopt;
    }

    [[nodiscard]] std::optional<WebReply> refusalOfBody(const GlibraRequest& request) const {
        if (!headersOf(request, "Transfer-Encoding").empty() ||
            !headersOf(request, "Content-Encoding").empty())
            return refusal(411, "a body has a stated length and is not compressed");
        const auto lengths = headersOf(request, "Content-Length");
        std::size_t length = 0;
        if (lengths.size() > 1) return refusal(400, "the request states two lengths");
        if (lengths.size() == 1) {
            const char* end = lengths[0].data() + lengths[0].size();
            const auto [read, problem] = std::from_chars(lengths[0].data(), end, length);
            if (problem == std::errc::result_out_of_range)
                return refusal(413, "the request has too many bytes");
            if (problem != std::errc() || read != end)
                return refusal(400, "the length of the request is no number");
        }
        if (length > largestBody)
            return refusal(413, fmt::format("a request may have {} bytes", largestBody));
        if (viewOf(request.method) != "POST")
            return length > 0 ? std::optional(refusal(400, "only a POST has a body")) : std::nullopt;
        if (lengths.empty()) return refusal(411, "the request states no length");
        const auto types = headersOf(request, "Content-Type");
        if (types.size() != 1 || types[0].substr(0, types[0].find(';')) != "application/json")
            return refusal(415, "a POST has JSON");
        return std::nullopt;
    }

    [[nodiscard]] std::optional<WebReply> refusalOf(const GlibraRequest& request) const {
        if (auto refused = refusalOfSender(request)) return refused;
        const std::string_view method = viewOf(request.method);
        if (method != "GET" && method != "HEAD" && method != "POST")
            return refusal(405, "only GET and POST are answered");
        if (handlerOf(request) == nullptr) return refusal(404, "there is nothing at this address");
        // Replies are made in memory; the parts of one that a Range asks for may overlap a thousand times.
        if (!headersOf(request, "Range").empty()) return refusal(400, "replies are sent whole");
        return refusalOfBody(request);
    }

    [[nodiscard]] WebReply answerTo(const GlibraRequest& request) {
        const Handler* handler = handlerOf(request);
        if (handler == nullptr) return refusal(404, "there is nothing at this address");
        WebRequest asked;
        for (std::size_t i = 0; i < request.parameterCount; ++i)
            asked.parameters.emplace(viewOf(request.parameters[i].name), viewOf(request.parameters[i].value));
        asked.body = viewOf(request.body);
        const std::lock_guard<std::mutex> lock(handling);
        return (*handler)(asked);
    }

    static int admit(void* context, const GlibraRequest* request, void* reply, GlibraSendReply send) {
        try {
            const auto refused = static_cast<State*>(context)->refusalOf(*request);
            if (refused) sendReply(*refused, reply, send);
            return refused ? 1 : 0;
        } catch (const std::exception&) {
            return 1;
        }
    }

    static void answer(void* context, const GlibraRequest* request, void* reply, GlibraSendReply send) {
        try {
            sendReply(static_cast<State*>(context)->answerTo(*request), reply, send);
        } catch (const std::exception& problem) {
            sendReply(refusal(500, base::reasonOf(problem)), reply, send);
        }
    }
};

LoopbackServer::LoopbackServer(std::unique_ptr<State> state) : state_(std::move(state)) {}
LoopbackServer::LoopbackServer(LoopbackServer&&) noexcept = default;
LoopbackServer& LoopbackServer::operator=(LoopbackServer&&) noexcept = default;
LoopbackServer::~LoopbackServer() = default;

Result<LoopbackServer> LoopbackServer::open(std::size_t largestBody,
                                            const std::vector<fs::path>& moduleFolders) {
    auto module = loadServerModule(moduleFolders.empty() ? image::defaultModuleFolders() : moduleFolders);
    if (!module) return std::move(module.diagnostics);
    auto token = randomToken();
    if (!token) return diagnose("suite-E28", "cannot serve a page: the system gives no random numbers");
    auto state = std::make_unique<State>();
    state->module = *module;
    state->token = *std::move(token);
    state->largestBody = largestBody;
    const GlibraServerCalls calls{state.get(), &State::admit, &State::answer, largestBody};
    state->server = module->open(&calls, &state->port);
    if (state->server == nullptr)
        return diagnose("suite-E28", "cannot serve a page: no port of 127.0.0.1 can be opened");
    return LoopbackServer(std::move(state));
}

void LoopbackServer::get(const std::string& name, Handler handler) {
    state_->gets[name] = std::move(handler);
}
void LoopbackServer::post(const std::string& name, Handler handler) {
    state_->posts[name] = std::move(handler);
}

std::string LoopbackServer::address() const {
    return fmt::format("http://{}/{}/", state_->host(), state_->token);
}

int LoopbackServer::port() const {
    return state_->port;
}

void LoopbackServer::run(const std::function<bool()>& stop) {
    std::atomic<bool> ended = false;
    std::thread answering([&] {
        state_->module.run(state_->server);
        ended = true;
    });
    while (!ended && !stop()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
    state_->module.stop(state_->server);
    answering.join();
}

}  // namespace glibra::suite
