#pragma once
// Writes the frames of an animation to files, on separate threads.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <functional>
#include <future>
#include <mutex>
#include <set>
#include <thread>
#include <variant>
#include <vector>

#include "image/image.h"

namespace glibra::render {

/// Writes the bytes of one file to another.
Diagnostics copyFile(const std::filesystem::path& from, const std::filesystem::path& to);

/// Encodes and writes pictures while the next ones are drawn. It starts with one thread and adds more when
/// drawing is faster. At most two pictures wait, so that the use of memory is bounded.
class PictureWriter {
  public:
    /// `written` is called with the number of files written so far, never by two threads at once; it must
    /// outlive the writer. `mostThreads` 0: one thread per processor.
    explicit PictureWriter(const std::function<void(int)>& written, std::size_t mostThreads = 0);
    PictureWriter(const PictureWriter&) = delete;
    PictureWriter& operator=(const PictureWriter&) = delete;
    ~PictureWriter() { finish(); }

    /// Returns false after a file could not be written: drawing more is useless.
    bool add(image::Image picture, std::filesystem::path file);
    /// Adds a copy of a file that was added before.
    bool addCopy(std::filesystem::path of, std::filesystem::path file);
    /// Waits for all files and returns the errors of at most one file.
    Diagnostics finish();

  private:
    struct Item {
        std::variant<image::Image, std::filesystem::path> content;
        std::filesystem::path file;
    };
    bool wait(Item item);
    bool take(Item& item);
    bool done(const Item& item, Diagnostics problems);
    void run();

    const std::function<void(int)>& written_;
    std::size_t mostThreads_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Item> waiting_;
    std::set<std::filesystem::path> beingWritten_;
    Diagnostics problems_;
    int count_ = 0;
    std::size_t idle_ = 0;  ///< threads waiting for a picture
    bool closed_ = false;
    bool failed_ = false;
    std::vector<std::jthread> threads_;
};

// Encodes pictures as PNG on several threads, and writes them one after the other in their order.

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
