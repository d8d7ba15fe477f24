#include "base/files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <string>

#include "system/terminal.h"

namespace glibra::base {
namespace {

TEST(StandardFiles, ClosedOnesAreTakenSoThatNothingElseGetsTheirNumbers) {
    for (unsigned closed = 0; closed < 8; ++closed) {
        const pid_t child = ::fork();
        if (child == 0) {
            for (int each = 0; each <= 2; ++each)
                if ((closed >> static_cast<unsigned>(each) & 1U) != 0) ::close(each);
            bool good = system::openStandardFiles();
            for (int each = 0; each <= 2; ++each) {
                good = good && ::fcntl(each, F_GETFD) == 0;
                const bool wasClosed = (closed >> static_cast<unsigned>(each) & 1U) != 0;
                char byte = 0;
                if (wasClosed)  // still no use, as if closed
                    good = good && (each == 0 ? ::read(each, &byte, 1) : ::write(each, &byte, 1)) == -1;
            }
            ::_exit(good ? 0 : 1);
        }
        int status = 0;
        ::waitpid(child, &status, 0);
        EXPECT_EQ(status, 0) << "closed: " << closed;
    }
}

TEST(StandardFiles, OutputThatDoesNotArriveIsReportedAtTheEnd) {
    const struct {
        const char* file;
        int flags;
        bool prints, arrives;
    } cases[] = {{"/dev/null", O_WRONLY, true, true},
                 {"/dev/full", O_WRONLY, true, false},
                 {"/dev/full", O_WRONLY, false, true},
                 {"/dev/null", O_RDONLY, true, false},  // as a closed descriptor becomes
                 {"/dev/null", O_RDONLY, false, true}};
    for (const auto& each : cases)
        for (const std::size_t bytes : {std::size_t{1}, std::size_t{100'000}}) {
            const pid_t child = ::fork();
            if (child == 0) {
                ::dup2(::open(each.file, each.flags), 1);
                const std::string text(bytes, 'x');
                if (each.prints) std::fwrite(text.data(), 1, text.size(), stdout);
                const std::string problem = endStandardOutput();
                ::_exit(problem.empty() == each.arrives ? 0 : 1);
            }
            int status = 0;
            ::waitpid(child, &status, 0);
            EXPECT_EQ(status, 0) << each.file << " " << each.flags << " " << each.prints << " " << bytes;
        }
}

}  // namespace
}  // namespace glibra::base
