#pragma once
// A page that glibra serves to the browsers of this machine, and that writes files: `glibra review --serve`
// and `glibra class --serve`.
//
// Anything that a browser shows can send requests to 127.0.0.1, and so can every user of the machine. A
// request is therefore answered only if all of this holds; otherwise it is refused before its body is read:
//   - it came to 127.0.0.1, the only address that is bound, and names it and the port in its Host. A foreign
//   name that
//     was made to lead here (DNS rebinding) has another Host;
//   - its Origin, if it has one, is this server's, and Sec-Fetch-Site does not say that another site sent it;
//   - its path begins with the token: 128 random bits that are made anew for each server and compared in
//   constant time;
//   - it is a GET (or HEAD) or POST of a name that has a handler. No path of a request ever reaches the disk;
//   - a POST has JSON of a stated length within the limit. So a form, which can be sent without asking, is
//   none.
// Replies are not cached, cannot be framed by other pages, and load nothing from elsewhere.

#include <glibra/result.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace glibra::suite {

struct WebRequest {
    std::map<std::string, std::string> parameters;  ///< of the query: {"shot", "3"}
    std::string body;                               ///< of a POST: JSON that nobody has looked at yet
};

struct WebReply {
    int status = 200;
    std::string type = "application/json";
    std::string body;
};

class LoopbackServer {
  public:
    using Handler = std::function<WebReply(const WebRequest&)>;

    /// Binds a free port. `largestBody`: bytes that a POST may have. The server is a module that is loaded
    /// here, from `moduleFolders` or from image::defaultModuleFolders(). Error: suite-E28.
    static Result<LoopbackServer> open(std::size_t largestBody = std::size_t{1} << 20,
                                       const std::vector<std::filesystem::path>& moduleFolders = {});

    /// Registers what answers /TOKEN/NAME; an empty name stands for the page itself. Call these before run().
    /// Handlers are called one at a time, from threads of the server. One that throws gives the status 500.
    void get(const std::string& name, Handler handler);
    void post(const std::string& name, Handler handler);

    /// "http://127.0.0.1:40123/0f..9a/". Links of the page are relative to it.
    [[nodiscard]] std::string address() const;
    [[nodiscard]] int port() const;

    /// Answers requests until `stop`, which is called ten times a second, returns true.
    void run(const std::function<bool()>& stop);

    LoopbackServer(LoopbackServer&&) noexcept;
    LoopbackServer& operator=(LoopbackServer&&) noexcept;
    ~LoopbackServer();

  private:
    struct State;
    explicit LoopbackServer(std::unique_ptr<State> state);

    std::unique_ptr<State> state_;
};

}  // namespace glibra::suite
