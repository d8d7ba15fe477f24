// The image module: pictures that libraries of others decode and encode. It is a file of its own, loaded when
// a picture needs it, because linking OpenImageIO costs a process about 100 ms at every start.

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "image/module/codec.h"

namespace glibra::module {
namespace {

int fail(char* message, size_t size, const std::string& text) {
    if (message != nullptr && size > 0) {
        const size_t length = std::min(text.find_first_of("\r\n"), std::min(text.size(), size - 1));
        std::memcpy(message, text.data(), length);
        message[length] = '\0';
    }
    return kGlibraFailed;
}

template <class Request>
int guarded(const Request* request, void (*work)(const Request&)) {
    try {
        work(*request);
        return kGlibraDone;
    } catch (const Failure& failure) {
        return fail(request->message, request->messageSize, failure.text.empty() ? "damaged" : failure.text);
    } catch (const Refused&) {
        return kGlibraRefused;
    } catch (const Unknown&) {
        fail(request->message, request->messageSize, "this build of glibra has no library for the format");
        return kGlibraUnknown;
    } catch (const std::bad_alloc&) {
        return kGlibraRefused;
    } catch (const std::exception& caught) {
        return fail(request->message, request->messageSize, caught.what());
    } catch (...) {
        return fail(request->message, request->messageSize, "unknown error");
    }
}

}  // namespace

void writeFile(const char* path, const std::vector<unsigned char>& bytes) {
    std::FILE* const file = std::fopen(path, "wb");
    if (file == nullptr) throw Failure{std::strerror(errno)};
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const int before = errno;
    if (const bool closed = std::fclose(file) == 0; !written || !closed)
        throw Failure{std::strerror(written ? errno : before)};
}

}  // namespace glibra::module

extern "C" {

int glibraModuleVersion() {
    return kGlibraModuleVersion;
}

int glibraReadPicture(const GlibraReadRequest* request) {
    return glibra::module::guarded(request, glibra::module::codecFor(request->format).read);
}

int glibraWritePicture(const GlibraWriteRequest* request) {
    return glibra::module::guarded(request, glibra::module::codecFor(request->format).write);
}
}
