// The module for loopback servers: cpp-httplib behind the functions of abi.h. It is a file of its own, loaded
// when a page is served: programs that are linked with cpp-httplib, and so with OpenSSL, start 8 ms later.

#include <httplib.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "suite/module/abi.h"

namespace glibra::module {
namespace {

/// Browsers open six connections to a host; a few of them, with two browsers, stay without a request for a
/// while.
constexpr std::size_t kThreads = 64;
constexpr int kSeconds = 1;  ///< that a client may take between two bytes

GlibraText textOf(const std::string& text) {
    return {text.data(), text.size()};
}

template <class Map>
std::vector<GlibraNamedText> pairsOf(const Map& map) {
    std::vector<GlibraNamedText> pairs;
    pairs.reserve(map.size());
    for (const auto& [name, value] : map) pairs.push_back({textOf(name), textOf(value)});
    return pairs;
}

void send(void* reply, int status, GlibraText type, const GlibraNamedText* headers, size_t headerCount,
          GlibraText body) {
    auto& response = *static_cast<httplib::Response*>(reply);
    response.status = status;
    for (size_t i = 0; i < headerCount; ++i)
        response.set_header(std::string(headers[i].name.data, headers[i].name.size),
                            std::string(headers[i].value.data, headers[i].value.size));
    response.set_content(std::string(body.data, body.size), std::string(type.data, type.size));
}

/// Calls a function of `calls` with the request as plain data.
template <class Function>
auto call(const GlibraServerCalls& calls, Function function, const httplib::Request& request,
          httplib::Response& response) {
    const std::vector<GlibraNamedText> headers = pairsOf(request.headers);
    const std::vector<GlibraNamedText> parameters = pairsOf(request.params);
    const GlibraRequest plain{textOf(request.method), textOf(request.path), headers.data(),
                              headers.size(),         parameters.data(),    parameters.size(),
                              textOf(request.body)};
    return function(calls.context, &plain, &response, send);
}

class Server {
  public:
    explicit Server(const GlibraServerCalls& calls) : calls_(calls) {
        http_.set_address_family(AF_INET);
        // Without its usual options, by which other processes of the user could bind the same port.
        http_.set_socket_options([](socket_t) {});
        http_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
        http_.set_keep_alive_max_count(1);
        http_.set_keep_alive_timeout(kSeconds);
        http_.set_read_timeout(kSeconds);
        http_.set_write_timeout(kSeconds);
        http_.set_payload_max_length(calls.largestBody);
        http_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
            return call(calls_, calls_.admit, request, response) == 0
                       ? httplib::Server::HandlerResponse::Unhandled
                       : httplib::Server::HandlerResponse::Handled;
        });
        const auto answer = [this](const httplib::Request& request, httplib::Response& response) {
            call(calls_, calls_.answer, request, response);
        };
        http_.Get("/.*", answer);
        http_.Post("/.*", answer);
        port_ = http_.bind_to_any_port("127.0.0.1");
    }

    [[nodiscard]] int port() const { return port_; }
    void run() {
        http_.listen_after_bind();
        hasEnded_ = true;
    }
    /// cpp-httplib forgets a call that comes before it answers requests.
    void stop() {
        while (!http_.is_running() && !hasEnded_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
        http_.stop();
    }

  private:
    GlibraServerCalls calls_;
    httplib::Server http_;
    int port_ = -1;
    std::atomic<bool> hasEnded_ = false;
};

}  // namespace
}  // namespace glibra::module

using glibra::module::Server;

int glibraServerVersion() {
    return kGlibraServerVersion;
}

void* glibraServerOpen(const GlibraServerCalls* calls, int* port) try {
    auto server = std::make_unique<Server>(*calls);
    *port = server->port();
    return *port > 0 ? server.release() : nullptr;
} catch (const std::exception&) {
    return nullptr;
}

void glibraServerRun(void* server) {
    static_cast<Server*>(server)->run();
}
void glibraServerStop(void* server) {
    static_cast<Server*>(server)->stop();
}
void glibraServerClose(void* server) {
    delete static_cast<Server*>(server);
}
