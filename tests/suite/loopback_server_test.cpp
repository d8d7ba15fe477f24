// A server on the loopback address, and what must not get through to it. Requests are written byte by byte,
// because a browser would refuse to send most of them.

#include "suite/serve/loopback_server.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <stdexcept>
#include <thread>

#include "folder.h"

namespace glibra::suite {
namespace {

/// Sends `text` to an address of this machine. Returns everything that comes back; empty: nobody listens, or
/// the connection was closed in the middle of the request.
std::string exchange(int port, const std::string& text, const char* address = "127.0.0.1") {
    const int connection = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    ::inet_pton(AF_INET, address, &to.sin_addr);
    std::string reply;
    if (::connect(connection, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0) {
        for (std::size_t sent = 0; sent < text.size();) {
            const ssize_t count = ::send(connection, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
            if (count <= 0) break;
            sent += static_cast<std::size_t>(count);
        }
        char bytes[4096];
        for (ssize_t count; (count = ::read(connection, bytes, sizeof bytes)) > 0;)
            reply.append(bytes, static_cast<std::size_t>(count));
    }
    ::close(connection);
    return reply;
}

int statusOf(const std::string& reply) {
    return reply.rfind("HTTP/1.1 ", 0) == 0 ? std::stoi(reply.substr(9, 3)) : 0;
}

std::string bodyOf(const std::string& reply) {
    const std::size_t end = reply.find("\r\n\r\n");
    return end == std::string::npos ? "" : reply.substr(end + 4);
}

/// A server that runs during a test.
class Served : public ::testing::Test {
  protected:
    void SetUp() override {
        auto opened = LoopbackServer::open(1000);
        ASSERT_TRUE(opened) << opened.message();
        server_.emplace(std::move(*opened));
        server_->get("", [](const WebRequest&) { return WebReply{200, "text/html", "<p>page"}; });
        server_->get("picture", [](const WebRequest& request) {
            const auto shot = request.parameters.find("shot");
            return WebReply{200, "image/png", shot == request.parameters.end() ? "none" : shot->second};
        });
        server_->get("fails", [](const WebRequest&) -> WebReply { throw std::runtime_error("no picture"); });
        server_->post("accept", [this](const WebRequest& request) {
            const int now = ++inHandler_;
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            most_ = std::max(most_, now);
            bodies_.push_back(request.body);
            --inHandler_;
            return WebReply{200, "application/json", "{}"};
        });
        running_ = std::thread([this] { server_->run([this] { return done_.load(); }); });
        const std::string address = server_->address();
        token_ = address.substr(address.size() - 33, 32);
        host_ = "127.0.0.1:" + std::to_string(server_->port());
    }
    void TearDown() override {
        done_ = true;
        if (running_.joinable()) running_.join();
    }

    /// A request as the page itself sends it; `without` is a header to leave out, `more` others to add.
    [[nodiscard]] std::string request(const std::string& line, const std::string& headers,
                                      const std::string& body = {}) const {
        return line + " HTTP/1.1\r\n" + headers + "\r\n" + body;
    }
    [[nodiscard]] std::string hostLine() const { return "Host: " + host_ + "\r\n"; }
    [[nodiscard]] std::string get(const std::string& path, const std::string& more = {}) const {
        return exchange(server_->port(), request("GET " + path, hostLine() + more));
    }
    [[nodiscard]] std::string own(const std::string& name) const { return "/" + token_ + "/" + name; }
    [[nodiscard]] std::string post(const std::string& path, const std::string& body,
                                   const std::string& more = {}) const {
        return exchange(server_->port(),
                        request("POST " + path,
                                hostLine() + "Content-Type: application/json\r\nContent-Length: " +
                                    std::to_string(body.size()) + "\r\n" + more,
                                body));
    }

    std::optional<LoopbackServer> server_;
    std::thread running_;
    std::atomic<bool> done_ = false;
    std::atomic<int> inHandler_ = 0;
    int most_ = 0;
    std::vector<std::string> bodies_;  ///< that reached the handler
    std::string token_, host_;
};

TEST_F(Served, AnswersThePageThatKnowsTheToken) {
    const std::string page = get(own(""));
    EXPECT_EQ(statusOf(page), 200);
    EXPECT_EQ(bodyOf(page), "<p>page");
    EXPECT_EQ(bodyOf(get(own("picture?shot=oval%40uTol%3D0.1"))), "oval@uTol=0.1");
    EXPECT_EQ(statusOf(post(own("accept"), "{\"shot\": 3}", "Origin: http://" + host_ + "\r\n")), 200);
    EXPECT_EQ(bodies_, std::vector<std::string>{"{\"shot\": 3}"});
    const std::string failed = get(own("fails"));
    EXPECT_EQ(statusOf(failed), 500);
    EXPECT_NE(bodyOf(failed).find("no picture"), std::string::npos);
}

TEST_F(Served, ListensOnOneAddressOnly) {
    const std::string question = request("GET " + own(""), hostLine());
    EXPECT_EQ(statusOf(exchange(server_->port(), question)), 200);
    EXPECT_EQ(exchange(server_->port(), question, "127.0.0.2"), "");
}

TEST_F(Served, RefusesEveryOtherHost) {
    for (const std::string& host :
         {std::string("evil.example"), "evil.example:" + std::to_string(server_->port()),
          std::string("127.0.0.1"), "localhost:" + std::to_string(server_->port()),
          std::string("127.0.0.1:1"), host_ + ".evil.example", "[::1]:" + std::to_string(server_->port()),
          std::string()}) {
        const std::string reply =
            exchange(server_->port(), request("GET " + own(""), "Host: " + host + "\r\n"));
        EXPECT_NE(statusOf(reply), 200) << host;
        EXPECT_EQ(reply.find("<p>page"), std::string::npos) << host;
    }
    EXPECT_EQ(statusOf(exchange(server_->port(), request("GET " + own(""), ""))), 403);
    EXPECT_EQ(
        statusOf(exchange(server_->port(), request("GET " + own(""), hostLine() + "Host: evil.example\r\n"))),
        403);
}

TEST_F(Served, RefusesEveryOtherOrigin) {
    for (const char* origin : {"http://evil.example", "null", "https://127.0.0.1", "http://127.0.0.1:1",
                               "http://localhost", "file://"})
        EXPECT_EQ(statusOf(post(own("accept"), "{}", std::string("Origin: ") + origin + "\r\n")), 403)
            << origin;
    for (const char* site : {"cross-site", "same-site"})
        EXPECT_EQ(statusOf(get(own(""), std::string("Sec-Fetch-Site: ") + site + "\r\n")), 403) << site;
    EXPECT_EQ(statusOf(post(own("accept"), "{}",
                            "Origin: http://" + host_ + "\r\nOrigin: http://evil.example\r\n")),
              403);
    EXPECT_TRUE(bodies_.empty());
}

TEST_F(Served, RefusesWhoeverLacksTheToken) {
    std::string other = token_, longer = token_ + "0";
    other[31] = other[31] == '0' ? '1' : '0';
    for (const std::string& path :
         {std::string("/"), std::string("/accept"), "/" + other + "/", "/" + longer + "/", "/" + token_,
          "/" + token_.substr(0, 31) + "/", "//" + token_ + "/", "/?token=" + token_,
          std::string("/" + std::string(32, '0') + "/")}) {
        EXPECT_EQ(statusOf(get(path)), 403) << path;
        EXPECT_EQ(statusOf(post(path, "{}")), 403) << path;
    }
    EXPECT_TRUE(bodies_.empty());
}

TEST_F(Served, HasATokenOfItsOwnEachTime) {
    std::set<std::string> tokens{token_};
    for (int i = 0; i < 20; ++i) {
        auto again = LoopbackServer::open();
        ASSERT_TRUE(again);
        const std::string address = again->address();
        tokens.insert(address.substr(address.size() - 33, 32));
    }
    EXPECT_EQ(tokens.size(), 21U);
    EXPECT_EQ(token_.find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST_F(Served, ReachesNoFileOfTheDisk) {
    const Folder folder;
    writeText(folder / "secret", "SECRET");
    const std::string secret = (folder / "secret").string();
    std::string encoded;
    for (const char c : secret) encoded += c == '/' ? std::string("%2F") : std::string(1, c);
    for (const std::string& path :
         {own(secret), own("..%2f..%2f.." + encoded), own("../../../../../../.." + secret), own("." + secret),
          own("picture/../../../.." + secret), own("picture%00" + encoded), own("PICTURE"), own("picture/"),
          own("%70icture/x"), std::string("http://") + host_ + own(secret), own("..\\..\\secret")}) {
        const std::string reply = get(path);
        EXPECT_NE(statusOf(reply), 200) << path;
        EXPECT_EQ(reply.find("SECRET"), std::string::npos) << path;
    }
    // A long path does not exhaust the stack either.
    EXPECT_NE(statusOf(get(own(std::string(8000, 'a')))), 200);
    EXPECT_NE(statusOf(get(own(std::string(2000000, 'a')))), 200);
    EXPECT_EQ(statusOf(get(own(""))), 200);
}

TEST_F(Served, TakesNoFormsAndNoOtherMethods) {
    for (const char* type :
         {"application/x-www-form-urlencoded", "multipart/form-data; boundary=x", "text/plain"})
        EXPECT_EQ(statusOf(exchange(
                      server_->port(),
                      request("POST " + own("accept"),
                              hostLine() + "Content-Type: " + type + "\r\nContent-Length: 5\r\n", "a=b&c"))),
                  415)
            << type;
    for (const char* method : {"PUT", "DELETE", "OPTIONS", "PATCH", "TRACE", "CONNECT"})
        EXPECT_NE(statusOf(exchange(server_->port(), request(method + (" " + own("accept")), hostLine()))),
                  200)
            << method;
    EXPECT_EQ(statusOf(get(own("accept"))), 404);
    EXPECT_EQ(statusOf(post(own("picture"), "{}")), 404);
    EXPECT_TRUE(bodies_.empty());
}

TEST_F(Served, RefusesBodiesThatAreLargeOrOfUnknownLength) {
    const std::string json = "Content-Type: application/json\r\n";
    const auto statusOfPost = [&](const std::string& headers, const std::string& body) {
        return statusOf(
            exchange(server_->port(), request("POST " + own("accept"), hostLine() + json + headers, body)));
    };
    EXPECT_EQ(statusOf(post(own("accept"), std::string(1000, ' '))), 200);
    EXPECT_EQ(bodies_.size(), 1U);
    EXPECT_EQ(statusOfPost("Content-Length: 1001\r\n", ""), 413);
    EXPECT_EQ(statusOfPost("Content-Length: 18446744073709551617\r\n", ""), 413);
    EXPECT_EQ(statusOfPost("Content-Length: -1\r\n", ""), 400);
    EXPECT_EQ(statusOfPost("Content-Length: 2\r\nContent-Length: 3\r\n", ""), 400);
    EXPECT_EQ(statusOfPost("", ""), 411);
    EXPECT_EQ(statusOfPost("Transfer-Encoding: chunked\r\n", "2\r\n{}\r\n0\r\n\r\n"), 411);
    EXPECT_EQ(statusOfPost("Content-Encoding: gzip\r\nContent-Length: 2\r\n", "{}"), 411);
    // The connection may break before the refusal is read, since nobody reads the body.
    EXPECT_NE(statusOf(post(own("accept"), std::string(64 << 20, ' '))), 200);
    EXPECT_EQ(statusOf(get(own("picture"), "Range: bytes=0-,0-,0-,0-\r\n")), 400);
    EXPECT_EQ(bodies_.size(), 1U);
}

TEST_F(Served, LetsNoOtherPageFrameItAndKeepsTheTokenToItself) {
    const std::string reply = get(own(""));
    for (const char* header :
         {"Cache-Control: no-store", "Referrer-Policy: same-origin", "frame-ancestors 'none'",
          "default-src 'none'", "X-Content-Type-Options: nosniff",
          "Cross-Origin-Resource-Policy: same-origin"})
        EXPECT_NE(reply.find(header), std::string::npos) << header;
    EXPECT_EQ(reply.find("Access-Control-Allow"), std::string::npos);
    EXPECT_EQ(get("/").find(token_), std::string::npos);
}

TEST_F(Served, CallsHandlersOneAtATimeForSeveralBrowsers) {
    std::vector<std::thread> browsers;
    std::atomic<int> good = 0;
    for (int i = 0; i < 8; ++i)
        browsers.emplace_back([&] {
            for (int k = 0; k < 5; ++k) good += statusOf(post(own("accept"), "{}")) == 200 ? 1 : 0;
        });
    for (std::thread& each : browsers) each.join();
    EXPECT_EQ(good, 40);
    EXPECT_EQ(bodies_.size(), 40U);
    EXPECT_EQ(most_, 1);
}

TEST_F(Served, AnswersWhileOthersHoldConnectionsOpen) {
    std::vector<int> idle;
    for (int i = 0; i < 12; ++i) {  // as two browsers do
        idle.push_back(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
        sockaddr_in to{};
        to.sin_family = AF_INET;
        to.sin_port = htons(static_cast<std::uint16_t>(server_->port()));
        to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        ASSERT_EQ(::connect(idle.back(), reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
    }
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(statusOf(get(own(""))), 200);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(3));
    for (const int each : idle) ::close(each);
}

TEST(LoopbackServer, EndsAlsoIfItIsStoppedBeforeItHasBegun) {
    for (int i = 0; i < 20; ++i) {
        auto server = LoopbackServer::open();
        ASSERT_TRUE(server);
        server->run([] { return true; });
    }
}

TEST(LoopbackServer, SaysThatItsModuleIsMissing) {
    const Folder folder;
    const auto none = LoopbackServer::open(1000, {folder.path()});
    EXPECT_FALSE(none);
    EXPECT_EQ(none.message(),
              "error: cannot serve a page: the module that speaks HTTP is not installed [suite-E28]");
    writeText(folder / "glibra_server.so", "no library");
    EXPECT_NE(LoopbackServer::open(1000, {folder.path()}).message().find("cannot be loaded"),
              std::string::npos);
}

}  // namespace
}  // namespace glibra::suite
