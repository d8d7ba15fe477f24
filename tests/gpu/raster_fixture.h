#pragma once

#include "fixture.h"
#include "gpu/state/state_tracker.h"

namespace glibra::gpu::test {

/// Leaves raster state as the tests that follow expect it.
class RasterTest : public GpuTest {
  protected:
    void TearDown() override {
        if (GpuTest::HasFatalFailure()) return;
        RasterTracker(driver()).apply({});
        GpuTest::TearDown();
    }
};

}  // namespace glibra::gpu::test
