#include "render/file/picture_writer.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <system_error>
#include <utility>

#include "base/parallel.h"
#include "image/file.h"
#include "image/png/png_writer.h"
#include "image/write.h"

namespace glibra::render {

Diagnostics copyFile(const std::filesystem::path& from, const std::filesystem::path& to) {
    const auto bytes = image::readFile(from, {from.generic_string(), {from.generic_string(), 1, 1}});
    if (!bytes) return bytes.diagnostics;
    return image::writeFileAtomically(to, *bytes, image::NamedBy::program);
}

PictureWriter::PictureWriter(const std::function<void(int)>& written, std::size_t mostThreads)
    : written_(written), mostThreads_(base::threadCount(static_cast<int>(mostThreads))) {
    threads_.emplace_back([this] { run(); });
}

bool PictureWriter::add(image::Image picture, std::filesystem::path file) {
    // Each further thread holds one more picture, and as much memory again for encoding it.
    constexpr std::size_t kMostBytes = std::size_t{256} << 20;
    const bool fits = threads_.size() * picture.data.size() <= kMostBytes;
    if (!wait({std::move(picture), std::move(file)})) return false;
    bool isBehind = false;
    {
        const std::scoped_lock lock(mutex_);
        isBehind = waiting_.size() > 1 && idle_ == 0;
    }
    if (!isBehind || !fits || threads_.size() >= mostThreads_) return true;
    try {
        threads_.emplace_back([this] { run(); });
    } catch (const std::system_error&) {
        mostThreads_ = threads_.size();  // the machine gives no more threads
    }
    return true;
}

bool PictureWriter::addCopy(std::filesystem::path of, std::filesystem::path file) {
    return wait({std::move(of), std::move(file)});
}

bool PictureWriter::wait(Item item) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < 2 || failed_; });
    if (failed_) return false;
    waiting_.push_back(std::move(item));
    changed_.notify_all();
    return true;
}

Diagnostics PictureWriter::finish() {
    {
        const std::scoped_lock lock(mutex_);
        closed_ = true;
        changed_.notify_all();
    }
    threads_.clear();
    return std::move(problems_);
}

/// Takes the next item, after the file that it copies is written; false if there is none.
bool PictureWriter::take(Item& item) {
    std::unique_lock lock(mutex_);
    ++idle_;
    changed_.wait(lock, [this] { return !waiting_.empty() || closed_ || failed_; });
    --idle_;
    if (waiting_.empty()) return false;
    item = std::move(waiting_.front());
    waiting_.pop_front();
    beingWritten_.insert(item.file);
    changed_.notify_all();
    if (const auto* of = std::get_if<std::filesystem::path>(&item.content))
        changed_.wait(lock, [this, of] { return !beingWritten_.contains(*of) || failed_; });
    return !failed_;
}

/// Records that an item is done; false if writing more is useless.
bool PictureWriter::done(const Item& item, Diagnostics problems) {
    const std::scoped_lock lock(mutex_);
    beingWritten_.erase(item.file);
    changed_.notify_all();
    if (failed_) return false;
    failed_ = hasError(problems);
    for (Diagnostic& each : problems) {
        // What all frames lose is reported for the first one.
        const bool isKnown = std::ranges::any_of(problems_, [&](const Diagnostic& before) {
            return before.id == each.id && each.severity != Severity::error;
        });
        if (!isKnown) problems_.push_back(std::move(each));
    }
    if (failed_)
        waiting_.clear();
    else
        written_(++count_);
    return !failed_;
}

void PictureWriter::run() {
    // Drawing waits for these files, so they are compressed quickly, each on one thread.
    image::WriteOptions options;
    options.png.level = 0;
    options.png.threads = 1;
    options.named = image::NamedBy::program;  // frames
    Item item;
    while (take(item)) {
        const auto* picture = std::get_if<image::Image>(&item.content);
        Diagnostics problems;
        try {
            problems = picture ? image::writeImage(*picture, item.file, options)
                               : copyFile(std::get<std::filesystem::path>(item.content), item.file);
        } catch (const std::bad_alloc&) {
            problems.push_back(
                diagnose("file-E10", "cannot write '" + item.file.generic_string() + "': not enough memory"));
        }
        if (!done(item, std::move(problems))) return;
    }
}

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
