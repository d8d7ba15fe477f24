#include "base/standard_files.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace glibra::base {
namespace {

TEST(StandardFiles, ClosedOnesAreTakenSoThatNothingElseGetsTheirNumbers) {
    for (unsigned closed = 0; closed < 8; ++closed) {
        const pid_t child = ::fork();
        if (child == 0) {
            for (int each = 0; each <= 2; ++each)
                if ((closed >> static_cast<unsigned>(each) & 1U) != 0) ::close(each);
            bool good = openStandardFiles();
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

}  // namespace
}  // namespace glibra::base
