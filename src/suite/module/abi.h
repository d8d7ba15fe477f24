#pragma once
// The interface between the program and its module for loopback servers: C functions and plain structs; no
// memory changes its owner, and no exception crosses. The module speaks HTTP and decides nothing: which
// requests are answered is decided by suite/serve/loopback_server.cpp.

#include <stddef.h>

extern "C" {

/// Increased whenever anything below changes. The program rejects a module with another number.
constexpr int kGlibraServerVersion = 1;

struct GlibraText {
    const char* data;
    size_t size;
};

struct GlibraNamedText {
    GlibraText name, value;
};

struct GlibraRequest {
    GlibraText method;  ///< "GET", "POST"
    GlibraText path;    ///< decoded, without the query; begins with '/'
    const GlibraNamedText* headers;
    size_t headerCount;
    const GlibraNamedText* parameters;  ///< of the query, decoded
    size_t parameterCount;
    GlibraText body;  ///< empty before it has been read
};

/// Stores the reply to a request, with its headers. The texts are copied.
using GlibraSendReply = void (*)(void* reply, int status, GlibraText type, const GlibraNamedText* headers,
                                 size_t headerCount, GlibraText body);

/// Both functions may be called by several threads at once, and do not throw.
struct GlibraServerCalls {
    void* context;
    /// Called before the body is read. Returns 0 if the request is to be read and answered; otherwise it has
    /// sent a refusal.
    int (*admit)(void* context, const GlibraRequest* request, void* reply, GlibraSendReply send);
    void (*answer)(void* context, const GlibraRequest* request, void* reply, GlibraSendReply send);
    size_t largestBody;
};

using GlibraServerOpen = void* (*)(const GlibraServerCalls*, int*);
using GlibraServerDo = void (*)(void*);

/// The module's functions, by these names.
int glibraServerVersion();
/// Binds a port of 127.0.0.1 that is free, and stores its number. Null: there is none. `calls` is copied.
void* glibraServerOpen(const GlibraServerCalls* calls, int* port);
/// Answers requests until glibraServerStop() is called by another thread.
void glibraServerRun(void* server);
void glibraServerStop(void* server);
/// Frees the server, which does not run.
void glibraServerClose(void* server);
}
