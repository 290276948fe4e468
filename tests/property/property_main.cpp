// The main of the property tests: seed and number of cases are fixed unless RC_PARAMS says otherwise.
//
// A failure prints the parameters that repeat it. To search longer, from another seed:
//   RC_PARAMS="seed=$RANDOM max_success=5000" build/release/tests/bin/property --gtest_filter='Estimate*'
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cstdlib>

int main(int argc, char** argv) {
  constexpr int keep_what_is_set = 0;
  setenv("RC_PARAMS", "seed=20030601 max_success=500 max_discard_ratio=20", keep_what_is_set);
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
