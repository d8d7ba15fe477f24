#pragma once
// Encodes pictures as PNG on several threads, and writes them one after the other in their order.

#include <glibra/result.h>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

#include "image/image.h"

namespace glibra::render {

class PictureStream {
  public:
    using Png = std::vector<std::byte>;
    /// `write` writes a picture and reports what prevents that; `written` is called after each with its
    /// number. Both are called on a thread of the stream, never at the same time.
    PictureStream(std::function<Diagnostics(const Png&)> write, std::function<void(int number)> written);
    PictureStream(const PictureStream&) = delete;
    PictureStream& operator=(const PictureStream&) = delete;
    /// What was not written yet is left out.
    ~PictureStream();

    /// Adds a picture. Waits while as many are encoded as there are processors, or as fit into 256 MiB.
    /// False if a picture could not be written: drawing more is useless.
    bool add(int number, image::Image picture);
    /// The same for the picture that was added last.
    bool addAgain(int number);
    /// Waits for all pictures, and returns the errors of at most one.
    Diagnostics finish();

  private:
    struct Item {
        int number = 0;
        std::shared_future<Png> png;
    };
    bool put(Item item);
    void run();
    void close(bool withRest);

    std::function<Diagnostics(const Png&)> write_;
    std::function<void(int)> written_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Item> waiting_;
    std::shared_future<Png> last_;
    std::size_t most_ = 1;
    Diagnostics problems_;
    std::exception_ptr failure_;
    bool closed_ = false;
    bool failed_ = false;
    std::jthread thread_;
};

}  // namespace glibra::render
