#include "render/file/picture_stream.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <utility>

#include "base/parallel.h"
#include "image/png/png_writer.h"

namespace glibra::render {

PictureStream::PictureStream(std::function<Diagnostics(const Png&)> write, std::function<void(int)> written)
    : write_(std::move(write)), written_(std::move(written)), thread_([this] { run(); }) {}

PictureStream::~PictureStream() {
    close(false);
}

void PictureStream::close(bool withRest) {
    {
        const std::scoped_lock lock(mutex_);
        closed_ = true;
        if (!withRest) waiting_.clear();
        changed_.notify_all();
    }
    if (thread_.joinable()) thread_.join();
}

bool PictureStream::add(int number, image::Image picture) {
    constexpr std::size_t kMostBytes = std::size_t{256} << 20;
    const std::size_t bytes = std::max<std::size_t>(1, picture.data.size());
    most_ = std::clamp<std::size_t>(kMostBytes / bytes, 1, base::threadCount(0));
    image::PngOptions options;
    if (most_ > 1) options.threads = 1;  // it does not change the bytes
    // Where the machine gives no more threads, the one that writes encodes too.
    last_ =
        std::async(std::launch::async | std::launch::deferred, [options,
                                                                shown = std::make_shared<const image::Image>(
                                                                    std::move(picture))] {
            return image::encodePng(*shown, options);
        }).share();
    return put({number, last_});
}

bool PictureStream::addAgain(int number) {
    return put({number, last_});
}

bool PictureStream::put(Item item) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < most_ || failed_; });
    if (failed_) return false;
    waiting_.push_back(std::move(item));
    changed_.notify_all();
    return true;
}

Diagnostics PictureStream::finish() {
    close(true);
    if (failure_) std::rethrow_exception(failure_);
    return std::move(problems_);
}

void PictureStream::run() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return !waiting_.empty() || closed_; });
        if (waiting_.empty()) return;
        const Item item = waiting_.front();  // it counts until it is written
        lock.unlock();
        Diagnostics problems;
        std::exception_ptr failure;
        try {
            problems = write_(item.png.get());
            if (!hasError(problems)) written_(item.number);
        } catch (...) {
            failure = std::current_exception();
        }
        lock.lock();
        if (!waiting_.empty()) waiting_.pop_front();
        failed_ = failure || hasError(problems);
        problems_ = std::move(problems);
        failure_ = failure;
        changed_.notify_all();
        if (failed_) return;
    }
}

}  // namespace glibra::render
